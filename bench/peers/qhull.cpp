// Qhull: the lower hull of the lifted points; merged facets, not exact.
#include "engines.hpp"

#include <cstdio>
#include <stdexcept>
#include <vector>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "measure.hpp"

namespace tetloft::bench {

namespace {

Run delaunay(std::vector<double>& coordinates, int dimension) {
  qhT state;
  qh_zero(&state, stderr);
  char command[] = "qhull d Qbb Qz Qt Q12";
  std::FILE* const silent = std::fopen("/dev/null", "w");
  const Clock clock;
  const int failed =
      qh_new_qhull(&state, dimension, static_cast<int>(coordinates.size()) / dimension,
                   coordinates.data(), 0, command, nullptr, silent);
  Run run{clock.seconds(), 0};
  if (failed == 0) {
    facetT* facet;
    for (facet = state.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next) {
      run.simplices += facet->upperdelaunay ? 0 : 1;
    }
  }
  qh_freeqhull(&state, True);
  std::fclose(silent);
  if (failed != 0) throw std::runtime_error("Qhull gave up");
  return run;
}

Run run3(std::span<const Point3> points, unsigned) {
  std::vector<double> coordinates;
  for (const Point3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  return delaunay(coordinates, 3);
}

Run run2(std::span<const Point2> points) {
  std::vector<double> coordinates;
  for (const Point2& p : points) coordinates.insert(coordinates.end(), {p.x, p.y});
  return delaunay(coordinates, 2);
}

}  // namespace

Peer qhull() { return {"Qhull", qh_version2, run3, run2, false, 10'000}; }

}  // namespace tetloft::bench
