// CGAL's triangulation of the plane as one that changes, and its constrained one.
#include "peers/cgal_plane.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <CGAL/Triangulation_hierarchy_vertex_base_2.h>
#include <CGAL/spatial_sort.h>

#include "engines.hpp"
#include "measure.hpp"

namespace tetloft::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<Kernel>>;
using Structure =
    CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Triangulation_face_base_2<Kernel>>;
using Hierarchy =
    CGAL::Triangulation_hierarchy_2<CGAL::Delaunay_triangulation_2<Kernel, Structure>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

Kernel::Point_2 point(const Point2& p) { return {p.x, p.y}; }

std::size_t ask_all(const Hierarchy& made, const PlaneWork& work) {
  std::size_t found = 0;
  for (const Point2& q : work.queries) {
    if (work.job == PlaneJob::locate) {
      found += made.is_infinite(made.locate(point(q))) ? 0U : 1U;
    } else {
      found += made.is_infinite(made.nearest_vertex(point(q))) ? 0U : 1U;
    }
  }
  return found;
}

// In the order of the curve, each from the one before, as its range insertion does; handles are
// kept on the way.
Run constrain(const PlaneWork& work) {
  const Clock clock;
  std::vector<std::size_t> order(work.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::vector<Kernel::Point_2> points;
  points.reserve(work.points.size());
  for (const Point2& p : work.points) points.push_back(point(p));
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::const_type;
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(
                         CGAL::make_property_map(std::as_const(points))));
  Constrained made;
  std::vector<Constrained::Vertex_handle> vertices(points.size());
  Constrained::Face_handle near;
  for (const std::size_t i : order) {
    vertices[i] = made.insert(points[i], near);
    near = vertices[i]->face();
  }
  for (const auto& [u, v] : work.segments) made.insert_constraint(vertices[u], vertices[v]);
  return {clock.seconds(), work.segments.size()};
}

Run run_plane(const PlaneWork& work) {
  if (work.job == PlaneJob::constrain) return constrain(work);
  Hierarchy made;
  if (work.job == PlaneJob::insert) {
    const Clock clock;
    for (const Point2& p : work.points) made.insert(point(p));
    return {clock.seconds(), made.number_of_vertices()};
  }
  std::vector<Hierarchy::Vertex_handle> vertices;
  for (const Point2& p : work.points) vertices.push_back(made.insert(point(p)));
  const Clock clock;
  if (work.job != PlaneJob::remove) {
    const std::size_t found = ask_all(made, work);
    return {clock.seconds(), found};
  }
  for (const std::uint32_t place : work.order) made.remove(vertices[place]);
  return {clock.seconds(), work.order.size()};
}

}  // namespace

std::vector<PlaneEngine> cgal_plane() { return {{"CGAL", run_plane}}; }

}  // namespace tetloft::bench
