// Finding parallel planes. Numbers here are measured, not decided by signs: a file's planes are
// known up to its digits, which is what the tolerance is for.
#include "io/drawing/planes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <tetloft/formats.hpp>

namespace tetloft::internal::io {

namespace {

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Point3 scaled(const Point3& a, double by) { return {a.x * by, a.y * by, a.z * by}; }

Point3 unit(const Point3& a) { return scaled(a, 1 / std::sqrt(dot(a, a))); }

// Cyclic, so that the turn is positive: the axis becomes the last one.
Frame exchange(int axis) {
  constexpr std::array<Point3, 3> kUnits{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};
  const auto unit_of = [&](int i) { return kUnits[static_cast<std::size_t>(i % 3)]; };
  return {{unit_of(axis + 1), unit_of(axis + 2), unit_of(axis)}, {}};
}

// Its last axis is `normal`, a unit vector; the first one lies across the coordinate axis that is
// farthest from it.
Frame turned(const Point3& normal) {
  const std::array<double, 3> size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  Point3 across{1, 0, 0};
  if (size[1] <= size[0] && size[1] <= size[2]) across = {0, 1, 0};
  if (size[2] <= size[0] && size[2] <= size[1]) across = {0, 0, 1};
  const Point3 u = unit(cross(across, normal));
  return {{u, cross(normal, u), normal}, {}};
}

struct Ranges {
  std::vector<double> low;
  std::vector<double> high;
  double thickest = 0;  // of a line
};

Ranges heights_along(const std::vector<PointsOfLine>& lines, const Frame& frame) {
  Ranges ranges;
  for (const PointsOfLine points : lines) {
    double low = unplace(frame, points->front()).z;
    double high = low;
    for (const Point3& p : *points) {
      const double z = unplace(frame, p).z;
      low = std::min(low, z);
      high = std::max(high, z);
    }
    ranges.low.push_back(low);
    ranges.high.push_back(high);
    ranges.thickest = std::max(ranges.thickest, high - low);
  }
  return ranges;
}

double middle(double low, double high) { return low == high ? low : low + (high - low) / 2; }

double usual_gap_of(const Ranges& ranges) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < ranges.low.size(); ++i) {
    heights.push_back(middle(ranges.low[i], ranges.high[i]));
  }
  std::sort(heights.begin(), heights.end());
  std::vector<double> gaps;
  for (std::size_t i = 1; i < heights.size(); ++i) gaps.push_back(heights[i] - heights[i - 1]);
  std::sort(gaps.begin(), gaps.end(), std::greater<>());
  const double half = heights.empty() ? 0 : (heights.back() - heights.front()) / 2;
  double sum = 0;
  for (const double gap : gaps) {
    sum += gap;
    if (sum >= half) return gap;
  }
  return 0;
}

double largest_extent(const std::vector<PointsOfLine>& lines) {
  Point3 low = lines.front()->front();
  Point3 high = low;
  for (const PointsOfLine points : lines) {
    for (const Point3& p : *points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

// Area vectors, of which none says which way: added as the largest one points.
Point3 common_normal(const std::vector<PointsOfLine>& lines) {
  std::vector<Point3> vectors;
  Point3 largest{};
  for (const PointsOfLine points : lines) {
    vectors.push_back(area_vector(*points));
    if (dot(vectors.back(), vectors.back()) > dot(largest, largest)) largest = vectors.back();
  }
  const std::array<double, 3> size{std::abs(largest.x), std::abs(largest.y), std::abs(largest.z)};
  const double widest = std::max({size[0], size[1], size[2]});
  if (!(widest > 0) || !std::isfinite(widest)) return {};
  Point3 sum{};
  for (const Point3& v : vectors) {
    const double sign = dot(v, largest) < 0 ? -1 : 1;
    sum = {sum.x + sign * v.x, sum.y + sign * v.y, sum.z + sign * v.z};
  }
  // Upwards along the coordinate that is largest.
  const double leading = widest == size[2] ? sum.z : widest == size[1] ? sum.y : sum.x;
  const double square = dot(sum, sum);
  if (!(square > 0) || !std::isfinite(square)) return {};
  return unit(leading < 0 ? scaled(sum, -1) : sum);
}

void cluster(PlanesOfLines& planes) {
  std::vector<std::size_t> order(planes.low.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto height = [&](std::size_t i) { return middle(planes.low[i], planes.high[i]); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return height(a) < height(b); });
  planes.plane.assign(order.size(), 0);
  std::size_t first = 0;
  while (first < order.size()) {
    const double lowest = height(order[first]);
    std::size_t end = first;
    std::size_t most = 0;
    double usual = lowest;
    while (end < order.size() && height(order[end]) - lowest <= planes.tolerance) {
      std::size_t same = end;
      while (same < order.size() && height(order[same]) == height(order[end])) ++same;
      if (same - end > most) {
        most = same - end;
        usual = height(order[end]);
      }
      for (; end < same; ++end) planes.plane[order[end]] = planes.height.size();
    }
    planes.height.push_back(usual);
    first = end;
  }
}

}  // namespace

Point3 unplace(const Frame& frame, const Point3& p) {
  const Point3 q = frame.origin == Point3{}
                       ? p
                       : Point3{p.x - frame.origin.x, p.y - frame.origin.y, p.z - frame.origin.z};
  // The axes are orthonormal: the inverse is the transpose.
  const auto& [a, b, c] = frame.axes;
  const Frame inverse{{Point3{a.x, b.x, c.x}, Point3{a.y, b.y, c.y}, Point3{a.z, b.z, c.z}}, {}};
  return place(inverse, q);
}

Point3 area_vector(const std::vector<Point3>& points) {
  Point3 sum{};
  if (points.empty()) return sum;
  const Point3& o = points.front();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Point3& p = points[i];
    const Point3& q = points[i + 1];
    const Point3 v = cross({p.x - o.x, p.y - o.y, p.z - o.z}, {q.x - o.x, q.y - o.y, q.z - o.z});
    sum = {sum.x + v.x, sum.y + v.y, sum.z + v.z};
  }
  return sum;
}

PlanesOfLines planes_of(const std::vector<PointsOfLine>& lines,
                        const std::optional<double>& asked) {
  const double floor = std::ldexp(largest_extent(lines), -20);
  PlanesOfLines planes;
  const auto settle = [&](const Frame& frame) {
    Ranges ranges = heights_along(lines, frame);
    planes.usual_gap = usual_gap_of(ranges);
    planes.tolerance = asked.value_or(std::max(floor, kDefaultPlaneTolerance * planes.usual_gap));
    planes.frame = frame;
    planes.low = std::move(ranges.low);
    planes.high = std::move(ranges.high);
    return ranges.thickest <= planes.tolerance;
  };
  bool found = false;
  for (const int axis : {2, 1, 0}) {
    found = settle(exchange(axis));
    if (found) break;
  }
  if (!found) {
    const Point3 normal = common_normal(lines);
    settle(normal == Point3{} ? Frame{} : turned(normal));
  }
  cluster(planes);
  return planes;
}

double lattice_of(const PlanesOfLines& planes, const std::vector<PointsOfLine>& lines) {
  if (is_exact(planes.frame)) return 0;
  double largest = 0;
  for (const PointsOfLine points : lines) {
    for (const Point3& p : *points) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  return largest > 0 ? std::ldexp(1, std::ilogb(largest) + 1 - 32) : 0;
}

std::optional<double> plane_tolerance(const Drawing& drawing, const std::optional<double>& asked) {
  if (asked || !drawing.exact_heights) return asked;
  return std::numeric_limits<double>::denorm_min();
}

std::optional<std::size_t> off_plane(const PlanesOfLines& planes) {
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < planes.low.size(); ++i) {
    const double extent = planes.high[i] - planes.low[i];
    if (extent <= planes.tolerance) continue;
    if (!worst || extent > planes.high[*worst] - planes.low[*worst]) worst = i;
  }
  return worst;
}

}  // namespace tetloft::internal::io
