// See partition.hpp.
#include "delaunay3/partition.hpp"

#include <algorithm>
#include <array>

namespace tetloft::internal::delaunay3_detail {

namespace {

constexpr std::array<double Point3::*, 3> kAxes{&Point3::x, &Point3::y, &Point3::z};

// Points on fewer planes than this across an axis are not cut across it, as tets between two of
// the planes would all be in both parts.
constexpr std::size_t kFewPlanes = 8;

// The axis along which the points extend furthest, of those they have planes enough across; 3 where
// there is none.
std::uint32_t longest_axis(std::span<const Point3> points) {
  std::uint32_t longest = 3;
  double length = 0;
  std::vector<double> values(points.size());
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i].*kAxes[axis];
    std::sort(values.begin(), values.end());
    std::size_t planes = points.empty() ? 0 : 1;
    for (std::size_t i = 1; i < values.size(); ++i) planes += values[i] != values[i - 1] ? 1U : 0U;
    if (planes < kFewPlanes) continue;
    // Halved, so that it does not overflow.
    const double extent = 0.5 * values.back() - 0.5 * values.front();
    if (extent <= length) continue;
    length = extent;
    longest = axis;
  }
  return longest;
}

}  // namespace

Partition::Partition(std::span<Point3> sample, std::size_t parts, bool uneven) : nodes_(1) {
  divide(0, sample, parts, uneven);
}

// Recursive as deep as the logarithm of the parts, or, uneven, a few times that.
void Partition::divide(std::size_t node, std::span<Point3> sample, std::size_t parts, bool uneven) {
  const std::uint32_t axis = parts > 1 ? longest_axis(sample) : 3;
  if (axis == 3) {
    nodes_[node].child = static_cast<std::uint32_t>(parts_++);
    return;
  }
  const std::size_t below = std::max<std::size_t>(parts / (uneven ? 4 : 2), 1);
  const std::size_t middle = sample.size() * below / parts;
  const auto coordinate = kAxes[axis];
  const auto at = sample.begin() + static_cast<std::ptrdiff_t>(middle);
  std::nth_element(sample.begin(), at, sample.end(),
                   [&](const Point3& a, const Point3& b) { return a.*coordinate < b.*coordinate; });
  const std::size_t child = nodes_.size();
  nodes_[node] = {axis, static_cast<std::uint32_t>(child), sample[middle].*coordinate};
  nodes_.resize(child + 2);
  divide(child, sample.first(middle), below, uneven);
  divide(child + 1, sample.subspan(middle), parts - below, uneven);
}

}  // namespace tetloft::internal::delaunay3_detail
