// Work on a triangulation that is there, or grows point by point: what its cases are made of.
#pragma once

#include <array>
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
  nearest,       ///< the nearest vertex of each of `queries`
  volumes        ///< the Voronoi cells' volumes
};

struct DynamicWork {
  DynamicJob job = DynamicJob::insert;
  std::vector<Point3> points;        ///< distinct
  std::vector<std::uint32_t> order;  ///< places in `points`
  std::vector<Point3> queries;
};

/// The same in the plane.
enum class PlaneJob : std::uint8_t {
  insert,    ///< all points, one by one
  remove,    ///< the vertices one by one, in the order of `order`
  locate,    ///< `queries`
  nearest,   ///< the nearest vertex of each of `queries`
  constrain  ///< all points at once, then `segments` as constraints
};

struct PlaneWork {
  PlaneJob job = PlaneJob::insert;
  std::vector<Point2> points;        ///< distinct
  std::vector<std::uint32_t> order;  ///< places in `points`
  std::vector<Point2> queries;
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< by places; they do not cross
};

struct PlaneEngine {
  std::string name;
  std::function<Run(const PlaneWork&)> run;
};

/// Does the work; `simplices` of a run is how many points or queries there were.
struct DynamicEngine {
  std::string name;
  std::function<Run(const DynamicWork&)> run;
};

}  // namespace tetloft::bench
