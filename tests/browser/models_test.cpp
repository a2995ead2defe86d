// Components and models in the page: lists, names, colours, what is shown; bodies and their sides.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "browser/viewer_page.hpp"

namespace tetloft {
namespace {

class ViewerModels : public test::ViewerPage {
 protected:
  double rows() { return number("document.querySelectorAll('#components .component').length"); }
  double shown() { return number("tetloft.current.shown.reduce((a, b) => a + b, 0)"); }
};

// Boxes side by side.
SectionStack many_boxes(std::size_t n) {
  SectionStack stack;
  for (std::size_t s = 0; s < 3; ++s) {
    Section section{1.5 * static_cast<double>(s), {}};
    for (std::size_t k = 0; k < n; ++k) {
      const double x = 2.0 * static_cast<double>(k % 10), y = 2.0 * static_cast<double>(k / 10);
      section.contours.push_back({{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}});
    }
    stack.sections.push_back(section);
  }
  return stack;
}

TEST_P(ViewerModels, ManyComponentsAreFoundHiddenAndShownAlone) {
  start();
  if (ended()) return;
  Model model = test::solid_of(many_boxes(60));
  ASSERT_EQ(model.component_count, 60U);
  const std::string odd = "</script><b>\"Z\xc3\xa4hne\" & 'x'\\n";
  for (std::size_t c = 0; c < 60; ++c) {
    model.component_names.push_back(c == 7 ? odd : "part " + std::to_string(c));
  }
  model.about.unit = "cm";
  show(model);
  if (ended()) return;
  EXPECT_EQ(rows(), 60);
  // Compared there: the tests' own JSON knows no letters beyond ASCII.
  EXPECT_TRUE(holds("document.querySelector('[data-component=\"7\"] .name').textContent === " +
                    test::json_quoted(odd)));
  EXPECT_TRUE(
      holds("document.querySelector('[data-component=\"3\"] .volume').textContent === "
            "'3\\u00a0cm\\u00b3'"));
  const Pixels all = pixels();
  const Pixels less = after(click("[data-component='7'] .component"));
  EXPECT_LT(less.covered, all.covered);
  EXPECT_EQ(shown(), 59);
  EXPECT_EQ(text("document.querySelector('[data-component=\"7\"] .component')"
                 ".getAttribute('aria-pressed')"),
            "false");
  EXPECT_EQ(after(click("[data-component='7'] .component")).hash, all.hash);
  const Pixels alone = after(click("[data-component='7'] .only"));
  EXPECT_EQ(shown(), 1);
  EXPECT_LT(alone.covered, less.covered);
  EXPECT_EQ(after(click("[data-component='7'] .only")).hash, all.hash) << "and back";
  EXPECT_EQ(after(click("#contours") + click("#none")).covered, 0);
  act(click("#contours"));
  EXPECT_EQ(after(click("#all")).hash, all.hash);

  act("const f = document.getElementById('search'); f.value = 'PART 5'; "
      "f.dispatchEvent(new Event('input'));");
  EXPECT_EQ(rows(), 11) << "5 and 50 to 59";
  act("const f = document.getElementById('search'); f.value = 'z\xc3\xa4hne'; "
      "f.dispatchEvent(new Event('input'));");
  EXPECT_EQ(rows(), 1);
  expect_no_errors();
}

TEST_P(ViewerModels, AloneOneComponentNeedsNoSearch) {
  start();
  if (ended()) return;
  show(test::one_box(), Ends::flat);
  if (ended()) return;
  EXPECT_EQ(rows(), 1);
  EXPECT_TRUE(holds("document.getElementById('search').hidden"));
  EXPECT_TRUE(holds("document.getElementById('models').hidden"));
  expect_no_errors();
}

TEST_P(ViewerModels, TwoMethodsLieSideBySideUnderOneCamera) {
  start();
  if (ended()) return;
  const Model a = test::solid_of(many_boxes(4)), b = test::solid_of(many_boxes(4));
  const std::array named{NamedModel{&a, "one <way>"}, NamedModel{&b, "other"}};
  show(named);
  if (ended()) return;
  EXPECT_EQ(text("tetloft.layout"), "side");
  pixels();
  EXPECT_EQ(number("tetloft.panes.length"), 2);
  const Pixels side = pixels();
  const Pixels over = after(click("[data-layout=over]"));
  EXPECT_EQ(number("tetloft.panes.length"), 1);
  EXPECT_NE(over.hash, side.hash);
  EXPECT_EQ(after(click("[data-layout=side]")).hash, side.hash);
  EXPECT_EQ(
      text("[...document.querySelectorAll('#layers .name')].map((n) => n.textContent).join()"),
      "one <way>,other");
  // Each model has its own colours.
  act(click("#layers li:nth-child(2) .name"));
  EXPECT_NE(after(click("#colour button:nth-child(2)")).hash, side.hash);
  EXPECT_EQ(text("tetloft.layers.map((l) => l.colour).join()"), "component,slab");
  EXPECT_EQ(after(click("#colour button:nth-child(1)")).hash, side.hash);
  expect_no_errors();
}

TEST_P(ViewerModels, OverlaidModelsAreHiddenAndGhosts) {
  start();
  if (ended()) return;
  SectionStack inner = test::one_box(), outer = test::one_box();
  for (Section& section : outer.sections) {
    section.z = 3 * section.z - 2;
    section.contours[ContourId(0)] = {{{-2, -2}, {4, -2}, {4, 6}, {-2, 6}}};
  }
  const Model a = test::solid_of(inner), b = test::solid_of(outer);
  const std::array named{NamedModel{&a, "inner"}, NamedModel{&b, "outer"}};
  RenderOptions options;
  options.contours = false;
  show(named, options);
  if (ended()) return;
  EXPECT_EQ(text("tetloft.layout"), "over");
  const Pixels both = pixels();
  const std::string ghost = slide("#layers li:nth-child(2) input[type=range]", 0.3);
  const Pixels seen_through = after(ghost);
  EXPECT_NE(seen_through.hash, both.hash);
  EXPECT_GT(seen_through.colours, both.colours) << "the inner one is seen, too";
  // What is solid is picked before what is a ghost.
  click_on({0, 0, 0}, 0);
  EXPECT_EQ(text("tetloft.state.picked.layer.name"), "inner");
  press("Escape");
  const Pixels inner_alone = after(click("#layers li:nth-child(2) input[type=checkbox]"));
  EXPECT_LT(inner_alone.covered, both.covered / 2);
  EXPECT_EQ(after(click("#layers li:nth-child(1) input[type=checkbox]")).covered, 0);
  // Contours alone.
  act(click("#layers li:nth-child(1) input[type=checkbox]") + click("#contours"));
  const Pixels lines = after(slide("#layers li:nth-child(1) input[type=range]", 0));
  EXPECT_GT(lines.covered, 0);
  EXPECT_LT(lines.covered, inner_alone.covered);
  expect_no_errors();
}

TEST_P(ViewerModels, ABodyHasItsSides) {
  start();
  if (ended()) return;
  // Left is +x and posterior +y in one, and the other way round in the other.
  for (const auto& [orientation, sign] : {std::pair{"LPS", 1.0}, std::pair{"RAS", -1.0}}) {
    Model model = test::solid_of(test::one_box());
    model.frame = test::oblique_frame();
    model.about = {"", "mm", orientation};
    show(model);
    if (ended()) return;
    EXPECT_EQ(text("tetloft.marks.letters.map((p) => p.join('')).join()"),
              sign > 0 ? "LR,PA,SI" : "RL,AP,SI");
    const auto toward = [&](const char* name, int axis) {
      act(std::string("[...document.querySelectorAll('#views button')].find((b) => b.textContent "
                      "=== '") +
          name + "').click();");
      return number("tetloft.camera.axes().toward[" + std::to_string(axis) + "]");
    };
    EXPECT_NEAR(toward("left", 0), sign, 1e-9);
    EXPECT_NEAR(toward("right", 0), -sign, 1e-9);
    EXPECT_NEAR(toward("anterior", 1), -sign, 1e-9);
    EXPECT_NEAR(toward("posterior", 1), sign, 1e-9);
    EXPECT_NEAR(toward("superior", 2), 1, 1e-9);
    EXPECT_NEAR(toward("inferior", 2), -1, 1e-9);
  }
  Model model = test::solid_of(test::one_box());
  model.about.orientation = "odd";
  show(model);
  if (ended()) return;
  EXPECT_EQ(text("tetloft.marks.letters.map((p) => p.join('')).join()"), "x,y,z");
  expect_no_errors();
}

INSTANTIATE_TEST_SUITE_P(Browsers, ViewerModels, test::browsers(), test::browser_name);

}  // namespace
}  // namespace tetloft
