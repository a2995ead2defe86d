// What the plots show.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "report/plot.hpp"
#include "unit/report/markup_reader.hpp"

namespace tetloft::internal::report {
namespace {

using test::Element;

const PlotLabels kLabels{"<title>", "x & more", "\"y\""};

Element parsed(const std::string& svg) {
  std::string why;
  const auto element = test::parse_markup(svg, why);
  EXPECT_TRUE(element.has_value()) << why;
  return element.value_or(Element{});
}

TEST(Histogram, BarsAreAsHighAsTheirCounts) {
  const Element svg =
      parsed(histogram_svg({{0, 10, 20, 30, 40}, {5, 0, 10, 20}}, Scale::linear, kLabels));
  const auto bars = svg.all("rect", "bar");
  ASSERT_EQ(bars.size(), 3U);
  const double unit = bars[2]->number("height") / 20;
  EXPECT_GT(unit, 1);
  EXPECT_NEAR(bars[0]->number("height"), 5 * unit, 0.11);
  EXPECT_NEAR(bars[1]->number("height"), 10 * unit, 0.11);
  // On one floor, one behind the other.
  for (const Element* bar : bars) {
    EXPECT_NEAR(bar->number("y") + bar->number("height"),
                bars[0]->number("y") + bars[0]->number("height"), 0.11);
  }
  EXPECT_NEAR(bars[2]->number("x") - bars[1]->number("x"),
              (bars[1]->number("x") - bars[0]->number("x")) / 2, 0.11);
}

TEST(Histogram, NamesAreTextAndNothingElse) {
  const std::string text = histogram_svg({{0, 1}, {1}}, Scale::linear, kLabels);
  const Element svg = parsed(text);
  EXPECT_EQ(svg.children.front().tag, "title");
  EXPECT_EQ(svg.children.front().text, "<title>");
  EXPECT_NE(svg.words().find("x & more"), std::string::npos);
}

TEST(Histogram, OfNothingSaysSo) {
  for (const ReportHistogram& histogram :
       {ReportHistogram{}, ReportHistogram{{0, 1}, {0}}, ReportHistogram{{0, 1}, {1, 2}}}) {
    const Element svg = parsed(histogram_svg(histogram, Scale::logarithmic, kLabels));
    EXPECT_TRUE(svg.all("rect", "bar").empty());
    EXPECT_NE(svg.words().find("nothing to show"), std::string::npos);
  }
}

TEST(Histogram, ShowsTheSmallestCountBesideTheLargest) {
  const Element svg =
      parsed(histogram_svg({{1, 10, 100}, {1, 100000000}}, Scale::logarithmic, kLabels));
  const auto bars = svg.all("rect", "bar");
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_GE(bars[0]->number("height"), 0.5);
  EXPECT_NEAR(bars[0]->number("width"), bars[1]->number("width"), 0.11);
}

TEST(LinePlot, OnLogarithmicScalesEqualRatiosAreEquallyFar) {
  const std::array<Curve, 1> curves{
      {{{{1, 1}, {10, 100}, {100, 10000}, {0, 5}, {5, -1}, {5, 0}}, "given", true}}};
  const Element svg =
      parsed(line_plot_svg(curves, kLabels, {Scale::logarithmic, Scale::logarithmic}));
  const auto dots = svg.all("circle", "given");
  ASSERT_EQ(dots.size(), 3U);  // what is not positive has no place
  for (const char* axis : {"cx", "cy"}) {
    EXPECT_NEAR(dots[1]->number(axis), (dots[0]->number(axis) + dots[2]->number(axis)) / 2, 0.11);
  }
  EXPECT_GT(dots[2]->number("cx"), dots[0]->number("cx"));
  EXPECT_LT(dots[2]->number("cy"), dots[0]->number("cy"));
}

TEST(LinePlot, PutsPointsWhereTheyBelong) {
  const std::array<Curve, 1> curves{{{{{0, 0}, {1, 5}, {2, 10}}, "given", true}}};
  const Element svg = parsed(line_plot_svg(curves, kLabels));
  const auto dots = svg.all("circle", "given");
  ASSERT_EQ(dots.size(), 3U);
  for (const char* axis : {"cx", "cy"}) {
    EXPECT_NEAR(dots[1]->number(axis), (dots[0]->number(axis) + dots[2]->number(axis)) / 2, 0.11);
  }
  EXPECT_GT(dots[2]->number("cx"), dots[0]->number("cx"));
  EXPECT_LT(dots[2]->number("cy"), dots[0]->number("cy"));
}

TEST(LinePlot, TakesExtremeAndMissingValues) {
  const double inf = std::numeric_limits<double>::infinity();
  const double largest = std::numeric_limits<double>::max();
  for (const std::vector<Point2>& points : std::vector<std::vector<Point2>>{
           {{1e-320, 1e-310}, {3e-320, 2e-310}},
           {{-largest, -largest}, {largest, largest}},
           {{1, 1}, {2, inf}, {3, std::numeric_limits<double>::quiet_NaN()}, {4, 2}},
           {{5, 5}}}) {
    const std::array<Curve, 2> curves{{{points, "solid", false}, {points, "given", true}}};
    const std::string text = line_plot_svg(curves, kLabels);
    const Element svg = parsed(text);
    EXPECT_EQ(svg.all("path", "solid").size(), 1U);
    for (const Element* dot : svg.all("circle")) {
      EXPECT_GE(dot->number("cx"), 0);
      EXPECT_LE(dot->number("cx"), kPlotWidth);
      EXPECT_GE(dot->number("cy"), 0);
      EXPECT_LE(dot->number("cy"), kPlotHeight);
    }
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
  }
  EXPECT_NE(line_plot_svg({}, kLabels).find("nothing to show"), std::string::npos);
}

}  // namespace
}  // namespace tetloft::internal::report
