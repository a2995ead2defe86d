// What lies over a point, and whether a vertical line goes through the void there.
#include "completion/sealed_faces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "completion/void_space.hpp"
#include "core/prng.hpp"
#include "support/exact/predicates.hpp"
#include "unit/completion/void_slab.hpp"

namespace tetloft::testing {
namespace {

// A point off all lines through two of four points is in their hull iff it is in one of the four
// triangles.
bool meets(const Slab& slab, TetId t, const Point2& p) {
  std::array<Point2, 4> q;
  for (int i = 0; i < 4; ++i) {
    const SlabVertexId v = slab.vertex(t, i);
    q[static_cast<std::size_t>(i)] = slab.section_of(v).point(slab.in_section(v));
  }
  for (std::size_t out = 0; out < 4; ++out) {
    const Point2& a = q[(out + 1) % 4];
    const Point2& b = q[(out + 2) % 4];
    const Point2& c = q[(out + 3) % 4];
    const int s = oracle::orient2d(a, b, p);
    if (s != 0 && s == oracle::orient2d(b, c, p) && s == oracle::orient2d(c, a, p)) return true;
  }
  return false;
}

TEST(TetsOver, AreThoseThatAVerticalLineMeets) {
  Prng prng(95);
  std::size_t found = 0;
  for_each_void_slab(2, true, [&](const VoidSlab& s) {
    for (int k = 0; k < 20; ++k) {
      const Point2 p{prng.between(-7, 7), prng.between(-7, 7)};
      std::vector<TetId> expected;
      for (const TetId t : s.slab().tets()) {
        if (meets(s.slab(), t, p)) expected.push_back(t);
      }
      EXPECT_EQ(TetsOver(s.slab())(p), expected);
      found += expected.size();
    }
  });
  EXPECT_GT(found, 1000U);
}

TEST(IsOpen, OverAHoleThroughBothSectionsOnly) {
  const Contour plate = box(-10, -10, 10, 10);
  const auto s = void_slab(
      stack_of_boxes({{plate, box(-6, -3, -2, 3), box(2, -3, 6, 3)}, {plate, box(-6, -3, -2, 3)}}),
      true);
  ASSERT_TRUE(s);
  const VoidSpace space(s->slab(), s->classes(), s->voids, s->completion.complex());
  const auto open = [&](const Point2& p) {
    return is_open(s->slab(), space, TetsOver(s->slab())(p), p);
  };
  EXPECT_TRUE(open({-4.125, 0.25}));
  EXPECT_FALSE(open({4.125, 0.25}));  // ends half way
  EXPECT_FALSE(open({0.125, 0.25}));  // solid
  EXPECT_TRUE(open({30, 30}));        // nothing is there
}

}  // namespace
}  // namespace tetloft::testing
