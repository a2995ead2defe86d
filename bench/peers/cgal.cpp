// CGAL: exact predicates, inexact constructions, range insertion; on several threads, where it is
// built with TBB, with its grid of locks, 50 cells to a side as its manual has it.
#include "engines.hpp"

#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include "measure.hpp"
#include "peers/cgal_dynamic.hpp"
#include "peers/cgal_plane.hpp"

namespace tetloft::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

#ifdef CGAL_LINKED_WITH_TBB
using Cells = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
                                                   CGAL::Delaunay_triangulation_cell_base_3<Kernel>,
                                                   CGAL::Parallel_tag>;
using Parallel = CGAL::Delaunay_triangulation_3<Kernel, Cells>;

Run run3_parallel(const std::vector<Kernel::Point_3>& input, unsigned threads) {
  const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
  const Clock clock;
  const CGAL::Bbox_3 box = CGAL::bbox_3(input.begin(), input.end());
  Parallel::Lock_data_structure locks(box, 50);
  const Parallel d(input.begin(), input.end(), &locks);
  const double seconds = clock.seconds();
  return {seconds, d.number_of_finite_cells()};
}
constexpr bool kParallel = true;
#else
Run run3_parallel(const std::vector<Kernel::Point_3>&, unsigned) { return {}; }
constexpr bool kParallel = false;
#endif

Run run3(std::span<const Point3> points, unsigned threads) {
  std::vector<Kernel::Point_3> input;
  input.reserve(points.size());
  for (const Point3& p : points) input.emplace_back(p.x, p.y, p.z);
  if (threads > 1) return run3_parallel(input, threads);
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

Peer cgal() {
  Peer peer{"CGAL", CGAL_VERSION_STR, run3, run2, kParallel};
  peer.dynamic = cgal_dynamic();
  peer.plane = cgal_plane();
  return peer;
}

}  // namespace tetloft::bench
