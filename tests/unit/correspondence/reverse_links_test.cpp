// Links by reverse tets, against the definition read off the triangles.
#include "correspondence/reverse_links.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// By triangles: both incident ones in the region, or none (and the edge off the contours).
EdgeKind edge_by_triangles(const ConformingSection& section, PlaneVertexId u, PlaneVertexId v) {
  std::size_t inside = 0;
  for (std::size_t k = 0; k < section.triangulation.triangles.size(); ++k) {
    const PlaneTriangleVertices& t = section.triangulation.triangles[TriangleId(k)];
    const bool on = std::count(t.begin(), t.end(), u) + std::count(t.begin(), t.end(), v) == 2;
    if (on && section.internal[TriangleId(k)] != 0) ++inside;
  }
  return inside == 2 ? EdgeKind::internal : inside == 1 ? EdgeKind::contour : EdgeKind::external;
}

TEST(ReverseLinks, JoinTheRegionsOfTetsWithAnInternalEdgeAndNoContourEdge) {
  std::size_t links = 0;
  for (const NamedSlab& s : generated_slabs(400, 1)) {
    SCOPED_TRACE(s.name);
    const Slab& slab = *s.built->slab;
    std::set<std::pair<RegionId, RegionId>> expected;
    for (std::size_t k = 0; k < slab.tet_count(); ++k) {
      std::vector<PlaneVertexId> low;
      std::vector<PlaneVertexId> high;
      for (const SlabVertexId v : slab.vertices(TetId(k))) {
        (slab.is_upper(v) ? high : low).push_back(slab.in_section(v));
      }
      if (low.size() != 2) continue;
      const std::set<EdgeKind> kinds{edge_by_triangles(s.built->lower, low[0], low[1]),
                                     edge_by_triangles(s.built->upper, high[0], high[1])};
      if (!kinds.contains(EdgeKind::internal) || kinds.contains(EdgeKind::contour)) continue;
      for (const PlaneVertexId v : low) {
        for (const PlaneVertexId w : high) {
          expected.emplace(s.built->lower.region[v], s.built->upper.region[w]);
        }
      }
    }
    std::set<std::pair<RegionId, RegionId>> found;
    for (const Link& link : reverse_links(SlabId(7), slab)) {
      EXPECT_EQ(link.slab, SlabId(7));
      EXPECT_TRUE(found.emplace(link.lower, link.upper).second);
    }
    EXPECT_EQ(found, expected);
    links += found.size();
  }
  EXPECT_GT(links, 0U);
}

}  // namespace
}  // namespace tetloft::testing
