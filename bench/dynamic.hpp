// Work on a triangulation that is there, or grows point by point: what its cases are made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::bench {

struct Run;

/// What is timed. Where vertices are removed, or asked for, the triangulation is there before.
enum class DynamicJob : std::uint8_t {
  insert,        ///< all points, one by one
  insert_along,  ///< the same, each search starting at the point before
  remove,        ///< the vertices one by one, in the order of `order`
  locate,        ///< `queries`
  nearest        ///< the nearest vertex of each of `queries`
};

struct DynamicWork {
  DynamicJob job = DynamicJob::insert;
  std::vector<Point3> points;        ///< distinct
  std::vector<std::uint32_t> order;  ///< places in `points`
  std::vector<Point3> queries;
};

/// Does the work; `simplices` of a run is how many points or queries there were.
struct DynamicEngine {
  std::string name;
  std::function<Run(const DynamicWork&)> run;
};

}  // namespace tetloft::bench
