// What is timed: the engines of the library, and of others.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/point.hpp>

#include "dynamic.hpp"
#include "periodic.hpp"

namespace tetloft::bench {

/// What one run took and made, finite simplices only.
struct Run {
  double seconds = 0;
  std::size_t simplices = 0;
  std::vector<std::pair<std::string, double>> steps{};  // seconds by name; empty: not told
};

/// Runs once; the time is that of the work proper, without preparing input or counting.
using Runner = std::function<Run()>;

/// Sorting, order and insertion, without canonical numbering.
Run incremental3(std::span<const Point3> points);
/// Both plane triangulations and the overlay with adjacency, without canonical numbering.
Run slab3(std::span<const Point3> points);
/// The whole call, by the automatic engine: canonical numbering and mesh included.
Run whole_call3(std::span<const Point3> points, unsigned threads);
/// Order and insertion.
Run incremental2(std::span<const Point2> points);
/// The whole call.
Run whole_call2(std::span<const Point2> points);

/// Another engine; `version` is what it says of itself.
struct Peer {
  std::string name;
  std::string version;
  std::function<Run(std::span<const Point3>, unsigned threads)> run3;  // empty: cannot
  std::function<Run(std::span<const Point2>)> run2;
  bool parallel = false;                                   // of use with several threads, in space
  std::size_t most_points = static_cast<std::size_t>(-1);  // more takes too long to wait for
  std::vector<DynamicEngine> dynamic{};                    // where triangulations change
  std::vector<PlaneEngine> plane{};                        // the same in the plane
  std::vector<PeriodicEngine> periodic{};                  // cells of periodic sets
};

Peer cgal();
Peer tetgen();
Peer qhull();
Peer hxt();
Peer geogram();
Peer voro();

}  // namespace tetloft::bench
