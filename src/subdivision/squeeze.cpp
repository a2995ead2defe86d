#include "subdivision/squeeze.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include <tetloft/predicates.hpp>

namespace tetloft::internal {

namespace {

// Doubles by rank: neighbouring doubles have neighbouring ranks, both zeros have rank 0.
std::int64_t rank(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : -(bits & INT64_MAX);
}

double of_rank(std::int64_t rank) {
  return rank >= 0 ? std::bit_cast<double>(rank) : -std::bit_cast<double>(-rank);
}

// Halfway between ranks of any signs, without overflow.
std::int64_t halfway(std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(
                   (static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low)) / 2);
}

double& coordinate(Point3& p, Axis axis) {
  return axis == Axis::x ? p.x : axis == Axis::y ? p.y : p.z;
}

// The most units in the last place a second coordinate is moved aside. A choice: each unit is six
// lines to search where nothing is found; a tet that no line within 8 of them meets is
// thinner than what squeezing is for, and is refused. Neither half nor twice as many changes a
// sample.
constexpr int kAside = 8;

}  // namespace

std::optional<DoubleRange> positive_range(const IdVector<NodeId, Point3>& points,
                                          std::span<const std::array<NodeId, 4>> tets, NodeId v,
                                          Axis axis, DoubleRange within) {
  std::int64_t first = rank(within.first);
  std::int64_t last = rank(within.last);
  for (const std::array<NodeId, 4>& tet : tets) {
    const auto positive = [&](std::int64_t at) {
      std::array<Point3, 4> corner;
      for (std::size_t i = 0; i < 4; ++i) {
        corner[i] = points[tet[i]];
        if (tet[i] == v) coordinate(corner[i], axis) = of_rank(at);
      }
      return orient3d(corner[0], corner[1], corner[2], corner[3]) == Sign::positive;
    };
    if (first > last) return std::nullopt;
    const bool at_first = positive(first);
    const bool at_last = positive(last);
    if (!at_first && !at_last) return std::nullopt;
    if (at_first && at_last) continue;
    // `in` stays positive, `out` does not, until they are neighbours.
    std::int64_t in = at_first ? first : last;
    std::int64_t out = at_first ? last : first;
    while (in + 1 < out || out + 1 < in) {
      const std::int64_t middle = in < out ? halfway(in, out) : halfway(out, in);
      (positive(middle) ? in : out) = middle;
    }
    (at_first ? last : first) = in;
  }
  if (first > last) return std::nullopt;
  return DoubleRange{of_rank(first), of_rank(last)};
}

bool squeeze(IdVector<NodeId, Point3>& points, std::span<const std::array<NodeId, 4>> tets,
             NodeId v, DoubleRange heights, double reach) {
  Point3& p = points[v];
  const Point3 before = p;
  struct Line {
    Axis along, aside;
    DoubleRange within;
  };
  const std::array<Line, 3> lines{{{Axis::z, Axis::x, heights},
                                   {Axis::y, Axis::x, {p.y - reach, p.y + reach}},
                                   {Axis::x, Axis::y, {p.x - reach, p.x + reach}}}};
  for (int step = 0; step <= kAside; ++step) {
    for (const int ulps : {step, -step}) {
      for (const auto& [along, aside, within] : lines) {
        p = before;
        coordinate(p, aside) = of_rank(rank(coordinate(p, aside)) + ulps);
        if (const auto range = positive_range(points, tets, v, along, within)) {
          // As far inside as it was outside, or in the middle.
          const double half = 0.5 * (range->last - range->first);
          double& value = coordinate(p, along);
          if (value < range->first) {
            value = range->first + std::min(half, range->first - value);
          } else if (value > range->last) {
            value = range->last - std::min(half, value - range->last);
          }
          return true;
        }
      }
    }
  }
  p = before;
  return false;
}

}  // namespace tetloft::internal
