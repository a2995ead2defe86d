// Keys, help, light and dark, and saved pictures.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "browser/viewer_page.hpp"

namespace tetloft {
namespace {

class ViewerKeys : public test::ViewerPage {};

TEST_P(ViewerKeys, EveryKeyDoesWhatTheHelpSays) {
  start();
  if (ended()) return;
  show_sample("tooth");
  if (ended()) return;
  const Pixels whole = pixels();
  const auto pressed = [&](const std::string& key, bool shift = false) {
    press(key, shift);
    return pixels().hash;
  };
  for (const auto& [key, shift] :
       {std::pair{"ArrowLeft", false}, std::pair{"ArrowUp", false}, std::pair{"ArrowRight", true},
        std::pair{"+", false}, std::pair{"-", false}, std::pair{"1", false}, std::pair{"2", false},
        std::pair{"3", false}, std::pair{"4", false}, std::pair{"5", false},
        std::pair{"6", false}}) {
    EXPECT_NE(pressed(key, shift), whole.hash) << key;
    EXPECT_EQ(pressed("h"), whole.hash) << "the first view again";
  }
  pressed("+");
  EXPECT_EQ(pressed("f"), whole.hash) << "fitted";
  const double cut = pressed("c");
  EXPECT_NE(cut, whole.hash);
  EXPECT_NE(pressed("["), cut);
  EXPECT_NE(pressed("]"), whole.hash);
  for (const auto& [key, mode] : {std::pair{"x", "x"}, std::pair{"y", "y"}, std::pair{"z", "z"},
                                  std::pair{"n", "sections"}, std::pair{"v", "facing"}}) {
    EXPECT_NE(pressed(key), whole.hash) << key;
    EXPECT_EQ(text("tetloft.cut.mode"), mode);
  }
  const double facing = pixels().hash;
  EXPECT_NE(pressed("r"), facing);
  EXPECT_EQ(pressed("c"), whole.hash);
  press("m");
  EXPECT_TRUE(holds("tetloft.measuring"));
  press("Escape");
  EXPECT_FALSE(holds("tetloft.measuring"));
  press(" ");
  EXPECT_TRUE(holds("tetloft.spinning"));
  press(" ");
  EXPECT_FALSE(holds("tetloft.spinning"));
  press("?");
  EXPECT_TRUE(holds("document.getElementById('help').open"));
  EXPECT_TRUE(
      holds("Object.keys(tetloft.keys.acts).length > 20 && "
            "document.querySelectorAll('#keys tr').length > 12"));
  expect_no_errors();
}

TEST_P(ViewerKeys, AFieldKeepsItsLetters) {
  start();
  if (ended()) return;
  show(test::one_box(), Ends::flat);
  if (ended()) return;
  act("document.getElementById('search').hidden = false; document.getElementById('search')"
      ".dispatchEvent(new KeyboardEvent('keydown', {key: 'c', bubbles: true}));");
  EXPECT_FALSE(holds("tetloft.cut.on"));
  expect_no_errors();
}

TEST_P(ViewerKeys, IsLightOrDark) {
  start();
  if (ended()) return;
  show(test::one_box(), Ends::flat);
  if (ended()) return;
  const auto ground = [&] { return text("getComputedStyle(document.body).backgroundColor"); };
  act(click("[data-theme-choice=light]"));
  const std::string light = ground(), bright = browser_->screenshot();
  act(click("[data-theme-choice=dark]"));
  EXPECT_NE(ground(), light);
  EXPECT_NE(browser_->screenshot(), bright);
  EXPECT_EQ(text("document.documentElement.dataset.theme"), "dark");
  press("d");
  EXPECT_EQ(ground(), light);
  act(click("[data-theme-choice=system]"));
  EXPECT_EQ(text("document.documentElement.dataset.theme"),
            text("matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'"));
  expect_no_errors();
}

TEST_P(ViewerKeys, SavesWhatIsSeenWithItsMarksOnTheGroundOfChoice) {
  start();
  if (ended()) return;
  show(test::one_box(), Ends::flat);
  if (ended()) return;
  const Pixels before = pixels();
  const auto painted = [&](const std::string& ground, int times) {
    return evaluate(
        "(() => { document.getElementById('ground').value = " + test::json_quoted(ground) +
        "; const out = tetloft.picture.paint(" + std::to_string(times) + R"();
      const d = out.getContext('2d').getImageData(0, 0, out.width, out.height).data;
      // In the corner nothing is; at the foot on the left the scale bar.
      const bar = out.getContext('2d')
        .getImageData(0, out.height * 0.8, out.width * 0.25, out.height * 0.2).data;
      let dark = 0;
      for (let i = 0; i < bar.length; i += 4) if (bar[i + 3] > 200 && bar[i] < 90) ++dark;
      return {width: out.width, wide: tetloft.size().width, red: d[0], alpha: d[3], dark};
    })())");
  };
  const auto none = painted("none", 1), white = painted("white", 2);
  EXPECT_EQ(none.at("alpha").number, 0);
  EXPECT_EQ(none.at("width").number, none.at("wide").number);
  EXPECT_EQ(white.at("alpha").number, 255);
  EXPECT_EQ(white.at("red").number, 255);
  EXPECT_EQ(white.at("width").number, 2 * white.at("wide").number);
  EXPECT_GT(none.at("dark").number, 20);
  EXPECT_GT(white.at("dark").number, none.at("dark").number);
  EXPECT_EQ(pixels().hash, before.hash) << "the page is as before";
  // The button hands a PNG to the browser.
  act("HTMLAnchorElement.prototype.click = function () { window.saved = this.download + ' ' + "
      "this.href.slice(0, 5); }; document.getElementById('save').click();");
  for (int waited = 0; waited < 100 && text("window.saved ?? ''").empty(); ++waited) pixels();
  EXPECT_EQ(text("window.saved"), "solid.png blob:");
  expect_no_errors();
}

INSTANTIATE_TEST_SUITE_P(Browsers, ViewerKeys, test::browsers(), test::browser_name);

}  // namespace
}  // namespace tetloft
