// The cases of periodic sets, and ours.
#include "periodic_cases.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/periodic.hpp>

#include "core/prng.hpp"
#include "inputs.hpp"
#include "value_of.hpp"

namespace tetloft::bench {

namespace {

// Relative; engines round the box and the points in ways of their own.
constexpr double kSameVolume = 1e-9;

// Coordinates along the vectors of the box.
struct PeriodicSet {
  const char* name;
  std::vector<Point3> (*make)(std::size_t n);
};

// Each point of a lattice is moved by up to a tenth of its spacing.
std::vector<Point3> perturbed_lattice(std::size_t n) {
  const double side = std::floor(std::cbrt(static_cast<double>(n)) + 0.5);
  std::vector<Point3> points = grid3(static_cast<std::size_t>(side));
  internal::Prng prng(26);
  const auto moved = [&](double x) { return (x + 0.5 + 0.2 * (prng.unit() - 0.5)) / side; };
  for (Point3& p : points) {
    const double x = moved(p.x);
    const double y = moved(p.y);
    p = {x, y, moved(p.z)};
  }
  return points;
}

constexpr PeriodicSet kPeriodicSets[] = {{"uniform", uniform3}, {"lattice", perturbed_lattice}};

struct NamedBox {
  const char* name;
  const char* what;
  PeriodicBox box;
};
constexpr NamedBox kBoxes[] = {
    {"straight", "cells in a cube", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {"skewed", "cells in a skewed box", {{1, 0, 0}, {0.4, 1, 0}, {0.3, -0.25, 1}}},
};

PeriodicWork periodic_work(const PeriodicSet& set, const NamedBox& box, std::size_t n) {
  PeriodicWork work{set.make(n), box.box};
  const auto& [a, b, c] = work.box;
  for (Point3& p : work.points) {
    p = {p.x * a.x + p.y * b.x + p.z * c.x, p.y * b.y + p.z * c.y, p.z * c.z};
  }
  return work;
}

Run run_periodic(const PeriodicWork& work, std::vector<double>& volumes) {
  const Clock clock;
  const PeriodicVoronoi3 made = value_of(periodic_voronoi(work.points, work.box, {.threads = 1}));
  const double seconds = clock.seconds();
  for (const PeriodicCell& cell : made.cells) volumes.push_back(cell.volume);
  return {seconds, volumes.size()};
}

void require_same(const std::vector<double>& volumes, const std::vector<double>& ours) {
  if (volumes.size() != ours.size()) throw std::runtime_error("not as many cells");
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (std::abs(volumes[i] - ours[i]) <= kSameVolume * ours[i]) continue;
    throw std::runtime_error("the volume of cell " + std::to_string(i) + " is " +
                             std::to_string(volumes[i] / ours[i]) + " of ours");
  }
}

Case periodic_case(const PeriodicSet& set, const NamedBox& box, std::size_t n) {
  Case one;
  one.name = std::string("periodic ") + set.name + ' ' + box.name + ' ' + size_name(n);
  one.what = box.what;
  one.make = [&set, &box, n](const std::vector<Peer>& peers) {
    const auto work = std::make_shared<const PeriodicWork>(periodic_work(set, box, n));
    Case::Field field;
    field.points = work->points.size();
    const auto run = [work] {
      std::vector<double> volumes;
      return run_periodic(*work, volumes);
    };
    field.own.push_back({"tetloft", run, true});
    const auto ours = std::make_shared<std::vector<double>>();
    for (const Peer& peer : peers) {
      for (const PeriodicEngine& engine : peer.periodic) {
        if (ours->empty()) (void)run_periodic(*work, *ours);
        const auto compared = [work, ours, run_peer = engine.run] {
          std::vector<double> volumes;
          Run made = run_peer(*work, volumes);
          require_same(volumes, *ours);
          return made;
        };
        field.peers.push_back({engine.name, compared, false});
      }
    }
    return field;
  };
  return one;
}

}  // namespace

std::vector<Case> periodic_cases(std::span<const std::size_t> sizes) {
  std::vector<Case> cases;
  for (const PeriodicSet& set : kPeriodicSets) {
    for (const NamedBox& box : kBoxes) {
      for (const std::size_t n : sizes) cases.push_back(periodic_case(set, box, n));
    }
  }
  return cases;
}

}  // namespace tetloft::bench
