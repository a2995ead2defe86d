// Delaunay tets of periodic sets.
#include <tetloft/periodic.hpp>

#include <utility>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"

using namespace tetloft::internal::c;

tetloft_status tetloft_periodic_delaunay(const double* xyz, size_t point_count, const double* box,
                                         const tetloft_execution* execution,
                                         tetloft_periodic_tets** tets) {
  clear(tets);
  return answer([&] {
    require_output(tets, "tets");
    const tetloft::Execution how = execution_of(execution);
    const tetloft::PeriodicBox vectors = periodic_box(box);
    const tetloft::PeriodicDelaunay3 made =
        value_of(tetloft::periodic_delaunay(space_points(xyz, point_count), vectors, how));
    PeriodicTetsValue value;
    value.points.reserve(made.tets.size());
    value.shifts.reserve(made.tets.size());
    for (const tetloft::PeriodicTet& tet : made.tets) {
      value.points.push_back(tet.points);
      value.shifts.push_back(tet.shifts);
    }
    hand_out(tets, std::move(value));
  });
}

tetloft_status tetloft_periodic_tets_points(const tetloft_periodic_tets* tets,
                                            const uint32_t** points, size_t* count) {
  return answer_array(tets, "tets", &PeriodicTetsValue::points, points, count);
}

tetloft_status tetloft_periodic_tets_shifts(const tetloft_periodic_tets* tets,
                                            const int32_t** shifts, size_t* count) {
  return answer_array(tets, "tets", &PeriodicTetsValue::shifts, shifts, count);
}

tetloft_status tetloft_periodic_tets_free(tetloft_periodic_tets* tets) { return free_handle(tets); }
