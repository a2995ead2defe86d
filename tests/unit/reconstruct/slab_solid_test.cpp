// The solid of one slab, and why there may be none.
#include "reconstruct/slab_solid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <variant>
#include <vector>

#include <tetloft/predicates.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

struct Sections {
  ConformingSection lower, upper;
};

Sections conformed(const SectionStack& stack, bool gabriel = false) {
  const auto make = [&](SectionId s) {
    const Section& section = stack.sections[s];
    return conform(section, s,
                   {.gabriel = IdVector<ContourId, bool>(section.contours.size(), gabriel)})
        .value();
  };
  return {make(SectionId(0)), make(SectionId(1))};
}

SlabOutcome outcome_of(const Sections& s, const std::vector<Link>& links,
                       DelaunayEngine engine = DelaunayEngine::automatic) {
  return build_slab(SlabId(0), s.lower, s.upper, links, nullptr, {engine, kDefaultWorkLimit})
      .value();
}

Link link(std::size_t lower, std::size_t upper) {
  return {SlabId(0), RegionId(lower), RegionId(upper)};
}

const std::vector<Contour>& columns_beside_a_wall() {
  static const std::vector<Contour> kColumns{box(0, 0, 1, 1), box(50, -200, 51, 200),
                                             box(100, 0, 101, 1)};
  return kColumns;
}

Point3 point_of(const SlabSolid& solid, const Sections& s, NodeId node) {
  const std::size_t n = node.index();
  const std::size_t lower = s.lower.vertex_count();
  if (n < lower) return s.lower.point3(PlaneVertexId(n));
  const std::size_t both = lower + s.upper.vertex_count();
  if (n < both) return s.upper.point3(PlaneVertexId(n - lower));
  return solid.constructed[ConstructedId(n - both)];
}

TEST(SlabOutcome, IsASolidForRegionsOneOverTheOther) {
  const Sections s = conformed(stack_of_boxes({{box(0, 0, 4, 2)}, {box(1, 0, 5, 2)}}));
  const SlabOutcome outcome = outcome_of(s, {link(0, 0)});
  EXPECT_TRUE(std::holds_alternative<SlabSolid>(outcome));
}

TEST(SlabOutcome, AsksForFinerContoursFirstAndIsUnconnectableThen) {
  const SectionStack stack = stack_of_boxes({columns_beside_a_wall(), columns_beside_a_wall()});
  const std::vector<SlabRegionId> expected{SlabRegionId(0), SlabRegionId(5)};
  const SlabOutcome coarse = outcome_of(conformed(stack), {link(0, 2)});
  ASSERT_TRUE(std::holds_alternative<RefineHere>(coarse));
  EXPECT_EQ(std::get<RefineHere>(coarse).regions, expected);
  const SlabOutcome fine = outcome_of(conformed(stack, true), {link(0, 2)});
  ASSERT_TRUE(std::holds_alternative<Unconnectable>(fine));
  EXPECT_EQ(std::get<Unconnectable>(fine).regions, expected);
  // Without that link there is nothing to connect.
  EXPECT_TRUE(std::holds_alternative<SlabSolid>(outcome_of(conformed(stack), {link(0, 0)})));
}

TEST(SlabOutcome, IsUnrepresentableWithoutADoubleBetweenThePlanes) {
  SectionStack stack = stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}});
  stack.sections[SectionId(0)].z = 1;
  stack.sections[SectionId(1)].z = std::nextafter(1.0, 2.0);
  const SlabOutcome outcome = outcome_of(conformed(stack), {link(0, 0)});
  ASSERT_TRUE(std::holds_alternative<Unrepresentable>(outcome));
  EXPECT_EQ(std::get<Unrepresentable>(outcome).error.code, ErrorCode::unrepresentable);
  EXPECT_EQ(std::get<Unrepresentable>(outcome).error.where.slab, 0U);
}

TEST(BuildSlab, FailsAtTheWorkLimit) {
  const Sections s = conformed(generate(StackKind::small_grid, 1).stack);
  const Result<SlabOutcome> refused =
      build_slab(SlabId(3), s.lower, s.upper, {}, nullptr, {DelaunayEngine::automatic, 1e-9});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::work_limit);
  EXPECT_EQ(refused.error().where.slab, 3U);
}

TEST(BuildSlab, EmptySectionsEndTheOtherOneMidway) {
  for (const bool upper : {false, true}) {
    const std::vector<Contour> plate{box(0, 0, 4, 2)};
    const Sections s = conformed(upper ? stack_of_boxes({{}, plate}) : stack_of_boxes({plate, {}}));
    const SlabOutcome outcome = outcome_of(s, {});
    ASSERT_TRUE(std::holds_alternative<SlabSolid>(outcome));
    const auto& solid = std::get<SlabSolid>(outcome);
    ASSERT_EQ(solid.constructed.size(), 4U);
    for (const Point3& p : solid.constructed) EXPECT_EQ(p.z, 0.5);
    long double volume = 0;
    for (const Piece& piece : solid.pieces) {
      std::array<Point3, 4> p;
      for (std::size_t i = 0; i < 4; ++i) p[i] = point_of(solid, s, piece.node.at(i));
      const long double part = volume6(p[0], p[1], p[2], p[3]);
      EXPECT_GT(part, 0);
      volume += part;
    }
    EXPECT_EQ(volume, 6 * 4);
  }
}

TEST(BuildSlab, OfTwoEmptySectionsIsASolidOfNothing) {
  const SlabOutcome outcome = outcome_of(conformed(stack_of_boxes({{}, {}})), {});
  ASSERT_TRUE(std::holds_alternative<SlabSolid>(outcome));
  EXPECT_TRUE(std::get<SlabSolid>(outcome).pieces.empty());
}

TEST(SlabSolid, CoversTheInternalTrianglesOfItsSectionsOnceAndIsPositive) {
  std::size_t solids = 0;
  for (const NamedSlab& named : generated_slabs(510, 1)) {
    SCOPED_TRACE(named.name);
    const Sections s{named.built->lower, named.built->upper};
    const SlabOutcome outcome = outcome_of(s, named.built->links);
    const auto* solid = std::get_if<SlabSolid>(&outcome);
    if (solid == nullptr) continue;
    ++solids;
    std::map<std::set<NodeId>, int> faces;
    for (const Piece& piece : solid->pieces) {
      std::array<Point3, 4> p;
      for (std::size_t i = 0; i < 4; ++i) p[i] = point_of(*solid, s, piece.node.at(i));
      ASSERT_EQ(orient3d(p[0], p[1], p[2], p[3]), Sign::positive);
      for (std::size_t i = 0; i < 4; ++i) {
        std::set<NodeId> face(piece.node.begin(), piece.node.end());
        face.erase(piece.node.at(i));
        ++faces[face];
      }
    }
    std::size_t internal = 0;
    for (const bool upper : {false, true}) {
      const ConformingSection& section = upper ? s.upper : s.lower;
      const std::size_t first = upper ? s.lower.vertex_count() : 0;
      for (const TriangleId t : section.triangulation.triangles.ids()) {
        std::set<NodeId> face;
        for (const PlaneVertexId v : section.triangulation.triangles[t]) {
          face.insert(NodeId(first + v.index()));
        }
        const auto found = faces.find(face);
        const int times = found == faces.end() ? 0 : found->second;
        EXPECT_EQ(times, section.internal[t] != 0 ? 1 : 0);
        internal += section.internal[t];
      }
    }
    // Nothing else of the solid lies in a plane.
    std::size_t in_plane = 0;
    for (const auto& [face, times] : faces) {
      EXPECT_LE(times, 2);
      std::set<double> z;
      for (const NodeId n : face) z.insert(point_of(*solid, s, n).z);
      if (z == std::set<double>{s.lower.z} || z == std::set<double>{s.upper.z}) ++in_plane;
    }
    EXPECT_EQ(in_plane, internal);
  }
  EXPECT_GT(solids, 20U);
}

TEST(SlabSolid, IsTheSameForEitherDelaunayEngine) {
  for (const NamedSlab& named : generated_slabs(511, 1)) {
    SCOPED_TRACE(named.name);
    const Sections s{named.built->lower, named.built->upper};
    const SlabOutcome a = outcome_of(s, named.built->links, DelaunayEngine::slab);
    const SlabOutcome b = outcome_of(s, named.built->links, DelaunayEngine::incremental);
    ASSERT_EQ(a.index(), b.index());
    if (!std::holds_alternative<SlabSolid>(a)) continue;
    EXPECT_EQ(std::get<SlabSolid>(a).constructed, std::get<SlabSolid>(b).constructed);
    ASSERT_EQ(std::get<SlabSolid>(a).pieces.size(), std::get<SlabSolid>(b).pieces.size());
    for (std::size_t k = 0; k < std::get<SlabSolid>(a).pieces.size(); ++k) {
      EXPECT_EQ(std::get<SlabSolid>(a).pieces[k].node, std::get<SlabSolid>(b).pieces[k].node);
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
