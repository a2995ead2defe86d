// The viewer's page in real browsers: no errors, a picture, and controls that change it.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <tetloft/tetloft.hpp>

#include "browser/browser.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {
namespace {

using test::Browser;
using test::JsonValue;

const std::string kData = TETLOFT_DATA_DIR;

class Viewer : public ::testing::TestWithParam<const char*> {
 protected:
  // Skips where the browser is not there.
  bool start() {
    const bool firefox = GetParam() == std::string("firefox");
    const auto found = test::find_program(
        firefox ? std::vector<std::string>{"firefox", "firefox-esr"}
                : std::vector<std::string>{"chromium", "chromium-browser", "google-chrome"});
    if (!found) return false;
    browser_ = firefox ? test::start_firefox() : test::start_chromium();
    EXPECT_NE(browser_, nullptr) << "installed, but does not start";
    return browser_ != nullptr;
  }

  // Opens the page of a sample of data/ and waits for the viewer.
  void show(const std::string& sample, const RenderOptions& options = {}) {
    const auto input = read_cnt(kData + '/' + sample + ".cnt");
    ASSERT_TRUE(input);
    ReconstructOptions half;
    half.ends = Ends::half;
    const auto solid = reconstruct(input->stack, half);
    ASSERT_TRUE(solid);
    const auto page = render_html(solid->model, &input->stack, options);
    ASSERT_TRUE(page);
    ASSERT_TRUE(write_file(folder_.file("page.html"), *page));
    browser_->open("file://" + folder_.file("page.html"));
    for (int waited = 0; waited < 600; ++waited) {
      const std::string message =
          browser_->evaluate("document.getElementById('message')?.textContent").string;
      if (message.find("WebGL") != std::string::npos) GTEST_SKIP() << message;
      if (browser_->evaluate("Boolean(window.tetloft)").boolean) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    ASSERT_TRUE(browser_->evaluate("Boolean(window.tetloft)").boolean);
  }

  struct Pixels {
    double covered = 0, colours = 0, hash = 0;
  };
  Pixels pixels() {
    const JsonValue value = browser_->evaluate("window.tetloft.pixels()");
    return {value.at("covered").number, value.at("colours").number, value.at("hash").number};
  }

  // Does something in the page; the picture that follows.
  Pixels after(const std::string& action) {
    browser_->evaluate("(() => { " + action + " })()");
    return pixels();
  }

  static std::string slide(const std::string& id, double value) {
    return "const s = document.getElementById('" + id + "'); s.value = " + std::to_string(value) +
           "; s.dispatchEvent(new Event('input'));";
  }
  static std::string click(const std::string& selector) {
    return "document.querySelector(" + test::json_quoted(selector) + ").click();";
  }

  void expect_no_errors() {
    for (const std::string& error : browser_->errors()) ADD_FAILURE() << error;
  }

  test::TempFolder folder_;
  std::unique_ptr<Browser> browser_;
};

TEST_P(Viewer, ShowsTheSolidAndEveryControlChangesThePicture) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  show("tooth");
  if (IsSkipped() || HasFatalFailure()) return;
  const Pixels whole = pixels();
  EXPECT_GT(whole.covered, 0.05);
  EXPECT_LT(whole.covered, 0.9);
  EXPECT_GT(whole.colours, 50);
  EXPECT_EQ(pixels().hash, whole.hash) << "the same view is the same picture";
  const std::string shown = browser_->screenshot();

  const Pixels cut = after(slide("cut", 500));
  EXPECT_NE(cut.hash, whole.hash);
  EXPECT_NE(browser_->evaluate("document.getElementById('place').textContent").string,
            "the whole solid");
  EXPECT_NE(browser_->screenshot(), shown);
  EXPECT_EQ(after(slide("cut", 1000)).hash, whole.hash) << "and back";

  for (const char* box : {"#contours", "#edges", "#smooth"}) {
    EXPECT_NE(after(click(box)).hash, whole.hash) << box;
    EXPECT_EQ(after(click(box)).hash, whole.hash) << box;
  }
  for (int k = 2; k <= 4; ++k) {
    const std::string button = "#colour button:nth-child(" + std::to_string(k) + ')';
    EXPECT_NE(after(click(button)).hash, whole.hash) << button;
  }
  EXPECT_EQ(after(click("#colour button:nth-child(1)")).hash, whole.hash);
  EXPECT_NE(after(slide("explode", 1)).hash, whole.hash);
  after(slide("explode", 0));
  EXPECT_NE(after(click("[data-view='-90 90']")).hash, whole.hash);
  EXPECT_EQ(after(click("[data-view='-60 25']")).hash, whole.hash);
  expect_no_errors();
}

TEST_P(Viewer, TurnsAndMovesWithThePointer) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  show("torus");
  if (IsSkipped() || HasFatalFailure()) return;
  const Pixels whole = pixels();
  const auto drag = [](const std::string& modifier) {
    return "const c = document.getElementById('picture'); c.setPointerCapture = () => {};"
           "const send = (n, x, y) => c.dispatchEvent(new PointerEvent(n, {pointerId: 1, buttons: "
           "1,"
           " clientX: x, clientY: y, " +
           modifier +
           "}));"
           "send('pointerdown', 500, 300); send('pointermove', 560, 340); send('pointerup', 560, "
           "340);";
  };
  const Pixels turned = after(drag("shiftKey: false"));
  EXPECT_NE(turned.hash, whole.hash);
  const Pixels moved = after(drag("shiftKey: true"));
  EXPECT_NE(moved.hash, turned.hash);
  EXPECT_GT(moved.covered, 0.02);
  const Pixels nearer = after(
      "document.getElementById('picture').dispatchEvent(new WheelEvent('wheel', {deltaY: -300}));");
  EXPECT_GT(nearer.covered, moved.covered);
  EXPECT_EQ(
      after("document.getElementById('picture').dispatchEvent(new MouseEvent('dblclick'));").hash,
      whole.hash);
  expect_no_errors();
}

TEST_P(Viewer, StepsFromSectionToSectionAndHidesComponents) {
  if (!start()) GTEST_SKIP() << "no " << GetParam();
  RenderOptions options;
  options.title = "</script> & \"title\"";
  options.cut = PictureCut{2, 3};
  show("bifurcation", options);
  if (IsSkipped() || HasFatalFailure()) return;
  EXPECT_EQ(browser_->evaluate("document.getElementById('title').textContent").string,
            options.title);
  const Pixels at_first = pixels();
  const auto place = [&] {
    return browser_->evaluate("document.getElementById('place').textContent").string;
  };
  const std::string before = place();
  EXPECT_NE(after(click("#down")).hash, at_first.hash);
  EXPECT_NE(place().find("section"), std::string::npos);
  EXPECT_NE(place(), before);
  browser_->evaluate(
      "(() => { for (let k = 0; k < 100; ++k) document.querySelector('#up').click(); })()");
  EXPECT_EQ(place(), "the whole solid");
  EXPECT_GT(pixels().covered, at_first.covered);
  EXPECT_EQ(after(click("#contours") + click("#legend button")).covered, 0);
  expect_no_errors();
}

INSTANTIATE_TEST_SUITE_P(Browsers, Viewer, ::testing::Values("chromium", "firefox"),
                         [](const auto& with) { return std::string(with.param); });

}  // namespace
}  // namespace tetloft
