// The points on the border of each face, against pixels.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include <tetloft/sections.hpp>

#include "core/prng.hpp"
#include "sections/face_overlay.hpp"
#include "support/stacks/bitmap.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

using namespace internal::sections;

using Points = std::set<std::pair<double, double>>;

Points border_of(const FaceOverlay& overlay, FaceId f) {
  Points points;
  for (const Point2& p : overlay.border_points(f)) points.emplace(p.x, p.y);
  return points;
}

Section section_of(const Bitmap& bitmap) {
  Section section;
  for (Contour& contour : staircase(bitmap, true)) section.contours.push_back(std::move(contour));
  return section;
}

// What a bitmap's outline does at a lattice point: nothing, on straight, or turn.
enum class Passes { not_at_all, horizontally, vertically, round_a_corner };

Passes outline_at(const Bitmap& bitmap, int x, int y) {
  const bool a = bitmap.at(x - 1, y - 1);
  const bool b = bitmap.at(x, y - 1);
  const bool c = bitmap.at(x - 1, y);
  const bool d = bitmap.at(x, y);
  if (a == b && b == c && c == d) return Passes::not_at_all;
  if (a == b && c == d) return Passes::horizontally;
  if (a == c && b == d) return Passes::vertically;
  return Passes::round_a_corner;
}

// Vertices of either outline, and where they cross.
bool is_node(const Bitmap& lower, const Bitmap& upper, int x, int y) {
  const Passes below = outline_at(lower, x, y);
  const Passes above = outline_at(upper, x, y);
  if (below == Passes::round_a_corner || above == Passes::round_a_corner) return true;
  return below != Passes::not_at_all && above != Passes::not_at_all && below != above;
}

TEST(BorderPoints, AreThoseOfPixels) {
  Prng prng(61);
  constexpr int kSize = 6;
  std::size_t points = 0;
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    const auto draw = [&] {
      return without_diagonals(random_bitmap(prng, kSize, kSize, prng.between(0.3, 0.8), 0));
    };
    const Bitmap lower = draw();
    const Bitmap upper = draw();
    const Section below = section_of(lower);
    const Section above = section_of(upper);
    const FaceOverlay overlay(below, nest(below), above, nest(above));
    std::map<FaceId, Points> expected;
    for (const FaceId f : overlay.faces().ids()) expected[f];
    for (int x = 0; x <= kSize; ++x) {
      for (int y = 0; y <= kSize; ++y) {
        if (!is_node(lower, upper, x, y)) continue;
        for (const auto& [dx, dy] : {std::pair{-1, -1}, {0, -1}, {-1, 0}, {0, 0}}) {
          const FaceId f = overlay.locate({x + dx + 0.5, y + dy + 0.5});
          ASSERT_TRUE(f.valid());
          expected[f].emplace(x, y);
        }
      }
    }
    for (const FaceId f : overlay.faces().ids()) {
      EXPECT_EQ(border_of(overlay, f), expected[f]);
      points += expected[f].size();
    }
  }
  EXPECT_GT(points, 10000U);
}

// All nodes of a contour on one of its edges: between the last and the first lies the rest of it.
TEST(BorderPoints, OfAContourThatIsCrossedOnOneEdge) {
  const Section below = section(0, {rectangle(0, 0, 10, 10)});
  const Section above = section(1, {rectangle(4, -2, 6, 2)});
  const FaceOverlay overlay(below, nest(below), above, nest(above));
  EXPECT_EQ(border_of(overlay, overlay.locate({5, 1})), (Points{{4, 0}, {6, 0}, {6, 2}, {4, 2}}));
  EXPECT_EQ(border_of(overlay, overlay.locate({5, -1})),
            (Points{{4, -2}, {6, -2}, {6, 0}, {4, 0}}));
  EXPECT_EQ(border_of(overlay, overlay.locate({5, 5})),
            (Points{{0, 0}, {4, 0}, {4, 2}, {6, 2}, {6, 0}, {10, 0}, {10, 10}, {0, 10}}));
}

}  // namespace
}  // namespace tetloft::testing
