// Voronoi edges of two sections in rationals, and whether they cross: by their ends alone.
#pragma once

#include <tetloft/ids.hpp>
#include <tetloft/sections.hpp>

#include "support/rational_geometry.hpp"

namespace tetloft::oracle {

/// A Voronoi edge, from + t · along with t from 0 to 1, or without end.
struct VoronoiEdge {
  Point2Q from, along;
  bool ray = false;
  /// A box around it, with room for the rounding of its corners.
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;

  /// Apart already by their boxes?
  [[nodiscard]] bool is_far_from(const VoronoiEdge& other) const;
};

/// The dual of an edge.
[[nodiscard]] VoronoiEdge voronoi_edge(const ConformingSection& section, EdgeId e);

enum class Meeting { apart, touch, cross };

/// `cross` where both hold one point within that is all they share and they are not parallel;
/// `touch` where they share other points.
[[nodiscard]] Meeting meeting_of(const VoronoiEdge& p, const VoronoiEdge& q);

/// Is one of the edges internal, and the other internal or external?
[[nodiscard]] bool are_reverse(EdgeKind a, EdgeKind b);

}  // namespace tetloft::oracle
