// Lifting: every child is positive as stored, and every new vertex has left its plane.
#include "subdivision/lifting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <tetloft/predicates.hpp>

#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

void expect_lifted(const SlabCase& c, const Subdivision& subdivision, const Lifting& lifting) {
  const IdVector<NodeId, Point3>& points = lifting.points();
  const std::size_t n = c.slab->vertex_count();
  ASSERT_EQ(points.size(), n + subdivision.lifted.size());
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_EQ(points[NodeId(v)], c.slab->point(SlabVertexId(v)));
  }
  for (const LiftedId k : subdivision.lifted.ids()) {
    const double z = points[NodeId(n + k.index())].z;
    EXPECT_LT(c.lower.z, z);
    EXPECT_LT(z, c.upper.z);
  }
  for (const Child& child : subdivision.children) {
    const auto& [p, q, r, s] = child.node;
    ASSERT_EQ(orient3d(points[p], points[q], points[r], points[s]), Sign::positive);
  }
}

TEST(Lifting, ChildrenArePositiveAndNewVerticesLieBetweenThePlanes) {
  std::size_t lifted = 0;
  for (const NamedSlab& s : generated_slabs(330, 1)) {
    SCOPED_TRACE(s.name);
    Subdivided made = subdivide_case(*s.built);
    Lifting lifting(*s.built->slab, made.subdivision);
    ASSERT_TRUE(lifting.settle(made.rules));
    expect_lifted(*s.built, made.subdivision, lifting);
    EXPECT_GT(lifting.smallest_fraction(), 0);
    EXPECT_LE(lifting.smallest_fraction(), made.subdivision.lifted.empty() ? 1 : 0.5);
    lifted += made.subdivision.lifted.size();
  }
  EXPECT_GT(lifted, 200U);
}

TEST(Lifting, HalvedVerticesAreLowerAndChildrenPositiveAgain) {
  std::size_t halved = 0;
  for (const NamedSlab& s : generated_slabs(331, 1)) {
    SCOPED_TRACE(s.name);
    Subdivided made = subdivide_case(*s.built);
    Lifting lifting(*s.built->slab, made.subdivision);
    ASSERT_TRUE(lifting.settle(made.rules));
    const auto& all = made.subdivision.lifted;
    for (std::size_t k = 0; k < all.size(); k += 1 + all.size() / 3) {
      const LiftedId id(k);
      const NodeId node(s.built->slab->vertex_count() + k);
      const auto height = [&] { return std::abs(lifting.points()[node].z - all[id].base.z); };
      const double before = height();
      if (!lifting.halve(id) || !lifting.settle(made.rules)) break;
      EXPECT_LE(height(), 0.5 * before * (1 + 1e-9));
      expect_lifted(*s.built, made.subdivision, lifting);
      ++halved;
    }
  }
  EXPECT_GT(halved, 25U);
}

TEST(Lifting, EndsBelowTheSmallestLift) {
  const auto c =
      slab_case(stack_of_boxes({{box(0, 0, 4, 4), box(5, 0, 9, 4)}, {box(0, 0, 9, 4)}}), 0);
  Subdivided made = subdivide_case(*c);
  ASSERT_FALSE(made.subdivision.lifted.empty());
  Lifting lifting(*c->slab, made.subdivision);
  ASSERT_TRUE(lifting.settle(made.rules));
  int halvings = 0;
  while (halvings < 100 && lifting.halve(LiftedId(0))) ++halvings;
  EXPECT_GE(halvings, 20);
  EXPECT_LE(halvings, 40);
}

}  // namespace
}  // namespace tetloft::testing
