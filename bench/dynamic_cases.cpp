// The cases of triangulations that change, and ours.
#include "dynamic_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/voronoi.hpp>

#include "core/prng.hpp"
#include "inputs.hpp"
#include "value_of.hpp"

namespace tetloft::bench {

namespace {

using Points = std::vector<Point3>;

struct Set {
  const char* name;
  Points (*make)(std::size_t n);
};

constexpr Set kSets[] = {
    {"uniform", uniform3},
    {"sphere", sphere},
    {"lattice",
     [](std::size_t n) {
       return grid3(static_cast<std::size_t>(std::cbrt(static_cast<double>(n)) + 0.5));
     }},
};

struct Job {
  DynamicJob job;
  const char* name;
  const char* what;
};

constexpr Job kJobs[] = {
    {DynamicJob::insert, "insert", "one by one in random order"},
    {DynamicJob::insert_along, "insert along",
     "one by one along a curve, each from the one before"},
    {DynamicJob::remove, "remove", "all of them in random order"},
    {DynamicJob::locate, "locate", "random queries in the box, no hint"},
    {DynamicJob::nearest, "nearest", "the nearest vertex of random queries in the box, no hint"},
    {DynamicJob::volumes, "volumes", "the volumes of all bounded Voronoi cells"},
};

// Boustrophedon: along x, rows along y, layers along z, each turning back; about `n` cells.
struct Curve {
  Point3 low;
  Point3 high;
  double side;

  [[nodiscard]] std::array<double, 3> key(const Point3& p) const {
    const auto cell = [&](double x, double from, double to) {
      return to > from ? std::min(side - 1, std::floor((x - from) / (to - from) * side)) : 0;
    };
    const double layer = cell(p.z, low.z, high.z);
    const double row = cell(p.y, low.y, high.y);
    const bool back = std::fmod(layer, 2) != 0;
    const bool left = std::fmod(layer * side + row, 2) != 0;
    return {layer, back ? -row : row, left ? -p.x : p.x};
  }
};

std::array<Point3, 2> box_of(const Points& points) {
  std::array<Point3, 2> box{points.front(), points.front()};
  for (const Point3& p : points) {
    box[0] = {std::min(box[0].x, p.x), std::min(box[0].y, p.y), std::min(box[0].z, p.z)};
    box[1] = {std::max(box[1].x, p.x), std::max(box[1].y, p.y), std::max(box[1].z, p.z)};
  }
  return box;
}

DynamicWork work_of(const Set& set, DynamicJob job, std::size_t n, std::size_t queries) {
  DynamicWork work;
  work.job = job;
  work.points = set.make(n);
  internal::Prng prng(24);
  if (job == DynamicJob::insert) prng.shuffle(work.points);
  const auto [low, high] = box_of(work.points);
  if (job == DynamicJob::insert_along) {
    const Curve curve{low, high, std::ceil(std::cbrt(static_cast<double>(n)))};
    std::sort(work.points.begin(), work.points.end(),
              [&](const Point3& a, const Point3& b) { return curve.key(a) < curve.key(b); });
  }
  if (job == DynamicJob::remove) {
    work.order.resize(work.points.size());
    std::iota(work.order.begin(), work.order.end(), 0U);
    prng.shuffle(work.order);
  }
  if (job == DynamicJob::locate || job == DynamicJob::nearest) {
    const auto between = [&](double from, double to) { return from + prng.unit() * (to - from); };
    for (std::size_t k = 0; k < queries; ++k) {
      const double x = between(low.x, high.x);
      const double y = between(low.y, high.y);
      work.queries.push_back({x, y, between(low.z, high.z)});
    }
  }
  return work;
}

std::size_t insert_all(const DynamicWork& work) {
  DelaunayTriangulation3 made;
  DelaunayVertex last;
  for (const Point3& p : work.points) {
    const DelaunayVertex near = work.job == DynamicJob::insert_along ? last : DelaunayVertex();
    last = value_of(made.insert(p, near)).vertex;
  }
  return made.vertex_count();
}

// Counts what is found, so that the search is not left out.
std::size_t ask_all(const DelaunayTriangulation3& made, const DynamicWork& work) {
  std::size_t found = 0;
  for (const Point3& q : work.queries) {
    if (work.job == DynamicJob::locate) {
      found += value_of(made.locate(q)).kind == LocationKind::outside ? 0U : 1U;
    } else {
      found += made.is_live(value_of(made.nearest_vertex(q))) ? 1U : 0U;
    }
  }
  return found;
}

// Of the cells that have one; counts them.
std::size_t sum_volumes(const DelaunayTriangulation3& made) {
  double sum = 0;
  std::size_t bounded = 0;
  for (const double volume : value_of(voronoi_volumes(made, {.threads = 1}))) {
    if (std::isinf(volume)) continue;
    ++bounded;
    sum += volume;
  }
  if (!(sum >= 0)) throw std::runtime_error("a volume that is no number");
  return bounded;
}

Run run_dynamic(const DynamicWork& work) {
  if (work.job == DynamicJob::insert || work.job == DynamicJob::insert_along) {
    const Clock clock;
    const std::size_t count = insert_all(work);
    return {clock.seconds(), count};
  }
  DelaunayTriangulation3 made = value_of(DelaunayTriangulation3::of(work.points));
  const Clock clock;
  if (work.job == DynamicJob::volumes) {
    const std::size_t bounded = sum_volumes(made);
    return {clock.seconds(), bounded};
  }
  if (work.job != DynamicJob::remove) {
    const std::size_t found = ask_all(made, work);
    return {clock.seconds(), found};
  }
  for (const std::uint32_t place : work.order) {
    if (!made.remove(made.vertex_at(place))) throw std::runtime_error("cannot remove a vertex");
  }
  return {clock.seconds(), work.order.size()};
}

Contestant contestant(const DynamicEngine& engine, const std::shared_ptr<const DynamicWork>& work,
                      bool counted) {
  return {engine.name, [run = engine.run, work] { return run(*work); }, counted};
}

}  // namespace

std::vector<Case> dynamic_cases(const DynamicOptions& options) {
  std::vector<Case> cases;
  for (const Job& job : kJobs) {
    for (const Set& set : kSets) {
      for (const std::size_t n : options.sizes) {
        Case one;
        one.name = std::string("dynamic ") + job.name + ' ' + set.name + ' ' + size_name(n);
        one.what = job.what;
        one.make = [&job, &set, n, queries = options.queries](const std::vector<Peer>& peers) {
          const auto work = std::make_shared<const DynamicWork>(work_of(set, job.job, n, queries));
          Case::Field field;
          field.points = work->points.size();
          field.own.push_back(contestant({"tetloft", run_dynamic}, work, true));
          for (const Peer& peer : peers) {
            for (const DynamicEngine& engine : peer.dynamic) {
              field.peers.push_back(contestant(engine, work, false));
            }
          }
          return field;
        };
        cases.push_back(std::move(one));
      }
    }
  }
  return cases;
}

}  // namespace tetloft::bench
