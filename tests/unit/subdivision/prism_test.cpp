// Prisms over regions: three positive tets over each triangle, from both sides.
#include "subdivision/prism.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// The triangle's region is that of its corners.
TEST(Prism, RegionsListTheirTrianglesAndVertices) {
  for (const NamedSlab& s : generated_slabs(320, 1)) {
    SCOPED_TRACE(s.name);
    const ConformingSection& section = s.built->lower;
    const auto triangles = triangles_by_region(section);
    const auto vertices = vertices_by_region(section);
    IdVector<RegionId, std::vector<TriangleId>> expected_triangles(section.nesting.outer.size());
    IdVector<RegionId, std::vector<PlaneVertexId>> expected_vertices(section.nesting.outer.size());
    for (const TriangleId t : section.triangulation.triangles.ids()) {
      if (section.internal[t] == 0) continue;
      expected_triangles[section.region[section.triangulation.triangles[t][0]]].push_back(t);
    }
    for (const PlaneVertexId v : section.region.ids())
      expected_vertices[section.region[v]].push_back(v);
    EXPECT_EQ(triangles, expected_triangles);
    EXPECT_EQ(vertices, expected_vertices);
  }
}

TEST(Prism, IsARegionTimesItsHeight) {
  std::size_t prisms = 0;
  for (const NamedSlab& s : generated_slabs(321, 1)) {
    SCOPED_TRACE(s.name);
    for (const bool upper : {false, true}) {
      const ConformingSection& section = upper ? s.built->upper : s.built->lower;
      const SlabVertices numbering(s.built->lower.vertex_count(), s.built->upper.vertex_count());
      const auto triangles = triangles_by_region(section);
      const auto vertices = vertices_by_region(section);
      for (const RegionId r : triangles.ids()) {
        std::vector<Piece> pieces;
        const PrismNodes nodes{numbering, upper, Nodes(numbering.size(), 5, 6), CapId(7)};
        extrude(section, triangles[r], vertices[r], SlabRegionId(3), nodes, pieces);
        EXPECT_EQ(pieces.size(), 3 * triangles[r].size());

        std::map<NodeId, Point3> at;
        const std::size_t first = upper ? s.built->lower.vertex_count() : 0;
        for (std::size_t k = 0; k < vertices[r].size(); ++k) {
          const Point3 p = section.point3(vertices[r][k]);
          at[NodeId(first + vertices[r][k].index())] = p;
          at[NodeId(numbering.size() + 5 + 6 + 7 + k)] = {p.x, p.y, p.z + (upper ? -2 : 2)};
        }
        long double base = 0;  // twice the area
        for (const TriangleId t : triangles[r]) {
          const auto& [a, b, c] = section.triangulation.triangles[t];
          const Point3 p = section.point3(a);
          base += std::abs(volume6(p, section.point3(b), section.point3(c), {p.x, p.y, p.z + 1}));
        }
        long double sum = 0;
        for (const Piece& piece : pieces) {
          EXPECT_EQ(piece.region, SlabRegionId(3));
          EXPECT_EQ(piece.kind, TetKind::prism);
          std::array<Point3, 4> p;
          for (std::size_t i = 0; i < 4; ++i) p[i] = at.at(piece.node.at(i));
          const long double part = volume6(p[0], p[1], p[2], p[3]);
          EXPECT_GT(part, 0);
          sum += part;
        }
        // Six times the volume: three times twice the area by the height.
        EXPECT_NEAR(static_cast<double>(sum / (3 * 2 * base)), 1, 1e-9);
        ++prisms;
      }
    }
  }
  EXPECT_GT(prisms, 50U);
}

// No face but those of the hull belongs to one piece only: neighbours conform.
TEST(Prism, FacesOfItsPiecesConform) {
  for (const NamedSlab& s : generated_slabs(322, 1)) {
    SCOPED_TRACE(s.name);
    const ConformingSection& section = s.built->lower;
    const auto triangles = triangles_by_region(section);
    const auto vertices = vertices_by_region(section);
    const std::size_t n = section.vertex_count();
    for (const RegionId r : triangles.ids()) {
      std::vector<Piece> pieces;
      extrude(section, triangles[r], vertices[r], SlabRegionId(0),
              {SlabVertices(n, 0), false, Nodes(n), CapId(0)}, pieces);
      std::map<std::set<NodeId>, int> faces;
      for (const Piece& piece : pieces) {
        for (const NodeId left_out : piece.node) {
          std::set<NodeId> face(piece.node.begin(), piece.node.end());
          face.erase(left_out);
          ++faces[face];
        }
      }
      std::size_t contour_edges = 0;
      for (const ConformingSection::Edge& edge : section.edges) {
        const bool own = section.region[edge.a] == r && section.region[edge.b] == r;
        if (own && edge.kind == EdgeKind::contour) ++contour_edges;
      }
      std::size_t outer = 0;
      for (const auto& [face, times] : faces) outer += times == 1 ? 1U : 0U;
      EXPECT_EQ(outer, 2 * triangles[r].size() + 2 * contour_edges);
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
