// CGAL: exact predicates, inexact constructions, sequential, range insertion.
#include "engines.hpp"

#include <vector>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include "measure.hpp"

namespace tetloft::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Run run3(std::span<const Point3> points) {
  std::vector<Kernel::Point_3> input;
  input.reserve(points.size());
  for (const Point3& p : points) input.emplace_back(p.x, p.y, p.z);
  const Clock clock;
  const CGAL::Delaunay_triangulation_3<Kernel> d(input.begin(), input.end());
  const double seconds = clock.seconds();
  return {seconds, d.number_of_finite_cells()};
}

Run run2(std::span<const Point2> points) {
  std::vector<Kernel::Point_2> input;
  input.reserve(points.size());
  for (const Point2& p : points) input.emplace_back(p.x, p.y);
  const Clock clock;
  const CGAL::Delaunay_triangulation_2<Kernel> d(input.begin(), input.end());
  const double seconds = clock.seconds();
  return {seconds, d.number_of_faces()};
}

}  // namespace

Peer cgal() { return {"CGAL", CGAL_VERSION_STR, run3, run2}; }

}  // namespace tetloft::bench
