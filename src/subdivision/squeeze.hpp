// Squeezing: a constructed vertex is put where every tet around it is positive, however thin
// they are.
//
// A tet between two edges that are parallel but for rounding is thinner than the spacing of
// doubles across it. A point of it, rounded, falls to either side; but as long as its thickness
// is more than a few units in the last place of its finest coordinate, some doubles are in it.
// They are found by bisection over the doubles themselves, by the exact predicate.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "subdivision/nodes.hpp"

namespace tetloft::internal {

/// The doubles from `first` to `last`.
struct DoubleRange {
  double first = 0;
  double last = 0;
};

enum class Axis : std::uint8_t { x, y, z };

/// The doubles of `within` that, put into coordinate `axis` of points[v], leave every tet
/// positive; none if there are none. The other coordinates and vertices stay. A tet's volume
/// is linear in the coordinate, so each tet allows a half-line: what is left is a range.
/// Requires v to be a vertex of each tet.
[[nodiscard]] std::optional<DoubleRange> positive_range(const IdVector<NodeId, Point3>& points,
                                                        std::span<const std::array<NodeId, 4>> tets,
                                                        NodeId v, Axis axis, DoubleRange within);

/// Moves points[v] to where every tet is positive: one coordinate into its positive range, as far
/// as it was outside but not past the middle: z (within `heights`) before y and x (at most `reach`
/// away), where that does not help with another coordinate a few units in the last place aside.
/// False, and points[v] as it was, if none of these leaves all tets positive.
[[nodiscard]] bool squeeze(IdVector<NodeId, Point3>& points,
                           std::span<const std::array<NodeId, 4>> tets, NodeId v,
                           DoubleRange heights, double reach);

}  // namespace tetloft::internal
