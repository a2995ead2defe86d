// Cutting the solid in the page: along the sections and in any direction, closed, in every space.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "browser/viewer_page.hpp"

namespace tetloft {
namespace {

class ViewerCut : public test::ViewerPage {
 protected:
  // What is seen of the rectangle [u0, u1] × [v0, v1], in parts of the solid's box, in section s:
  // pixels that show nothing, and the largest difference of their reds.
  struct Face {
    double missing = -1, spread = -1;
  };
  Face face(std::size_t s, const std::array<double, 4>& parts) {
    const test::JsonValue value = evaluate(
        R"((() => {
          const t = window.tetloft, m = t.layers[0], gl = t.drawing.gl, c = t.canvas;
          const span = (axis) => {
            const all = m.arrays.points.filter((_, i) => i % 3 === axis);
            return [Math.min(...all), Math.max(...all)];
          };
          const [x, y, z] = [span(0), span(1), m.sections[)" +
        std::to_string(s) + R"(]];
          t.drawNow();
          const bytes = new Uint8Array(4 * c.width * c.height);
          gl.readPixels(0, 0, c.width, c.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
          const {width, height} = t.size();
          let missing = 0, low = 255, high = 0;
          for (let k = 0; k < 10000; ++k) {
            const u = )" +
        std::to_string(parts[0]) + " + " + std::to_string(parts[1] - parts[0]) +
        R"( * (0.08 + 0.84 * (k % 100) / 99);
            const v = )" +
        std::to_string(parts[2]) + " + " + std::to_string(parts[3] - parts[2]) +
        R"( * (0.08 + 0.84 * Math.floor(k / 100) / 99);
            const q = t.camera.project(m.placed(
              [x[0] + u * (x[1] - x[0]), y[0] + v * (y[1] - y[0]), z], 0, 0));
            const at = 4 * (Math.floor((q[0] / width + 0.5) * c.width) +
                            c.width * Math.floor((q[1] / height + 0.5) * c.height));
            if (bytes[at + 3] !== 255) ++missing;
            low = Math.min(low, bytes[at]);
            high = Math.max(high, bytes[at]);
          }
          return {missing, spread: high - low};
        })())");
    return {value.at("missing").number, value.at("spread").number};
  }

  void expect_uniform(std::size_t s, const std::array<double, 4>& parts) {
    const Face seen = face(s, parts);
    EXPECT_EQ(seen.missing, 0) << s;
    EXPECT_GE(seen.spread, 0) << s;
    EXPECT_LT(seen.spread, 30) << s;
  }

  // Of the cut faces, in the file's unit.
  double cut_area() {
    return number(R"((() => {
      const t = tetloft, part = t.drawing.parts[0];
      t.drawNow();
      let sum = 0;
      const p = part.cut.position, at = (i) => mapped(part.layer.file, [p[i], p[i + 1], p[i + 2]]);
      for (let k = 0; k < p.length; k += 9) {
        sum += Math.hypot(...cross(minus(at(k + 3), at(k)), minus(at(k + 6), at(k)))) / 2;
      }
      return sum;
    })())");
  }
};

TEST_P(ViewerCut, StepsFromSectionToSection) {
  start();
  if (ended()) return;
  RenderOptions options;
  options.title = "</script> & \"title\"";
  options.cut = PictureCut{2, 3};
  show_sample("bifurcation", options);
  if (ended()) return;
  EXPECT_EQ(text_of("title"), options.title);
  const Pixels at_first = pixels();
  const std::string before = text_of("place");
  EXPECT_NE(before.find("z = 3"), std::string::npos) << before;
  EXPECT_NE(after(click("#down")).hash, at_first.hash);
  EXPECT_NE(text_of("place").find("section"), std::string::npos);
  EXPECT_NE(text_of("place"), before);
  act("for (let k = 0; k < 100; ++k) document.querySelector('#up').click();");
  EXPECT_EQ(text_of("place"), "the whole solid");
  EXPECT_GT(pixels().covered, at_first.covered);
  expect_no_errors();
}

// Two boxes, of which one ends above the middle section.
SectionStack two_heights() {
  SectionStack stack;
  for (std::size_t s = 0; s < 5; ++s) {
    Section section{0.3 + 0.7 * static_cast<double>(s), {}};
    section.contours.push_back({{{0, 0}, {1, 0}, {1, 3}, {0, 3}}});
    if (s < 3) section.contours.push_back({{{2, 0}, {3, 0}, {3, 3}, {2, 3}}});
    stack.sections.push_back(section);
  }
  return stack;
}

TEST_P(ViewerCut, FlatFacesHaveNoHolesWholeOrCutInAnySectionInAnySpace) {
  start(1000, 800);
  if (ended()) return;
  RenderOptions options;
  options.contours = false;
  options.elevation = 40;
  const std::array left{0.0, 1.0 / 3, 0.0, 1.0}, right{2.0 / 3, 1.0, 0.0, 1.0};
  for (const Frame& frame : {Frame{}, test::oblique_frame()}) {
    Model model = test::solid_of(two_heights());
    model.frame = frame;
    show(model, options);
    if (ended()) return;
    expect_uniform(4, left);
    for (std::size_t s = 4; s-- > 1;) {
      act(click("#down"));
      expect_uniform(s, left);
      if (s <= 2) expect_uniform(s, right);
      EXPECT_NE(text_of("place").find("section " + std::to_string(s)), std::string::npos);
    }
  }
  expect_no_errors();
}

// The areas of plane cuts of a box 1 × 3 × 2.8 are known.
TEST_P(ViewerCut, IsClosedInEveryDirection) {
  start();
  if (ended()) return;
  for (const Frame& frame :
       {Frame{}, Frame{{Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{1, 0, 0}}, {}}}) {
    Model model = test::solid_of(test::one_box());
    model.frame = frame;
    show(model);
    if (ended()) return;
    const bool turned = !(frame == Frame{});
    // Across x, y, z of the file; sections are across its z, or, exchanged, its x.
    const double x = turned ? 3 : 3 * 2.8, y = turned ? 3 * 2.8 : 2.8, z = turned ? 2.8 : 3;
    act(click("[data-cut=x]"));
    EXPECT_NEAR(cut_area(), x, 1e-3);
    act(click("[data-cut=y]"));
    EXPECT_NEAR(cut_area(), y, 1e-3);
    act(click("[data-cut=z]") + slide("#cut", 330));
    EXPECT_NEAR(cut_area(), z, 1e-3);
    act(click("#flip"));
    EXPECT_NEAR(cut_area(), z, 1e-3);
    act(click("[data-cut=sections]") + slide("#cut", 330));
    EXPECT_NEAR(cut_area(), 3, 1e-3);
    // At 45° between x and y, through the middle: the shorter of the two is 1.
    act("tetloft.cut.point('angles', [1, 1, 0]); tetloft.cut.set((tetloft.cut.low + "
        "tetloft.cut.high) / 2);");
    EXPECT_NEAR(cut_area(), (turned ? 3 : 2.8) * std::sqrt(2.0), 1e-3);
  }
  expect_no_errors();
}

TEST_P(ViewerCut, FacesTheEyeFlipsAndTurnsByAngles) {
  start();
  if (ended()) return;
  show_sample("tooth");
  if (ended()) return;
  const Pixels whole = pixels();
  const Pixels facing = after(click("[data-cut=facing]"));
  EXPECT_NE(facing.hash, whole.hash);
  EXPECT_TRUE(holds("Math.abs(dot(tetloft.cut.normal, tetloft.camera.axes().toward) - 1) < 1e-9"));
  for (int k = 2; k <= 5; ++k) {
    EXPECT_NE(after(click("#colour button:nth-child(" + std::to_string(k) + ')')).hash, facing.hash)
        << "the cut face has the colours of its tets";
  }
  EXPECT_EQ(after(click("#colour button:nth-child(1)")).hash, facing.hash);
  const Pixels flipped = after(click("#flip"));
  EXPECT_NE(flipped.hash, facing.hash);
  EXPECT_EQ(after(click("#flip")).hash, facing.hash);
  EXPECT_NE(after(slide("#cut-turn", 30)).hash, facing.hash);
  EXPECT_NE(after(slide("#cut-tilt", -20)).hash, facing.hash);
  EXPECT_EQ(after(click("#uncut")).hash, whole.hash);
  EXPECT_NE(after(click("#uncut")).hash, whole.hash);
  EXPECT_EQ(after(slide("#cut", 1000)).hash, whole.hash);
  EXPECT_GT(after(slide("#cut", 0)).covered, 0) << "contours stay";
  expect_no_errors();
}

TEST_P(ViewerCut, OfXAndYThePartAwayFromTheEyeStays) {
  start();
  if (ended()) return;
  for (const double azimuth : {0.0, 180.0}) {
    RenderOptions options;
    options.azimuth = azimuth;
    options.cut = PictureCut{0, 0.25};
    show(test::one_box(), Ends::flat, options);
    if (ended()) return;
    EXPECT_TRUE(holds("dot(tetloft.cut.normal, tetloft.camera.axes().toward) > 0.5"));
    EXPECT_NE(text_of("place").find("x = 0.25"), std::string::npos) << text_of("place");
    EXPECT_NEAR(cut_area(), 3 * 2.8, 1e-3);
  }
  expect_no_errors();
}

// A plane that is not across an axis of the file has no one coordinate to be told by.
TEST_P(ViewerCut, TellsACoordinateOnlyWhereItIsThatOfTheWholePlane) {
  start();
  if (ended()) return;
  Model model = test::solid_of(test::one_box());
  const auto chosen = [&] {
    return text("document.querySelector('[data-cut][aria-checked=true]')?.dataset.cut ?? ''");
  };
  RenderOptions options;
  options.cut = PictureCut{0, 0.25};
  // The stack's x is the file's y.
  model.frame = {{Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{1, 0, 0}}, {}};
  show(model, options);
  if (ended()) return;
  EXPECT_NE(text_of("place").find("y = 0.25"), std::string::npos) << text_of("place");
  EXPECT_EQ(chosen(), "y");
  // It is oblique in the file.
  model.frame = test::oblique_frame();
  show(model, options);
  if (ended()) return;
  EXPECT_NE(text_of("place").find("from the middle"), std::string::npos) << text_of("place");
  EXPECT_EQ(chosen(), "");
  act(click("[data-cut=x]"));
  EXPECT_NE(text_of("place").find("x = "), std::string::npos) << text_of("place");
  // Stretched, what is across x on the page is not so in the file.
  options.cut = {};
  options.stretch = 3;
  show(model, options);
  if (ended()) return;
  act(click("[data-cut=x]"));
  EXPECT_NE(text_of("place").find("from the middle"), std::string::npos) << text_of("place");
  act(click("[data-cut=y]"));
  EXPECT_NE(text_of("place").find("y = "), std::string::npos) << text_of("place");
  expect_no_errors();
}

INSTANTIATE_TEST_SUITE_P(Browsers, ViewerCut, test::browsers(), test::browser_name);

}  // namespace
}  // namespace tetloft
