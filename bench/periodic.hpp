// Voronoi cells of periodic sets: what their cases are made of.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <tetloft/periodic.hpp>
#include <tetloft/point.hpp>

namespace tetloft::bench {

struct Run;

/// Points in the box.
struct PeriodicWork {
  std::vector<Point3> points;
  PeriodicBox box;  ///< a along x, b in the plane of x and y
};

/// Makes all cells, and tells their volumes by point.
struct PeriodicEngine {
  std::string name;
  std::function<Run(const PeriodicWork&, std::vector<double>& volumes)> run;
};

}  // namespace tetloft::bench
