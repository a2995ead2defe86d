// Picking and measuring in the page: exact points, in the file's space, with unit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "browser/viewer_page.hpp"

namespace tetloft {
namespace {

class ViewerPick : public test::ViewerPage {
 protected:
  // A box in millimetres, somewhere oblique.
  void show_box(double stretch = 1) {
    model_ = test::solid_of(test::one_box());
    model_.frame = test::oblique_frame();
    model_.about = {"Box </script>", "mm", ""};
    RenderOptions options;
    options.stretch = stretch;
    show(model_, options);
  }

  // The point of the stack in own coordinates of the page.
  std::array<double, 3> own(const Point3& p, double stretch = 1) {
    const double unit = number("tetloft.page.length");
    return {(p.x - 0.5) / unit, (p.y - 1.5) / unit, stretch * (p.z - 1.4) / unit};
  }

  // What the card says of it; empty without.
  std::string fact(const std::string& what) {
    return text(
        "[...document.querySelectorAll('#facts div')].find((d) => "
        "d.children[0].textContent === " +
        test::json_quoted(what) + ")?.children[1].textContent ?? ''");
  }

  // The point that was picked, in the file's space.
  Point3 shown_point() {
    Point3 p;
    const std::string of =
        "tetloft.state.picked && mapped(tetloft.layers[0].file, "
        "tetloft.state.picked.own)";
    p.x = number("(" + of + ")[0]");
    p.y = number("(" + of + ")[1]");
    p.z = number("(" + of + ")[2]");
    return p;
  }

  // Whether it splits its tet into four of the same volume together.
  bool the_tet_holds_the_point() {
    return holds(R"((() => {
      const {layer, tet, own} = tetloft.state.picked;
      const p = [0, 1, 2, 3].map((i) => layer.corner(tet, i));
      const volume = (a, b, c, d) => Math.abs(dot(minus(b, a), cross(minus(c, a), minus(d, a))));
      const whole = volume(...p);
      const parts = p.map((_, k) => volume(...p.map((q, i) => (i === k ? own : q))));
      return whole > 0 && Math.abs(parts.reduce((a, b) => a + b) / whole - 1) < 1e-4;
    })())");
  }

  void expect_near(const Point3& a, const Point3& b) {
    EXPECT_NEAR(a.x, b.x, 0.02);
    EXPECT_NEAR(a.y, b.y, 0.02);
    EXPECT_NEAR(a.z, b.z, 0.02);
  }

  Model model_;
};

TEST_P(ViewerPick, TellsWhatLiesThere) {
  start();
  if (ended()) return;
  show_box();
  if (ended()) return;
  EXPECT_TRUE(holds("document.getElementById('card').hidden"));
  const Pixels before = pixels();
  const Point3 on_top{0.4, 1, 2.8}, in_front{0.6, 0, 1.0};
  click_on(own(in_front), 0);
  EXPECT_FALSE(holds("document.getElementById('card').hidden"));
  expect_near(shown_point(), place(model_.frame, in_front));
  EXPECT_EQ(fact("Component"), "Box </script>");
  EXPECT_NE(fact("Slab").find("sections 1 to 2"), std::string::npos) << fact("Slab");
  EXPECT_NE(fact("Point").find("mm"), std::string::npos);
  EXPECT_NE(fact("Point").find("60, "), std::string::npos) << "y of the file: " << fact("Point");
  EXPECT_NE(fact("Kind"), "");
  EXPECT_NE(fact("Evidence"), "");
  const double angle = std::strtod(fact("Dihedral").c_str(), nullptr);
  EXPECT_GT(angle, 0);
  EXPECT_LE(angle, 70.6);
  EXPECT_NE(pixels().hash, before.hash) << "the tet is marked";
  EXPECT_TRUE(the_tet_holds_the_point());

  click_on(own(on_top), 3);
  expect_near(shown_point(), place(model_.frame, on_top));
  EXPECT_NE(fact("Slab").find("section 4"), std::string::npos) << fact("Slab");
  press("Escape");
  EXPECT_TRUE(holds("document.getElementById('card').hidden"));
  EXPECT_EQ(pixels().hash, before.hash);
  click_on({3, 3, 3}, 0);
  EXPECT_TRUE(holds("document.getElementById('card').hidden")) << "nothing is there";
  expect_no_errors();
}

TEST_P(ViewerPick, PicksTheCutFaceAndSlabsThatLieApart) {
  start();
  if (ended()) return;
  show_box();
  if (ended()) return;
  act(slide("#cut", 400));
  const Point3 inside{0.5, 1.2, 0.4 * 2.8};
  click_on(own(inside), 1);
  expect_near(shown_point(), place(model_.frame, inside));
  act(slide("#cut", 1000) + slide("#explode", 1));
  // The wall between slabs, from above, where it lies open.
  const Point3 wall{0.5, 0.3, 0.7};
  click_on(own(wall), 0);
  expect_near(shown_point(), place(model_.frame, wall));
  EXPECT_EQ(number("tetloft.state.picked.slab"), 0);
  expect_no_errors();
}

TEST_P(ViewerPick, MeasuresInTheFilesUnitWhateverIsStretched) {
  start();
  if (ended()) return;
  for (const double stretch : {1.0, 2.0}) {
    show_box(stretch);
    if (ended()) return;
    act(click("#measure"));
    const Point3 a{0.1, 0, 0.2}, b{0.9, 0, 2.5};
    click_on(own(a, stretch), 0);
    EXPECT_NE(fact("Distance").find("second"), std::string::npos);
    click_on(own(b, stretch), 0);
    EXPECT_NEAR(std::strtod(fact("Distance").c_str(), nullptr), std::hypot(0.8, 2.3), 0.03);
    EXPECT_NE(fact("Distance").find("mm"), std::string::npos);
    EXPECT_NE(fact("From"), "");
    EXPECT_NE(fact("To"), "");
    act(slide("#explode", 1));
    EXPECT_NEAR(number("distanceOf(tetloft.ends)"), std::hypot(0.8, 2.3), 0.03);
    act(click("#forget"));
    EXPECT_TRUE(holds("document.getElementById('card').hidden"));
    EXPECT_FALSE(holds("tetloft.measuring"));
  }
  expect_no_errors();
}

// The bar is as long as what it stands for, wherever that lies.
TEST_P(ViewerPick, TheScaleBarIsHonestAndHasTheUnit) {
  start();
  if (ended()) return;
  show_box();
  if (ended()) return;
  double last = 0;
  for (const char* zoom : {"1", "0.31", "0.1", "7"}) {
    act(std::string("tetloft.camera.zoom(") + zoom + "); tetloft.drawNow();");
    const double length = number("tetloft.marks.bar(tetloft.camera).length");
    const double pixels = number("tetloft.marks.bar(tetloft.camera).pixels");
    EXPECT_GT(pixels, 50);
    EXPECT_LE(pixels, 131);
    EXPECT_NE(length, last);
    last = length;
    // 1, 2 or 5 times a power of ten.
    const double digits = length / std::pow(10, std::floor(std::log10(length * (1 + 1e-9))));
    EXPECT_TRUE(std::abs(digits - 1) < 1e-6 || std::abs(digits - 2) < 1e-6 ||
                std::abs(digits - 5) < 1e-6)
        << length;
    // Two points across the picture, one far, one near, that far apart in the file.
    const double seen = number(R"((() => {
      const t = tetloft, {right, toward} = t.camera.axes();
      const one = t.marks.bar(t.camera).length / t.page.length;
      const a = t.camera.project([0.1, 0.2, 0.3]);
      const moved = plus(times(one, right), times(0.7, toward));
      const b = t.camera.project(plus([0.1, 0.2, 0.3], moved));
      return b[0] - a[0];
    })())");
    EXPECT_NEAR(seen, pixels, 1e-6);
    EXPECT_NE(text("tetloft.marks.barText(tetloft.camera)").find("mm"), std::string::npos);
  }
  show_box(3);
  if (ended()) return;
  EXPECT_TRUE(holds("tetloft.marks.barText(tetloft.camera).includes('z \\u00d7 3')"));
  expect_no_errors();
}

INSTANTIATE_TEST_SUITE_P(Browsers, ViewerPick, test::browsers(), test::browser_name);

}  // namespace
}  // namespace tetloft
