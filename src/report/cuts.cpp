#include "report/cuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tetloft::internal::report {

namespace {

// Where an edge crosses a height between its ends; the ends in one order, so that all tets and
// faces at it get the same point.
Point2 crossing(const Point3& a, const Point3& b, double z) {
  if (b.z < a.z) return crossing(b, a, z);
  // Halves: the difference of finite numbers may be none.
  const double t = (z / 2 - a.z / 2) / (b.z / 2 - a.z / 2);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

double twice_area_of(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double cut_area(const std::array<Point3, 4>& p, const CutHeight& height) {
  std::array<std::size_t, 4> over{}, under{};
  std::size_t overs = 0, unders = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (height.is_under(p[i].z)) {
      over[overs++] = i;
    } else {
      under[unders++] = i;
    }
  }
  if (overs == 0 || unders == 0) return 0;
  const auto at = [&](std::size_t o, std::size_t u) {
    return crossing(p[over[o]], p[under[u]], height.z);
  };
  if (overs == 2) {
    const Point2 a = at(0, 0), b = at(0, 1), c = at(1, 1), d = at(1, 0);
    return (std::abs(twice_area_of(a, b, c)) + std::abs(twice_area_of(a, c, d))) / 2;
  }
  if (overs == 1) return std::abs(twice_area_of(at(0, 0), at(0, 1), at(0, 2))) / 2;
  return std::abs(twice_area_of(at(0, 0), at(1, 0), at(2, 0))) / 2;
}

// A surface triangle crosses a height from one edge to another, the solid on its left.
struct Crossing {
  std::uint32_t component;
  std::uint64_t from, to;
  Point2 start;
  friend bool operator<(const Crossing& a, const Crossing& b) {
    return std::pair(a.component, a.from) < std::pair(b.component, b.from);
  }
};

std::vector<Crossing> crossings_of(const Subject& subject, const CutHeight& height) {
  const checking::ModelView& view = subject.view;
  std::vector<Crossing> crossings;
  for (std::size_t k = 0; k < view.boundary.size(); ++k) {
    const TriangleVertices& v = view.boundary[k];
    std::array<bool, 3> over{};
    for (std::size_t i = 0; i < 3; ++i) over[i] = height.is_under(view.points[v[i].index()].z);
    if (over[0] == over[1] && over[1] == over[2]) continue;
    Crossing crossing_here{subject.component[subject.behind[k]], 0, 0, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = v[i];
      const VertexId b = v[(i + 1) % 3];
      if (over[i] == over[(i + 1) % 3]) continue;
      if (over[i]) {
        crossing_here.to = edge_key(a, b);
        continue;
      }
      crossing_here.from = edge_key(a, b);
      crossing_here.start = crossing(view.points[a.index()], view.points[b.index()], height.z);
    }
    crossings.push_back(crossing_here);
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

std::vector<double> cut_areas(const Subject& subject, const std::vector<CutHeight>& heights) {
  const checking::ModelView& view = subject.view;
  std::vector<double> areas(heights.size(), 0);
  for (const TetVertices& tet : view.tets) {
    std::array<Point3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = view.points[tet[i].index()];
    const auto [low, high] = std::minmax({p[0].z, p[1].z, p[2].z, p[3].z});
    const auto first = std::lower_bound(heights.begin(), heights.end(), low,
                                        [](const CutHeight& h, double z) { return h.z < z; });
    for (auto at = first; at != heights.end() && at->z <= high; ++at) {
      areas[static_cast<std::size_t>(at - heights.begin())] += cut_area(p, *at);
    }
  }
  return areas;
}

std::vector<CutLoop> cut_loops(const Subject& subject, const CutHeight& height) {
  const std::vector<Crossing> crossings = crossings_of(subject, height);
  std::vector<std::uint8_t> taken(crossings.size(), 0);
  // The next one that starts where `before` ends, or none.
  const auto next_of = [&](const Crossing& before) {
    const Crossing wanted{before.component, before.to, 0, {}};
    auto at = std::lower_bound(crossings.begin(), crossings.end(), wanted);
    for (; at != crossings.end() && at->component == before.component && at->from == before.to;
         ++at) {
      const auto k = static_cast<std::size_t>(at - crossings.begin());
      if (taken[k] == 0) return k;
    }
    return crossings.size();
  };
  std::vector<CutLoop> loops;
  for (std::size_t first = 0; first < crossings.size(); ++first) {
    if (taken[first] != 0) continue;
    CutLoop loop{crossings[first].component, {}};
    for (std::size_t k = first; k < crossings.size(); k = next_of(crossings[k])) {
      taken[k] = 1;
      loop.points.push_back(crossings[k].start);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace tetloft::internal::report
