// Voronoi skeletons: the duals of internal or external Delaunay edges (Nonato et al. 2000,
// section 3.1).
#include <optional>
#include <vector>

#include <tetloft/skeleton.hpp>

#include "core/entry.hpp"
#include "sections/conforming_section.hpp"

namespace tetloft {

using namespace internal;

namespace {

Point2 dual_vertex(const ConformingSection& section, TriangleId t) {
  const PlaneTriangleVertices& v = section.triangulation.triangles[t];
  return circumcentre(section.point(v[0]), section.point(v[1]), section.point(v[2]));
}

SkeletonEdge dual_edge(const ConformingSection& section, EdgeId id) {
  const ConformingSection::Edge& edge = section.edges[id];
  SkeletonEdge result;
  result.dual = id;
  result.kind = edge.kind;
  result.contour_a = section.contour[edge.a];
  result.contour_b = section.contour[edge.b];
  result.left = edge.left.valid() ? edge.left : edge.right;
  result.from = dual_vertex(section, result.left);
  if (edge.left.valid() && edge.right.valid()) {
    result.right = edge.right;
    result.to = dual_vertex(section, edge.right);
    return result;
  }
  // The ray leaves at right angles to the hull edge, away from its only triangle.
  const Point2& a = section.point(edge.left.valid() ? edge.a : edge.b);
  const Point2& b = section.point(edge.left.valid() ? edge.b : edge.a);
  result.ray = true;
  result.to = {b.y - a.y, a.x - b.x};
  return result;
}

std::vector<SkeletonEdge> skeleton(const ConformingSection& section, EdgeKind kind,
                                   const std::optional<ContourId>& contour) {
  sections::require_consistent(section);
  require_named(!contour || contour->index() < section.nesting.parent.size(),
                "no contour of the section");
  std::vector<SkeletonEdge> result;
  if (kind != EdgeKind::internal && kind != EdgeKind::external) return result;
  for (std::size_t e = 0; e < section.edges.size(); ++e) {
    const ConformingSection::Edge& edge = section.edges[EdgeId(e)];
    if (edge.kind != kind) continue;
    if (contour && section.contour[edge.a] != *contour && section.contour[edge.b] != *contour) {
      continue;
    }
    result.push_back(dual_edge(section, EdgeId(e)));
  }
  return result;
}

}  // namespace

std::vector<SkeletonEdge> voronoi_skeleton(const ConformingSection& section, EdgeKind kind) {
  return skeleton(section, kind, std::nullopt);
}

std::vector<SkeletonEdge> voronoi_skeleton(const ConformingSection& section, EdgeKind kind,
                                           ContourId contour) {
  return skeleton(section, kind, contour);
}

}  // namespace tetloft
