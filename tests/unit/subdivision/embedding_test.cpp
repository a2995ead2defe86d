// Embedding and the squeezing of cuts: pieces are positive, and none overlaps another.
#include "subdivision/embedding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <tetloft/predicates.hpp>

#include "subdivision/trimming.hpp"
#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

struct Embedded {
  IdVector<NodeId, Point3> points;
  std::vector<PointOrigin> origin;
  std::vector<Piece> pieces;
  std::size_t lifted = 0;
  std::size_t cuts = 0;
};

// All steps; lone classes end in prisms as long as there is room.
std::optional<Embedded> embed(const SlabCase& c) {
  std::vector<LoneEnd> lone;
  for (std::size_t k = 0; k < c.classes->class_count(); ++k) {
    const ClassId id(k);
    if (c.classes->is_lone(id)) lone.push_back({id, c.classes->regions(id).front()});
  }
  for (;;) {
    RuleCounts rules{};
    IdVector<ClassId, std::uint8_t> active(c.classes->class_count(), 1);
    for (const LoneEnd& end : lone) active[end.id] = end.is_prism() ? 0 : 1;
    Completion completion(*c.slab, *c.classes, active, seed(*c.slab, *c.classes, active, rules),
                          rules);
    if (!completion.run().empty()) return std::nullopt;
    const Complex& complex = completion.complex();
    const Subdivision subdivision = subdivide(*c.slab, *c.classes, complex, rules);
    Lifting lifting(*c.slab, subdivision);
    if (!lifting.settle(rules)) return std::nullopt;
    Truncation truncation =
        truncate(*c.slab, *c.classes, complex, subdivision,
                 choose_trimmed(*c.slab, *c.classes, complex, subdivision, lifting));
    Embedding embedding(*c.slab, *c.classes, complex, subdivision, lifting, truncation, lone,
                        rules);
    const Embedding::Outcome outcome = embedding.settle();
    if (outcome == Embedding::Outcome::more_truncated) continue;
    if (outcome == Embedding::Outcome::failed) return std::nullopt;
    Embedded result{embedding.points(),
                    {},
                    embedding.all_pieces(),
                    subdivision.lifted.size(),
                    truncation.cuts.size()};
    for (std::size_t n = c.slab->vertex_count(); n < result.points.size(); ++n) {
      result.origin.push_back(embedding.origin(NodeId(n)));
    }
    return result;
  }
}

std::array<Point3, 4> corners(const Embedded& e, const Piece& piece) {
  return {e.points[piece.node[0]], e.points[piece.node[1]], e.points[piece.node[2]],
          e.points[piece.node[3]]};
}

bool contains(const std::array<Point3, 4>& t, const Point3& p) {
  return orient3d(p, t[1], t[2], t[3]) == Sign::positive &&
         orient3d(t[0], p, t[2], t[3]) == Sign::positive &&
         orient3d(t[0], t[1], p, t[3]) == Sign::positive &&
         orient3d(t[0], t[1], t[2], p) == Sign::positive;
}

// Barycentres and points near corners, so that overlaps are met that are less than half a piece.
std::vector<Point3> points_inside(const std::array<Point3, 4>& t) {
  std::vector<Point3> result;
  for (std::size_t heavy = 0; heavy < 5; ++heavy) {
    Point3 p{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
      const double w = heavy == 4 ? 0.25 : heavy == i ? 0.97 : 0.01;
      p = {p.x + w * t.at(i).x, p.y + w * t.at(i).y, p.z + w * t.at(i).z};
    }
    result.push_back(p);
  }
  return result;
}

TEST(Embedding, PiecesArePositiveAndOverlapNowhere) {
  std::size_t solids = 0;
  for (const NamedSlab& s : generated_slabs(350, 1)) {
    SCOPED_TRACE(s.name);
    const std::optional<Embedded> e = embed(*s.built);
    if (!e) continue;
    std::vector<std::array<Point3, 4>> tets;
    for (const Piece& piece : e->pieces) {
      tets.push_back(corners(*e, piece));
      const auto& [p, q, r, t] = tets.back();
      ASSERT_EQ(orient3d(p, q, r, t), Sign::positive);
    }
    if (tets.size() > 600) continue;
    ++solids;
    for (std::size_t k = 0; k < tets.size(); ++k) {
      for (const Point3& p : points_inside(tets[k])) {
        for (std::size_t l = 0; l < tets.size(); ++l) {
          const bool twice = l != k && contains(tets[l], p) && contains(tets[k], p);
          ASSERT_FALSE(twice) << k << ' ' << l;
        }
      }
    }
  }
  EXPECT_GT(solids, 20U);
}

TEST(Embedding, ConstructedNodesAreLiftedThenCutsThenCaps) {
  bool all[3] = {};
  for (const NamedSlab& s : generated_slabs(351, 1)) {
    SCOPED_TRACE(s.name);
    const std::optional<Embedded> e = embed(*s.built);
    if (!e) continue;
    for (std::size_t k = 0; k < s.built->slab->vertex_count(); ++k) {
      EXPECT_EQ(e->points[NodeId(k)], s.built->slab->point(SlabVertexId(k)));
    }
    for (std::size_t k = 0; k < e->origin.size(); ++k) {
      const std::size_t kind = k < e->lifted ? 0 : k < e->lifted + e->cuts ? 1 : 2;
      constexpr PointOrigin kOrigin[] = {PointOrigin::lifted, PointOrigin::cut, PointOrigin::cap};
      EXPECT_EQ(e->origin[k], kOrigin[kind]);
      all[kind] = true;
    }
  }
  EXPECT_TRUE(all[0] && all[1] && all[2]);
}

// Two regions one over the other, kept apart: their prisms would meet half way, were they as high
// as half the gap each.
TEST(Embedding, PrismsThatWouldMeetGetLower) {
  const auto c = slab_case(stack_of_boxes({{box(0, 0, 4, 4)}, {box(1, 1, 3, 3)}}), 0, {});
  const std::optional<Embedded> e = embed(*c);
  ASSERT_TRUE(e);
  double below = 0;
  double above = 1;
  for (const Piece& piece : e->pieces) {
    ASSERT_EQ(piece.kind, TetKind::prism);
    for (const NodeId n : piece.node) {
      const double z = e->points[n].z;
      const bool lower = piece.region == SlabRegionId(0);
      (lower ? below : above) = lower ? std::max(below, z) : std::min(above, z);
    }
  }
  EXPECT_GT(below, 0);
  EXPECT_LT(above, 1);
  EXPECT_LT(below, above);
}

}  // namespace
}  // namespace tetloft::testing
