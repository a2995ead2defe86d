// Cuts in tets about as thin as the spacing of doubles find room.
#include "subdivision/cut_squeezing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <tetloft/predicates.hpp>

#include "subdivision/trimming.hpp"
#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

std::vector<std::size_t> not_positive(const Truncation& truncation,
                                      const IdVector<NodeId, Point3>& points) {
  std::vector<std::size_t> bad;
  for (std::size_t k = 0; k < truncation.pieces.size(); ++k) {
    const auto& [a, b, c, d] = truncation.pieces[k].node;
    if (orient3d(points[a], points[b], points[c], points[d]) != Sign::positive) bad.push_back(k);
  }
  return bad;
}

TEST(SqueezeCuts, MakesPiecesPositiveByMovingCutsAlone) {
  std::size_t squeezed = 0;
  const SectionStack stack = sample("cases/parallel_cuts.cnt");
  for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
    const auto c = slab_case(stack, k);
    if (!c) continue;
    Subdivided made = subdivide_case(*c);
    Lifting lifting(*c->slab, made.subdivision);
    ASSERT_TRUE(lifting.settle(made.rules));
    const Truncation truncation =
        truncate(*c->slab, *c->classes, made.complex, made.subdivision,
                 choose_trimmed(*c->slab, *c->classes, made.complex, made.subdivision, lifting));
    IdVector<NodeId, Point3> points = lifting.points();
    for (const Cut& cut : truncation.cuts) {
      points.push_back(place_cut(cut, points[cut.kept], points[cut.away], c->slab->gap()));
    }
    const IdVector<NodeId, Point3> before = points;
    const std::vector<std::size_t> bad = not_positive(truncation, points);
    squeeze_cuts(points, *c->classes, made.subdivision, truncation, bad,
                 {std::nextafter(c->lower.z, HUGE_VAL), std::nextafter(c->upper.z, -HUGE_VAL)});
    squeezed += bad.size();
    EXPECT_TRUE(not_positive(truncation, points).empty());
    for (const NodeId n : points.ids()) {
      if (n.index() < lifting.points().size()) {
        EXPECT_EQ(points[n], before[n]);
      } else {
        EXPECT_LT(c->lower.z, points[n].z);
        EXPECT_LT(points[n].z, c->upper.z);
      }
    }
  }
  EXPECT_GT(squeezed, 0U);
}

}  // namespace
}  // namespace tetloft::testing
