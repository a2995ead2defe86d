// CGAL's triangulation of space as one that changes: as it is, and with Fast_location.
#include "peers/cgal_dynamic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "engines.hpp"
#include "measure.hpp"

namespace tetloft::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Compact = CGAL::Delaunay_triangulation_3<Kernel>;
using Fast = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;

Kernel::Point_3 point(const Point3& p) { return {p.x, p.y, p.z}; }

template <class Triangulation>
std::size_t insert_all(const DynamicWork& work) {
  Triangulation made;
  typename Triangulation::Vertex_handle last;
  for (const Point3& p : work.points) {
    if (work.job == DynamicJob::insert_along && last != typename Triangulation::Vertex_handle()) {
      last = made.insert(point(p), last);
    } else {
      last = made.insert(point(p));
    }
  }
  return made.number_of_vertices();
}

// Counts what is found, so that the search is not left out.
template <class Triangulation>
std::size_t ask_all(const Triangulation& made, const DynamicWork& work) {
  std::size_t found = 0;
  for (const Point3& q : work.queries) {
    if (work.job == DynamicJob::locate) {
      found += made.is_infinite(made.locate(point(q))) ? 0U : 1U;
    } else {
      found += made.is_infinite(made.nearest_vertex(point(q))) ? 0U : 1U;
    }
  }
  return found;
}

// By the dual of each edge: a polygon, a pyramid over which has the vertex as its apex.
template <class Triangulation>
double volume_of_cell(const Triangulation& made, typename Triangulation::Vertex_handle v) {
  std::vector<typename Triangulation::Edge> edges;
  made.finite_incident_edges(v, std::back_inserter(edges));
  double volume = 0;
  for (const auto& edge : edges) {
    auto cell = made.incident_cells(edge);
    const auto last = cell;
    const Kernel::Point_3 first = made.dual(cell++);
    for (Kernel::Point_3 before = made.dual(cell++); cell != last; ++cell) {
      const Kernel::Point_3 here = made.dual(cell);
      volume += std::abs(CGAL::volume(v->point(), first, before, here));
      before = here;
    }
  }
  return volume;
}

template <class Triangulation>
std::size_t sum_volumes(const Triangulation& made) {
  double sum = 0;
  std::size_t bounded = 0;
  for (auto v = made.finite_vertices_begin(); v != made.finite_vertices_end(); ++v) {
    std::vector<typename Triangulation::Cell_handle> cells;
    made.incident_cells(v, std::back_inserter(cells));
    if (std::any_of(cells.begin(), cells.end(), [&](auto c) { return made.is_infinite(c); })) {
      continue;
    }
    ++bounded;
    sum += volume_of_cell(made, typename Triangulation::Vertex_handle(v));
  }
  if (!(sum >= 0)) throw std::runtime_error("a volume that is no number");
  return bounded;
}

// The range is inserted in CGAL's own order; the vertices are found by their places afterwards.
template <class Triangulation>
Run on_whole(const DynamicWork& work) {
  std::vector<Kernel::Point_3> points;
  points.reserve(work.points.size());
  for (const Point3& p : work.points) points.push_back(point(p));
  Triangulation made(points.begin(), points.end());
  if (work.job == DynamicJob::volumes) {
    const Clock clock;
    const std::size_t bounded = sum_volumes(made);
    return {clock.seconds(), bounded};
  }
  if (work.job != DynamicJob::remove) {
    const Clock clock;
    const std::size_t found = ask_all(made, work);
    return {clock.seconds(), found};
  }
  std::vector<typename Triangulation::Vertex_handle> vertices(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) made.is_vertex(points[i], vertices[i]);
  const Clock clock;
  for (const std::uint32_t place : work.order) made.remove(vertices[place]);
  return {clock.seconds(), work.order.size()};
}

template <class Triangulation>
Run run_dynamic(const DynamicWork& work) {
  if (work.job != DynamicJob::insert && work.job != DynamicJob::insert_along) {
    return on_whole<Triangulation>(work);
  }
  const Clock clock;
  const std::size_t count = insert_all<Triangulation>(work);
  return {clock.seconds(), count};
}

}  // namespace

std::vector<DynamicEngine> cgal_dynamic() {
  return {{"CGAL", run_dynamic<Compact>}, {"CGAL, Fast_location", run_dynamic<Fast>}};
}

}  // namespace tetloft::bench
