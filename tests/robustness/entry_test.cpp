// What public functions that return plain values make of ids that name nothing, and of arguments
// that do not belong together: result.hpp has the rule.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "robustness/inputs.hpp"

namespace tetloft::test {
namespace {

struct Misuse {
  std::string name;
  std::function<void()> call;
};

template <class Value>
void drop(const Value& /*value*/) {}

template <class Exception>
void expect_thrown(const std::vector<Misuse>& misuses) {
  for (const Misuse& misuse : misuses) EXPECT_THROW(misuse.call(), Exception) << misuse.name;
}

TetMesh two_tets() {
  const auto tet = [](int a, int b, int c, int d) {
    return TetVertices{VertexId(a), VertexId(b), VertexId(c), VertexId(d)};
  };
  return TetMesh::from_tets(6, std::vector{tet(0, 1, 2, 3), tet(0, 2, 1, 4)}).value();
}

TEST(Entry, OfAMeshRefusesIdsThatNameNothing) {
  TetMesh mesh = two_tets();
  mesh.remove_tet(TetId(1));
  for (const VertexId v : {VertexId(), VertexId(6)}) {
    expect_thrown<std::out_of_range>({
        {"star", [&] { drop(mesh.star(v)); }},
        {"star of an edge", [&] { drop(mesh.star(v, VertexId(0))); }},
        {"star of an edge, second end", [&] { drop(mesh.star(VertexId(0), v)); }},
        {"link", [&] { drop(mesh.link(v)); }},
        {"link of an edge", [&] { drop(mesh.link(VertexId(0), v)); }},
        {"classify_link", [&] { drop(mesh.classify_link(v)); }},
        {"classify_link of an edge", [&] { drop(mesh.classify_link(v, VertexId(0))); }},
    });
    EXPECT_EQ(mesh.add_tet({VertexId(0), VertexId(1), VertexId(2), v}).error().code,
              ErrorCode::invalid_input);
  }
  for (const TetId t : {TetId(), TetId(1), TetId(2)}) {  // invalid, dead, none
    const HalfFaceId h = t.valid() ? TetMesh::half_face(t, 2) : HalfFaceId();
    expect_thrown<std::out_of_range>({
        {"star of a face", [&] { drop(mesh.star(h)); }},
        {"link of a face", [&] { drop(mesh.link(h)); }},
        {"ring", [&] { drop(mesh.ring(VertexId(0), VertexId(1), t)); }},
        {"remove_tet", [&] { mesh.remove_tet(t); }},
    });
  }
  EXPECT_TRUE(mesh.validate().empty());
  EXPECT_EQ(mesh.tet_count(), 1U);
}

TEST(Entry, OfAMeshRefusesWhatDoesNotBelongTogether) {
  TetMesh mesh = two_tets();
  const std::vector<TetVertices> tets{mesh.vertices(TetId(0))};
  constexpr std::size_t kTooMany = std::numeric_limits<std::size_t>::max();
  expect_thrown<std::invalid_argument>({
      {"an edge of one vertex", [&] { drop(mesh.star(VertexId(0), VertexId(0))); }},
      {"its link", [&] { drop(mesh.link(VertexId(0), VertexId(0))); }},
      {"a ring from elsewhere", [&] { drop(mesh.ring(VertexId(0), VertexId(4), TetId(0))); }},
      {"a ring of one vertex", [&] { drop(mesh.ring(VertexId(0), VertexId(0), TetId(0))); }},
      {"too few half-faces", [&] { drop(TetMesh::from_adjacency(4, tets, {HalfFaceId()})); }},
      {"too many vertices", [&] { drop(TetMesh::from_adjacency(kTooMany, {}, {})); }},
      {"as many added", [&] { mesh.add_vertices(kTooMany); }},
  });
  EXPECT_EQ(TetMesh::from_tets(kTooMany, tets).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(mesh.vertex_count(), 6U);
}

TEST(Entry, OfSurfacesRefusesTrianglesWithoutVertices) {
  const std::vector<TriangleVertices> triangles{{VertexId(0), VertexId(1), VertexId()}};
  EXPECT_THROW(drop(surface_components(triangles)), std::out_of_range);
}

TEST(Entry, OfNestingsRefusesThoseOfOtherSections) {
  const Section section = case_stack("nested_hole").sections[SectionId(0)];
  const Section other = tower(1).sections[SectionId(0)];
  const Nesting nesting = nest(section);
  ASSERT_NE(section.contours.size(), other.contours.size());
  Nesting bad_region = nesting;
  bad_region.region[ContourId(0)] = RegionId(99);
  Nesting bad_outer = nesting;
  bad_outer.outer[RegionId(0)] = ContourId();
  Section line;
  line.contours.push_back({{{0, 0}, {1, 1}}});
  Section endless;
  endless.contours.push_back({{{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}, {2, 2}}});
  expect_thrown<std::invalid_argument>({
      {"outlines", [&] { drop(outlines(other, nesting)); }},
      {"outline", [&] { drop(outline(other, nesting, RegionId(0))); }},
      {"a region that there is not", [&] { drop(outlines(section, bad_region)); }},
      {"an outer contour that there is not", [&] { drop(outlines(section, bad_outer)); }},
      {"nest of two vertices", [&] { drop(nest(line)); }},
      {"nest of what is not finite", [&] { drop(nest(endless)); }},
      {"twice_area", [&] { drop(twice_area(endless.contours[ContourId(0)])); }},
      {"area_sign", [&] { drop(area_sign(endless.contours[ContourId(0)])); }},
  });
  for (const RegionId region : {RegionId(), RegionId(nesting.outer.size())}) {
    EXPECT_THROW(drop(outline(section, nesting, region)), std::out_of_range);
  }
  for (const Section& bad : {line, endless}) {
    const auto refused = conform(bad, SectionId(7));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(refused.error().where.section, 7U);
  }
}

TEST(Entry, OfSkeletonsRefusesSectionsThatAreNotConforming) {
  const SectionStack stack = tower(2);
  const ConformingSection good = conform(stack.sections[SectionId(0)], SectionId(0)).value();
  std::vector<std::pair<std::string, ConformingSection>> bad(6, {"", good});
  bad[0].first = "an edge of no vertex";
  bad[0].second.edges[EdgeId(0)].b = PlaneVertexId(good.vertex_count());
  bad[1].first = "an edge of no triangle";
  bad[1].second.edges[EdgeId(0)].left = TriangleId(good.triangulation.triangles.size());
  bad[2].first = "an inner edge without triangles";
  for (auto& edge : bad[2].second.edges) edge.left = edge.right = TriangleId();
  bad[3].first = "a triangle of no vertex";
  bad[3].second.triangulation.triangles[TriangleId(0)][2] = PlaneVertexId();
  bad[4].first = "labels of other vertices";
  bad[4].second.contour.resize(1);
  bad[5].first = "a contour that there is not";
  bad[5].second.contour[PlaneVertexId(0)] = ContourId(99);
  for (const auto& entry : bad) {
    const ConformingSection& section = entry.second;
    expect_thrown<std::invalid_argument>({
        {"skeleton: " + entry.first, [&] { drop(voronoi_skeleton(section, EdgeKind::internal)); }},
        {"crossings: " + entry.first, [&] { drop(skeleton_crossings(section, good)); }},
        {"well positioned: " + entry.first, [&] { drop(well_positioned(good, section)); }},
    });
  }
  for (const ContourId c : {ContourId(), ContourId(good.nesting.parent.size())}) {
    EXPECT_THROW(drop(voronoi_skeleton(good, EdgeKind::internal, c)), std::out_of_range);
  }
  EXPECT_FALSE(good.find_edge(PlaneVertexId(0), PlaneVertexId()).valid());
  EXPECT_FALSE(good.find_triangle(PlaneVertexId(0), PlaneVertexId(1), PlaneVertexId(9999)).valid());
}

TEST(Entry, OfOverlapsRefusesOutlinesOfNothing) {
  const Contour square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const Contour endless{{{0, 0}, {std::numeric_limits<double>::infinity(), 0}, {1, 1}}};
  const RegionOutline good{{&square}};
  for (const RegionOutline& bad : {RegionOutline{}, RegionOutline{{nullptr}},
                                   RegionOutline{{&square, nullptr}}, RegionOutline{{&endless}}}) {
    expect_thrown<std::invalid_argument>({
        {"compare_overlap", [&] { drop(compare_overlap(bad, good, 0.5)); }},
        {"compare_overlap, second", [&] { drop(compare_overlap(good, bad, 0.5)); }},
        {"overlap_ratio", [&] { drop(overlap_ratio(bad, good)); }},
        {"overlap_ratio, second", [&] { drop(overlap_ratio(good, bad)); }},
        {"area", [&] { drop(area(bad)); }},
        {"compare_area", [&] { drop(compare_area(bad, 1)); }},
        {"region_distance", [&] { drop(region_distance(bad, good)); }},
        {"region_distance, second", [&] { drop(region_distance(good, bad)); }},
        {"region_distance_within", [&] { drop(region_distance_within(good, bad, -1)); }},
    });
  }
}

TEST(Ids, AreNotMadeOfNumbersThatDoNotFit) {
  EXPECT_EQ(VertexId(std::size_t{0xFFFFFFFE}).value(), 0xFFFFFFFEU);
  EXPECT_FALSE(VertexId(0xFFFFFFFFU).valid());  // a value, not a number
  expect_thrown<std::out_of_range>({
      {"the invalid one", [] { drop(VertexId(std::size_t{0xFFFFFFFF})); }},
      {"33 bits", [] { drop(TetId(std::size_t{1} << 32)); }},
      {"negative", [] { drop(SectionId(-1)); }},
      {"negative, 64 bits", [] { drop(ContourId(std::int64_t{-4294967296})); }},
  });
}

TEST(Version, IsThatOfTheMacros) {
  EXPECT_EQ(version(), std::to_string(TETLOFT_VERSION_MAJOR) + '.' +
                           std::to_string(TETLOFT_VERSION_MINOR) + '.' +
                           std::to_string(TETLOFT_VERSION_PATCH));
  EXPECT_STREQ(version(), TETLOFT_CMAKE_VERSION);
}

TEST(Results, WithoutAnErrorHaveNone) {
  EXPECT_THROW(drop(Result<void>().error()), std::exception);
  EXPECT_THROW(drop(Result<int>(1).error()), std::exception);
}

}  // namespace
}  // namespace tetloft::test
