// The cases of triangulations of the plane that change, and ours.
#include "plane_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/delaunay_triangulation2.hpp>

#include "core/prng.hpp"
#include "inputs.hpp"
#include "value_of.hpp"

namespace tetloft::bench {

namespace {

using PlanePoints = std::vector<Point2>;

// An integer grid of about n points.
PlanePoints grid2(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)) + 0.5);
  PlanePoints points;
  for (std::size_t k = 0; k < side * side; ++k) {
    points.push_back({static_cast<double>(k % side), static_cast<double>(k / side)});
  }
  return points;
}

struct PlaneSet {
  const char* name;
  PlanePoints (*make)(std::size_t n);
};
constexpr PlaneSet kPlaneSets[] = {{"uniform", uniform2}, {"grid", grid2}};

struct NamedPlaneJob {
  PlaneJob job;
  const char* name;
  const char* what;
};
constexpr NamedPlaneJob kPlaneJobs[] = {
    {PlaneJob::insert, "insert", "one by one in random order"},
    {PlaneJob::remove, "remove", "all of them in random order"},
    {PlaneJob::locate, "locate", "random queries in the box, no hint"},
    {PlaneJob::nearest, "nearest", "the nearest vertex of random queries in the box, no hint"},
};

double greatest(const PlanePoints& points) {
  double result = 0;
  for (const Point2& p : points) result = std::max({result, p.x, p.y});
  return result;
}

PlaneWork work_of(const PlaneSet& set, PlaneJob job, std::size_t n, std::size_t queries) {
  PlaneWork work;
  work.job = job;
  work.points = set.make(n);
  internal::Prng prng(25);
  prng.shuffle(work.points);
  work.order.resize(work.points.size());
  std::iota(work.order.begin(), work.order.end(), 0U);
  prng.shuffle(work.order);
  if (job == PlaneJob::locate || job == PlaneJob::nearest) {
    const double side = greatest(work.points);
    for (std::size_t k = 0; k < queries; ++k) {
      const double x = side * prng.unit();
      work.queries.push_back({x, side * prng.unit()});
    }
  }
  return work;
}

// A segment in each cell of a grid: n of them, none of which meets another.
PlaneWork segments_of(std::size_t n) {
  PlaneWork work;
  work.job = PlaneJob::constrain;
  internal::Prng prng(26);
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  for (std::size_t k = 0; k < n; ++k) {
    const auto first = static_cast<std::uint32_t>(work.points.size());
    for (int end = 0; end < 2; ++end) {
      const double x = static_cast<double>(k % side) + 0.98 * prng.unit();
      work.points.push_back({x, static_cast<double>(k / side) + 0.98 * prng.unit()});
    }
    work.segments.push_back({first, first + 1});
  }
  prng.shuffle(work.segments);
  return work;
}

std::size_t ask_all(const DelaunayTriangulation2& made, const PlaneWork& work) {
  std::size_t found = 0;
  for (const Point2& q : work.queries) {
    if (work.job == PlaneJob::locate) {
      found += value_of(made.locate(q)).kind == LocationKind::outside ? 0U : 1U;
    } else {
      found += made.is_live(value_of(made.nearest_vertex(q))) ? 1U : 0U;
    }
  }
  return found;
}

Run constrain(const PlaneWork& work) {
  const Clock clock;
  DelaunayTriangulation2 made = value_of(DelaunayTriangulation2::of(work.points));
  std::vector<std::array<DelaunayVertex, 2>> segments;
  segments.reserve(work.segments.size());
  for (const auto& [u, v] : work.segments) {
    segments.push_back({made.vertex_at(u), made.vertex_at(v)});
  }
  const std::size_t count = value_of(made.insert_constraints(segments)).size();
  return {clock.seconds(), count};
}

Run run_plane(const PlaneWork& work) {
  if (work.job == PlaneJob::constrain) return constrain(work);
  if (work.job == PlaneJob::insert) {
    const Clock clock;
    DelaunayTriangulation2 made;
    for (const Point2& p : work.points) (void)value_of(made.insert(p));
    return {clock.seconds(), made.vertex_count()};
  }
  DelaunayTriangulation2 made = value_of(DelaunayTriangulation2::of(work.points));
  const Clock clock;
  if (work.job != PlaneJob::remove) {
    const std::size_t found = ask_all(made, work);
    return {clock.seconds(), found};
  }
  for (const std::uint32_t place : work.order) {
    if (!made.remove(made.vertex_at(place))) throw std::runtime_error("cannot remove a vertex");
  }
  return {clock.seconds(), work.order.size()};
}

Case plane_case(const std::string& name, const char* what, std::function<PlaneWork()> make) {
  Case one;
  one.name = std::string("dynamic plane ").append(name);
  one.what = what;
  one.make = [make = std::move(make)](const std::vector<Peer>& peers) {
    const auto work = std::make_shared<const PlaneWork>(make());
    const auto contestant = [&](const PlaneEngine& engine, bool counted) {
      return Contestant{engine.name, [run = engine.run, work] { return run(*work); }, counted};
    };
    Case::Field field;
    field.points = work->points.size();
    field.own.push_back(contestant({"tetloft", run_plane}, true));
    for (const Peer& peer : peers) {
      for (const PlaneEngine& engine : peer.plane) {
        field.peers.push_back(contestant(engine, false));
      }
    }
    return field;
  };
  return one;
}

}  // namespace

std::vector<Case> plane_cases(const DynamicOptions& options) {
  std::vector<Case> cases;
  for (const NamedPlaneJob& job : kPlaneJobs) {
    for (const PlaneSet& set : kPlaneSets) {
      for (const std::size_t n : options.sizes) {
        cases.push_back(plane_case(std::string(job.name) + ' ' + set.name + ' ' + size_name(n),
                                   job.what, [&job, &set, n, queries = options.queries] {
                                     return work_of(set, job.job, n, queries);
                                   }));
      }
    }
  }
  for (const std::size_t n : options.sizes) {
    cases.push_back(plane_case("constrain " + size_name(n),
                               "as many short segments as constraints, their ends inserted first",
                               [n] { return segments_of(n); }));
  }
  return cases;
}

}  // namespace tetloft::bench
