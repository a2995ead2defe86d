#include "contact/fans.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetloft::internal::contact_detail {

namespace {

// Fewer triangles than this are as fast by their boxes alone.
constexpr std::uint32_t kLeastDegree = 64;

// Far above the rounding of a direction, some 2^-51, and far below the angles that tell.
constexpr double kSlack = 0x1p-40;

constexpr Box kAllDirections({-2, -2, -2}, {2, 2, 2});

}  // namespace

Box directions_of(std::span<const Point3> points, VertexId apex, const TriangleVertices& t) {
  const Point3& o = points[apex.index()];
  std::array<Point3, 3> unit;
  std::size_t n = 0;
  for (const VertexId v : t) {
    if (v == apex) continue;
    const Point3& p = points[v.index()];
    Point3 d{p.x - o.x, p.y - o.y, p.z - o.z};
    // By the largest first, lest squares over- or underflow.
    const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return kAllDirections;
    d = {d.x / largest, d.y / largest, d.z / largest};
    const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    unit[n++] = {d.x / length, d.y / length, d.z / length};
  }
  double chord2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const double x = unit[i].x - unit[j].x, y = unit[i].y - unit[j].y, z = unit[i].z - unit[j].z;
      chord2 = std::max(chord2, x * x + y * y + z * z);
    }
  }
  // The flat triangle of the unit vectors has a circumradius of at most chord / √3: up to a chord
  // of 1 its points are within chord² / 3 of the sphere. Wider ones may hold the apex.
  if (n == 0 || chord2 > 1) return kAllDirections;
  const double slack = chord2 / 2 + kSlack;
  Box box{unit[0], unit[0]};
  for (std::size_t i = 1; i < n; ++i) box.extend({unit[i], unit[i]});
  return {{box.low.x - slack, box.low.y - slack, box.low.z - slack},
          {box.high.x + slack, box.high.y + slack, box.high.z + slack}};
}

Fans gather_fans(std::size_t vertices, std::span<const TriangleVertices> triangles,
                 std::span<const std::uint32_t> members) {
  Fans result;
  std::vector<std::uint32_t> degree(vertices, 0);
  for (const std::uint32_t i : members) {
    for (const VertexId v : triangles[i]) ++degree[v.index()];
  }
  std::vector<std::uint32_t> fan_at(vertices, Fans::kNone);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (degree[v] < kLeastDegree) continue;
    fan_at[v] = static_cast<std::uint32_t>(result.fans.size());
    result.fans.push_back({VertexId(v), {}});
  }
  if (result.fans.empty()) {
    result.rest.assign(members.begin(), members.end());
    return result;
  }
  result.fan_of.assign(triangles.size(), Fans::kNone);
  for (const std::uint32_t i : members) {
    VertexId apex = triangles[i][0];
    for (const VertexId v : triangles[i]) {
      const std::uint32_t d = degree[v.index()];
      const std::uint32_t best = degree[apex.index()];
      if (d > best || (d == best && v < apex)) apex = v;
    }
    const std::uint32_t fan = fan_at[apex.index()];
    if (fan == Fans::kNone) {
      result.rest.push_back(i);
      continue;
    }
    result.fan_of[i] = fan;
    result.fans[fan].members.push_back(i);
  }
  return result;
}

}  // namespace tetloft::internal::contact_detail
