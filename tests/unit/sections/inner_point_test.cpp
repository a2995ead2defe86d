// A point inside each face, whatever it looks like.
#include "sections/inner_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include <tetloft/sections.hpp>

#include "support/overlay_oracle.hpp"
#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

using namespace internal::sections;
using oracle::CellOverlay;

FaceOverlay overlay_of(const Section& lower, const Section& upper) {
  return {lower, nest(lower), upper, nest(upper)};
}

FaceId only_face(const FaceOverlay& overlay, bool lower, bool upper) {
  FaceId found;
  for (const FaceId f : overlay.faces().ids()) {
    const OverlayFace& face = overlay.faces()[f];
    if (f == kUnboundedFace || face.lower.solid != lower || face.upper.solid != upper) continue;
    EXPECT_FALSE(found.valid());
    found = f;
  }
  return found;
}

TEST(InnerPoint, LiesInItsFace) {
  std::size_t faces = 0;
  std::size_t without = 0;
  for (const StackKind kind : all_kinds()) {
    if (is_near_coincident(kind) || kind == StackKind::large_contours ||
        kind == StackKind::nested_ngons || kind == StackKind::islands)
      continue;
    for (std::uint64_t seed = 81; seed < 83; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const SectionStack stack = generate(kind, seed).stack;
      const Section& lower = stack.sections[SectionId(0)];
      const Section& upper = stack.sections[SectionId(1)];
      if (stack.vertex_count() > 60) continue;  // the oracle is slow
      const FaceOverlay overlay = overlay_of(lower, upper);
      const CellOverlay cells(lower, nest(lower), upper, nest(upper));
      for (const FaceId f : overlay.faces().ids()) {
        if (f == kUnboundedFace) continue;
        ++faces;
        const std::optional<Point2> p = inner_point(overlay, f);
        if (!p) {
          ++without;
          continue;
        }
        EXPECT_EQ(overlay.locate(*p), f);
        const auto cell = cells.locate(*p);
        ASSERT_TRUE(cell);
        const OverlayFace& face = overlay.faces()[f];
        EXPECT_EQ(cells.faces()[*cell].side[0].solid, face.lower.solid);
        EXPECT_EQ(cells.faces()[*cell].side[1].solid, face.upper.solid);
        EXPECT_EQ(cells.faces()[*cell].chi, face.chi);
      }
    }
  }
  EXPECT_GT(faces, 120U);
  EXPECT_LT(without, faces / 50);
}

TEST(InnerPoint, LiesWellInside) {
  // Over a hole of 10 × 10, and between two rings.
  const FaceOverlay square =
      overlay_of(section(0, {rectangle(-20, -20, 20, 20)}), section(1, {rectangle(-5, -5, 5, 5)}));
  const auto p = inner_point(square, only_face(square, true, true));
  ASSERT_TRUE(p);
  EXPECT_LT(std::max(std::abs(p->x), std::abs(p->y)), 3);
  const FaceOverlay ring = overlay_of(
      section(0, {rectangle(-20, -20, 20, 20), rectangle(-8, -8, 8, 8)}),
      section(1, {rectangle(-20, -20, 20, 20), rectangle(-8, -8, 8, 8), rectangle(-4, -4, 4, 4)}));
  const auto q = inner_point(ring, only_face(ring, false, false));
  ASSERT_TRUE(q);
  const double far = std::max(std::abs(q->x), std::abs(q->y));
  EXPECT_GT(far, 5);
  EXPECT_LT(far, 7);
}

TEST(InnerPoint, DoesNotDependOnOrderOfContours) {
  const std::vector<Contour> contours{rectangle(-20, -20, 20, 20), rectangle(-8, -8, -2, 8),
                                      rectangle(2, -8, 8, 8)};
  const Section upper = section(1, {rectangle(-15, -5, 15, 5)});
  const FaceOverlay one = overlay_of(section(0, contours), upper);
  const FaceOverlay other = overlay_of(
      section(0, {reversed(contours[2]), rotated(contours[0], 1), rotated(contours[1], 3)}), upper);
  ASSERT_EQ(one.faces().size(), other.faces().size());
  for (const FaceId f : one.faces().ids()) {
    if (f == kUnboundedFace) continue;
    const auto p = inner_point(one, f);
    const auto q = inner_point(other, f);
    ASSERT_TRUE(p && q);
    EXPECT_TRUE(p->x == q->x && p->y == q->y);
  }
}

}  // namespace
}  // namespace tetloft::testing
