// The winding number about q is the sum, over the triangles that a vertical ray from q
// meets, of +1 where the outer side is up and −1 where it is down.
//
// To meet no edge, the ray starts next to an inner point of triangle (a, b, c) that lies
// symbolically close to a: q = a + ε (b − a) + ε² (c − a), for an ε as small as need be.
// orient2d(u, v, ·) and orient3d(u, v, w, ·) are affine, so that their sign at q is the
// first nonzero one at a, b, c. It is zero only where the line or plane contains the
// triangle (or its projection), which a line with u ≠ v cannot.
#include "check/winding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <tetloft/predicates.hpp>

namespace tetloft::internal::checking {

namespace {

Point2 below(const Point3& p) { return {p.x, p.y}; }

// The sign of an affine function at the probe, by its signs at the three corners.
template <class SignAt>
Sign sign_at_probe(const Probe& probe, SignAt&& sign_at) {
  for (const Point3& corner : probe.corner) {
    if (const Sign sign = sign_at(corner); sign != Sign::zero) return sign;
  }
  return Sign::zero;
}

bool projection_contains(const std::array<Point3, 3>& triangle, Sign turn, const Probe& probe) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 u = below(triangle[k]);
    const Point2 v = below(triangle[(k + 1) % 3]);
    const Sign side =
        sign_at_probe(probe, [&](const Point3& p) { return orient2d(u, v, below(p)); });
    if (side != turn) return false;
  }
  return true;
}

// A square grid over the probes' first corners. Cell numbers are monotone in the
// coordinate, rounding included, so that a box never misses a probe it contains.
class ProbeGrid {
 public:
  explicit ProbeGrid(const std::vector<Probe>& probes) {
    side_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(probes.size())));
    low_ = high_ = below(probes.front().corner[0]);
    for (const Probe& probe : probes) {
      const Point2 p = below(probe.corner[0]);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    cells_.resize(side_ * side_);
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const Point2 p = below(probes[i].corner[0]);
      cells_[row(p.y) * side_ + column(p.x)].push_back(static_cast<std::uint32_t>(i));
    }
  }

  template <class Visit>
  void in_box(const Point2& low, const Point2& high, Visit&& visit) const {
    if (high.x < low_.x || low.x > high_.x || high.y < low_.y || low.y > high_.y) return;
    for (std::size_t r = row(low.y); r <= row(high.y); ++r) {
      for (std::size_t c = column(low.x); c <= column(high.x); ++c) {
        for (const std::uint32_t i : cells_[r * side_ + c]) visit(i);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t column(double x) const { return cell(x, low_.x, high_.x); }
  [[nodiscard]] std::size_t row(double y) const { return cell(y, low_.y, high_.y); }
  [[nodiscard]] std::size_t cell(double x, double low, double high) const {
    // Halved, because a difference of large coordinates may overflow.
    const double extent = high / 2 - low / 2;
    if (!(extent > 0) || x <= low) return 0;
    const double place = std::min((x / 2 - low / 2) / extent, 1.0);
    return std::min(side_ - 1, static_cast<std::size_t>(place * static_cast<double>(side_)));
  }

  std::size_t side_ = 1;
  Point2 low_, high_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

std::set<std::size_t> OuterWinding::keep_first(const UnionFind& sets) {
  std::set<std::size_t> seen;
  std::erase_if(probes_,
                [&](const Probe& probe) { return !seen.insert(sets.find(probe.surface)).second; });
  return seen;
}

void OuterWinding::add(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
                       std::span<const std::uint32_t> surface, const UnionFind& sets) {
  const auto corners = [&](std::size_t t) {
    return std::array{points[triangles[t][0].index()], points[triangles[t][1].index()],
                      points[triangles[t][2].index()]};
  };
  std::set<std::size_t> has_probe = keep_first(sets);
  std::vector<std::size_t> own(probes_.size(), triangles.size());  // the triangle of each probe
  std::vector<Sign> turn(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = corners(t);
    turn[t] = orient2d(below(a), below(b), below(c));
    if (turn[t] == Sign::zero || !has_probe.insert(sets.find(surface[t])).second) continue;
    // Just below a triangle that faces down the ray meets that triangle itself.
    probes_.push_back({surface[t], {a, b, c}, turn[t] == Sign::negative ? -1 : 0});
    own.push_back(t);
  }
  if (probes_.empty()) return;

  const ProbeGrid grid(probes_);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (turn[t] == Sign::zero) continue;
    const std::array<Point3, 3> triangle = corners(t);
    const auto [min_x, max_x] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [min_y, max_y] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    const Point2 low{min_x, min_y};
    const Point2 high{max_x, max_y};
    grid.in_box(low, high, [&](std::uint32_t i) {
      Probe& probe = probes_[i];
      const Point3& a = probe.corner[0];
      if (own[i] == t || a.x < low.x || a.x > high.x || a.y < low.y || a.y > high.y) return;
      if (!projection_contains(triangle, turn[t], probe)) return;
      // orient3d is positive on the side that sees the triangle counter-clockwise: above
      // it, if its projection is.
      const Sign side = sign_at_probe(probe, [&](const Point3& p) {
        return orient3d(triangle[0], triangle[1], triangle[2], p);
      });
      if (side == -turn[t]) probe.winding += turn[t] == Sign::positive ? 1 : -1;
    });
  }
}

std::vector<long> outer_winding(std::span<const Point3> points,
                                std::span<const TriangleVertices> triangles,
                                std::span<const std::uint32_t> component,
                                std::size_t component_count) {
  const UnionFind sets(component_count);
  OuterWinding outer;
  outer.add(points, triangles, component, sets);
  std::vector<long> winding(component_count, 0);
  for (const Probe& probe : outer.probes(sets)) winding[probe.surface] = probe.winding;
  return winding;
}

}  // namespace tetloft::internal::checking
