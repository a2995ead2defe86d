#include "between/simplify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "between/chords.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

constexpr double kTurn = 6.283185307179586;

// A circle whose radius goes up and down `waves` times by `height`.
Contour flower(double x, double y, double radius, std::size_t n, int waves = 0, double height = 0) {
  Contour contour;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = kTurn * static_cast<double>(k) / static_cast<double>(n);
    const double r = radius + height * std::cos(angle * waves);
    contour.vertices.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
  }
  return contour;
}

Section section_of(std::vector<Contour> contours) {
  Section section{0.5, {}};
  for (Contour& c : contours) section.contours.push_back(std::move(c));
  return section;
}

bool is_valid(const Section& section) {
  SectionStack stack;
  stack.sections.push_back(section);
  return validate(stack).ok();
}

double to_segment(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double t =
      std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double to_contour(const Point2& p, const Contour& contour) {
  double least = 1e300;
  for (std::size_t v = 0; v < contour.vertices.size(); ++v) {
    least = std::min(least, to_segment(p, contour.vertices[v],
                                       contour.vertices[(v + 1) % contour.vertices.size()]));
  }
  return least;
}

double farthest(const Contour& from, const Contour& to) {
  double most = 0;
  for (const Point2& p : from.vertices) most = std::max(most, to_contour(p, to));
  return most;
}

TEST(Simplify, FewVerticesNearTheContourAroundTheSameArea) {
  const Section section = section_of({flower(0, 0, 10, 400, 5, 2)});
  const auto simplified = simplify(section, 0.05, 1e9);
  ASSERT_TRUE(simplified);
  const Contour& was = section.contours[ContourId(0)];
  const Contour& is = simplified->section.contours[ContourId(0)];
  EXPECT_LT(is.vertices.size(), 80U);
  EXPECT_LT(farthest(was, is), 0.1);
  EXPECT_LT(farthest(is, was), 0.1);
  EXPECT_NEAR(twice_area(is) / twice_area(was), 1, 1e-4);
  EXPECT_EQ(simplified->section.z, 0.5);
}

TEST(Simplify, SmallContoursStay) {
  const Section section = section_of({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, flower(5, 5, 0.01, 30)});
  const auto simplified = simplify(section, 1, 1e9);
  ASSERT_TRUE(simplified);
  EXPECT_EQ(simplified->section.contours[ContourId(0)].vertices,
            section.contours[ContourId(0)].vertices);
  EXPECT_GE(simplified->section.contours[ContourId(1)].vertices.size(), 4U);
  EXPECT_GT(twice_area(simplified->section.contours[ContourId(1)]), 0);
}

TEST(Simplify, NestedContoursNearerThanTheToleranceStayApart) {
  std::vector<Contour> contours;
  for (int k = 0; k < 6; ++k) contours.push_back(flower(0, 0, 10 - 0.02 * k, 300, 7, 1));
  const Section section = section_of(contours);
  ASSERT_TRUE(is_valid(section));
  const auto simplified = simplify(section, 0.3, 1e9);
  ASSERT_TRUE(simplified);
  EXPECT_TRUE(is_valid(simplified->section));
  EXPECT_EQ(simplified->nesting.parent, nest(section).parent);
  EXPECT_EQ(simplified->nesting.region, nest(section).region);
}

TEST(Simplify, OnlyNearWhatIsNearVerticesStay) {
  // Two large discs that come within a fiftieth of the tolerance of each other.
  const Section section = section_of({flower(0, 0, 10, 500), flower(20.005, 0, 10, 500, 0)});
  const auto simplified = simplify(section, 0.25, 1e9);
  ASSERT_TRUE(simplified);
  EXPECT_TRUE(is_valid(simplified->section));
  std::size_t vertices = 0;
  for (const Contour& c : simplified->section.contours) vertices += c.vertices.size();
  EXPECT_LT(vertices, 100U);
}

TEST(Simplify, AnIslandBetweenAContourAndItsChordStaysOutside) {
  // In the bays of the flower lie islands far smaller than the tolerance.
  std::vector<Contour> contours{flower(0, 0, 10, 720, 36, 0.2)};
  for (int k = 0; k < 36; ++k) {
    const double angle = kTurn * (k + 0.5) / 36;
    contours.push_back(flower(9.85 * std::cos(angle), 9.85 * std::sin(angle), 0.02, 8));
  }
  const Section section = section_of(contours);
  ASSERT_TRUE(is_valid(section));
  const Nesting wanted = nest(section);
  ASSERT_EQ(wanted.outer.size(), 37U);
  const auto simplified = simplify(section, 0.5, 1e9);
  ASSERT_TRUE(simplified);
  EXPECT_TRUE(is_valid(simplified->section));
  EXPECT_EQ(simplified->nesting.parent, wanted.parent);
}

TEST(Simplify, InvalidSectionsAreRefused) {
  EXPECT_FALSE(simplify(section_of({flower(0, 0, 10, 100), flower(5, 0, 10, 100)}), 0.1, 1e9));
}

TEST(Simplify, NoContoursAreNoTrouble) {
  const auto simplified = simplify(Section{0.25, {}}, 0.1, 1e9);
  ASSERT_TRUE(simplified);
  EXPECT_TRUE(simplified->section.contours.empty());
}

TEST(Chords, AreDividedUntilAllVerticesAreThere) {
  const Contour was = flower(0, 0, 3, 64);
  ContourChords chords(was, 1, 1e9);
  EXPECT_LT(chords.contour().vertices.size(), 10U);
  for (int round = 0; round < 64; ++round) {
    bool divided = false;
    const std::size_t count = chords.contour().vertices.size();
    for (std::size_t chord = 0; chord < count; ++chord) divided |= chords.divide(chord);
    chords.settle();
    if (!divided) break;
    EXPECT_TRUE(chords.contour().vertices.size() > count || count == was.vertices.size());
  }
  EXPECT_EQ(chords.contour().vertices, was.vertices);
  EXPECT_FALSE(chords.restore());
}

}  // namespace
}  // namespace tetloft::testing
