#include "comparison/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetloft::bench {

namespace {

constexpr std::uint32_t kLeaf = 4;  // items; fewer make the tree larger, more the leaves slower

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

std::vector<std::array<Point3, 3>> corners_of(const TriangleMesh& mesh) {
  std::vector<std::array<Point3, 3>> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({mesh.points[a], mesh.points[b], mesh.points[c]});
  }
  return triangles;
}

std::vector<Box3> boxes_of(const std::vector<std::array<Point3, 3>>& triangles) {
  std::vector<Box3> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const Point3& p : triangles[i]) boxes[i].extend(p);
  }
  return boxes;
}

}  // namespace

void Box3::extend(const Point3& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

double Box3::distance2(const Point3& p) const {
  const double x = std::max({low.x - p.x, 0.0, p.x - high.x});
  const double y = std::max({low.y - p.y, 0.0, p.y - high.y});
  const double z = std::max({low.z - p.z, 0.0, p.z - high.z});
  return x * x + y * y + z * z;
}

BoxHierarchy::BoxHierarchy(std::span<const Box3> boxes) : items_(boxes.size()) {
  if (boxes.empty()) return;
  std::iota(items_.begin(), items_.end(), 0U);
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size()), 0});
  for (std::uint32_t at = 0; at < nodes_.size(); ++at) {
    const std::uint32_t begin = nodes_[at].begin, end = nodes_[at].end;
    Box3 box, centres;
    const auto centre = [&](std::uint32_t i) {
      const Box3& b = boxes[i];
      return Point3{b.low.x + b.high.x, b.low.y + b.high.y, b.low.z + b.high.z};
    };
    for (std::uint32_t i = begin; i < end; ++i) {
      box.extend(boxes[items_[i]].low);
      box.extend(boxes[items_[i]].high);
      centres.extend(centre(items_[i]));
    }
    nodes_[at].box = box;
    if (end - begin <= kLeaf) continue;
    const Point3 extent = minus(centres.high, centres.low);
    double Point3::*axis = &Point3::x;
    if (extent.y > extent.*axis) axis = &Point3::y;
    if (extent.z > extent.*axis) axis = &Point3::z;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto first = items_.begin();
    std::nth_element(first + begin, first + middle, first + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return std::pair{centre(a).*axis, a} < std::pair{centre(b).*axis, b};
                     });
    nodes_[at].left = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, begin, middle, 0});
    nodes_.push_back({{}, middle, end, 0});
  }
}

double distance2_to_segment(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 ab = minus(b, a), ap = minus(p, a);
  const double length2 = dot(ab, ab);
  const double t = length2 > 0 ? std::clamp(dot(ap, ab) / length2, 0.0, 1.0) : 0;
  const Point3 off = minus(ap, {t * ab.x, t * ab.y, t * ab.z});
  return dot(off, off);
}

double distance2_to_triangle(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
  const Point3 n = cross(minus(b, a), minus(c, a));
  const double n2 = dot(n, n);
  // Over the triangle the plane is nearest, elsewhere an edge; a flat one has edges alone.
  const auto left_of = [&](const Point3& u, const Point3& v) {
    return dot(cross(minus(v, u), minus(p, u)), n) >= 0;
  };
  if (n2 > 0 && left_of(a, b) && left_of(b, c) && left_of(c, a)) {
    const double height = dot(minus(p, a), n);
    return height * height / n2;
  }
  return std::min({distance2_to_segment(p, a, b), distance2_to_segment(p, b, c),
                   distance2_to_segment(p, c, a)});
}

SurfaceSearch::SurfaceSearch(const TriangleMesh& mesh)
    : triangles_(corners_of(mesh)), boxes_(boxes_of(triangles_)) {}

double SurfaceSearch::distance(const Point3& p) const {
  const double found =
      boxes_.nearest2(p, std::numeric_limits<double>::infinity(), [&](std::uint32_t i) {
        const auto& [a, b, c] = triangles_[i];
        return distance2_to_triangle(p, a, b, c);
      });
  return std::sqrt(found);
}

}  // namespace tetloft::bench
