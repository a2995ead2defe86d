// Layered SVG: where heights stand, shapes of every kind, transforms, and what is left out.
#include <gtest/gtest.h>

#include <string>

#include "io/drawing/svg_shapes.hpp"
#include "unit/drawings/stack_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::heights_of;
using test::says;

const std::string kSquare = R"(<polygon points="0,0 4,0 4,4 0,4"/>)";

std::string svg(const std::string& inside) {
  return "<?xml version=\"1.0\"?>\n<!DOCTYPE svg PUBLIC \"x\" \"y\">\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\">\n" +
         inside + "\n</svg>\n";
}
std::string layer(const std::string& attributes, const std::string& shapes = kSquare) {
  return "<g " + attributes + ">" + shapes + "</g>\n";
}

ReadStack read(const std::string& text) {
  Result<ReadStack> stack = parse_stack(text, "a.svg");
  if (!stack) {
    ADD_FAILURE() << to_string(stack.error()) << '\n' << text;
    return {};
  }
  return *std::move(stack);
}

std::string refusal(const std::string& text) { return test::refusal_of(text, {}, "a.svg"); }

// Vertices of the only contour.
std::vector<Point2> contour_of(const std::string& shape,
                               const std::string& attributes = "z=\"1\"") {
  const ReadStack stack = read(svg(layer(attributes, shape)));
  if (stack.stack.contour_count() != 1) return {};
  return stack.stack.sections[SectionId(0)].contours[ContourId(0)].vertices;
}

TEST(Svg, FindsHeightsInAttributesAndNames) {
  const std::vector<std::pair<std::string, double>> forms{
      {R"(id="layer0" slic3r:z="2.25e-06")", 2.25},
      {R"(id="layer0" slic3r:z="1e-06")", 1},
      {R"(id="layer0" slic3r:z="0.35")", 0.35},
      {R"(z="1.25")", 1.25},
      {R"(data-z="-3")", -3},
      {R"(inkscape:groupmode="layer" inkscape:label="z=1.25")", 1.25},
      {R"(inkscape:label="layer 3 z 0.6")", 0.6},
      {R"(inkscape:label="Z: -2 mm" id="g7")", -2},
      {R"(inkscape:label="12.5")", 12.5},
      {R"(id="layer_z0.2")", 0.2}};
  for (const auto& [attributes, height] : forms) {
    EXPECT_EQ(heights_of(read(svg(layer(attributes))).stack), std::vector<double>{height})
        << attributes;
  }
}

TEST(Svg, TakesHeightsOfSlic3rAsTheyStandWhereTheyAreLarge) {
  const ReadStack stack = read(svg(layer(R"(slic3r:z="0.0005")") + layer(R"(slic3r:z="0.3")")));
  EXPECT_EQ(heights_of(stack.stack), (std::vector<double>{0.0005, 0.3}));
}

TEST(Svg, RefusesShapesWithoutHeights) {
  const std::string text = refusal(svg(layer("id=\"layer3\"")));
  EXPECT_NE(text.find("a.svg:4"), std::string::npos) << text;
  EXPECT_NE(text.find("slic3r:z, z and data-z"), std::string::npos) << text;
  const ReadStack stack = read(svg(layer("z=\"1\"") + kSquare));
  EXPECT_TRUE(says(stack.warnings, "a.svg:5: left out: 1 shape outside of any layer"));
}

TEST(Svg, ReadsHolesAndNestedGroups) {
  const ReadStack stack =
      read(svg(layer("slic3r:z=\"1e-06\"",
                     R"(<g><polygon slic3r:type="contour" points="0 0 9 0 9 9 0 9"/></g>)"
                     R"(<polygon slic3r:type="hole" points="1 1 1 2 2 2 2 1"/>)") +
               layer("slic3r:z=\"2e-06\"")));
  EXPECT_EQ(stack.stack.contour_count(), 3U);
  EXPECT_NEAR(test::region_area(stack.stack.sections[SectionId(0)]), 80, 1e-12);
  EXPECT_EQ(stack.stack.about.unit, "mm");
}

TEST(Svg, ReadsPaths) {
  const std::vector<Point2> triangle{{0, 0}, {4, 0}, {4, 3}};
  for (const char* data :
       {"M0 0L4 0L4 3Z", "M 0,0 4,0 4,3 z", "m0 0 4 0 0 3z", "M0 0H4V3Z", "m0 0h4v3z",
        "M0 0 L4 0 L4 3 L0 0", "M0,0L4-0,4+3z", "M.0.0L4e0.0 4 3z"}) {
    EXPECT_EQ(contour_of("<path d=\"" + std::string(data) + "\"/>"), triangle) << data;
  }
  const ReadStack two = read(svg(layer("z=\"1\"", "<path d=\"M0 0h4v4zm9 9h1v1z\"/>")));
  EXPECT_EQ(two.stack.contour_count(), 2U);
  EXPECT_EQ(two.stack.sections[SectionId(0)].contours[ContourId(1)].vertices.front(),
            (Point2{9, 9}));
}

TEST(Svg, FlattensCurvesWithinTheirTolerance) {
  // Quarter circles of radius 1, as four cubics: off by 0.03 % themselves.
  const std::string k = "0.5522847498";
  const std::string l = "0.4477152502";
  const ReadStack stack =
      read(svg(layer("z=\"1\"", "<path d=\"M1 0C1 " + k + " " + k + " 1 0 1S-1 " + k + "-1 0c0-" +
                                    k + " " + l + "-1 1-1s1 " + l + " 1 1z\"/>")));
  ASSERT_EQ(stack.stack.contour_count(), 1U);
  for (const Point2& p : stack.stack.sections[SectionId(0)].contours[ContourId(0)].vertices) {
    EXPECT_NEAR(p.x * p.x + p.y * p.y, 1, 1e-3);
  }
  EXPECT_NEAR(test::region_area(stack.stack.sections[SectionId(0)]), 3.14159, 0.02);
  EXPECT_TRUE(says(stack.warnings, "4 curves are made of line segments"));
  const std::vector<Point2> parabola = contour_of("<path d=\"M0 0Q2 4 4 0T8 0V-9Z\"/>");
  ASSERT_GT(parabola.size(), 10U);
  EXPECT_NE(std::find(parabola.begin(), parabola.end(), Point2{8, 0}), parabola.end());
  EXPECT_NE(refusal(svg(layer("z=\"1\"", "<path d=\"M0 0A1 1 0 0 0 2 2z\"/>")))
                .find("elliptic arcs of paths are not read: convert them to lines (in the layer "
                      "at z 1)"),
            std::string::npos);
}

TEST(Svg, ReadsSimpleShapes) {
  EXPECT_EQ(contour_of(R"(<rect x="1" y="2" width="3" height="4"/>)"),
            (std::vector<Point2>{{1, 2}, {4, 2}, {4, 6}, {1, 6}}));
  const std::vector<Point2> circle = contour_of(R"(<circle cx="1" cy="2" r="5"/>)");
  ASSERT_EQ(circle.size(), 64U);
  for (const Point2& p : circle) {
    EXPECT_NEAR((p.x - 1) * (p.x - 1) + (p.y - 2) * (p.y - 2), 25, 1e-12);
  }
  EXPECT_EQ(contour_of(R"(<polyline points="0 0 1 0 1 1 0 0"/>)").size(), 3U);
  EXPECT_NE(refusal(svg(layer("z=\"1\"", R"(<polyline points="0 0 1 0 1 1"/>)"))).find("open line"),
            std::string::npos);
}

TEST(Svg, AppliesTransforms) {
  const std::string corner = R"(<path d="M1 0h1v1z"/>)";
  const std::vector<std::pair<std::string, std::vector<Point2>>> forms{
      {"translate(10,20)", {{11, 20}, {12, 20}, {12, 21}}},
      {"translate(10)", {{11, 0}, {12, 0}, {12, 1}}},
      {"scale(2) translate(1 0)", {{4, 0}, {6, 0}, {6, 2}}},
      {"scale(1,-1)", {{1, 0}, {2, 0}, {2, -1}}},
      {"matrix(0 1 -1 0 5 6)", {{5, 7}, {5, 8}, {4, 8}}},
      {"rotate(90)", {{0, 1}, {0, 2}, {-1, 2}}},
      {"rotate(-270, 1, 0)", {{1, 0}, {1, 1}, {0, 1}}}};
  for (const auto& [transform, points] : forms) {
    EXPECT_EQ(contour_of(corner, "z=\"1\" transform=\"" + transform + '"'), points) << transform;
    EXPECT_EQ(contour_of("<g transform=\"" + transform + "\">" + corner + "</g>"), points);
  }
  EXPECT_NE(refusal(svg(layer("z=\"1\" transform=\"rotate(30)\""))).find("quarter turns"),
            std::string::npos);
}

TEST(Svg, LeavesOutWhatIsNotDrawn) {
  const ReadStack stack =
      read(svg("<defs><g z=\"9\">" + kSquare + "</g></defs>" + layer("z=\"1\"") +
               layer("z=\"2\" style=\"fill:red; display : none\"") +
               layer("z=\"3\"", "<use href=\"#a\"/>" + kSquare)));
  EXPECT_EQ(heights_of(stack.stack), (std::vector<double>{1, 3}));
  EXPECT_TRUE(says(stack.warnings, "1 hidden"));
  EXPECT_TRUE(says(stack.warnings, "1 elements <use>"));
  EXPECT_TRUE(says(stack.warnings, "mirror image"));
}

TEST(Svg, RefusesWhatIsNone) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {svg(layer("z=\"x\"")), "the height of the layer"},
      {svg(layer("z=\"1\"", R"(<polygon points="0 0 1"/>)")), "odd number"},
      {svg(layer("z=\"1\"", R"(<polygon points="0 a"/>)")), "no numbers"},
      {svg(layer("z=\"1\"", R"(<polygon points="0 1e999"/>)")), "no numbers"},
      {svg(layer("z=\"1\"", R"(<path d="0 0"/>)")), "without a command"},
      {svg(layer("z=\"1\"", R"(<path d="M0"/>)")), "lacks a number"},
      {svg(layer("z=\"1\"", R"(<path d="M0 0X1"/>)")), "unknown path command 'X'"},
      {svg(layer("z=\"1\" transform=\"scale(1e300)\"", R"(<path d="M1e300 0h1v1z"/>)")),
       "too large"},
      {svg("<g z=\"1\">"), "does not close"},
      {"<svg><g z=\"1\">", "its end is missing"}};
  for (const auto& [text, reason] : wrong) {
    EXPECT_NE(refusal(text).find(reason), std::string::npos) << text << '\n' << refusal(text);
  }
}

TEST(Svg, CountsAsAnIndependentReaderDoes) {
  const auto files = test::reference_files("svg");
  if (files.empty()) GTEST_SKIP() << "no files of reference";
  for (const auto& file : files) {
    const Result<FileSummary> summary = inspect(file.string());
    ASSERT_TRUE(summary.ok()) << to_string(summary.error());
    EXPECT_EQ(summary->lines->planes, test::truth_number(file, "layers"));
    EXPECT_EQ(summary->lines->points, test::truth_number(file, "points"));
    EXPECT_EQ(summary->lines->closed,
              test::truth_number(file, "contours") + test::truth_number(file, "holes"));
  }
}

}  // namespace
}  // namespace tetloft
