// Where contours of two sections meet: crossings, vertices on edges, common vertices.
//
// Contours of one section are simple and disjoint, so a point has at most one edge or vertex of
// each. Where edges run along each other, every vertex of the shared run is a node.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sections/overlay_curves.hpp"

namespace tetloft::internal::sections {

using TwoCurves = std::array<const OverlayCurves*, 2>;  ///< of the lower section, of the upper one

/// A point of both sections' contours: on edge[s] of each, at its start or between its ends.
struct OverlayNode {
  std::array<std::uint32_t, 2> edge;
  std::array<bool, 2> at_start;

  [[nodiscard]] bool is_crossing() const { return !at_start[0] && !at_start[1]; }
};

/// All nodes, and in what order each section's contours pass through them.
struct OverlayNodes {
  explicit OverlayNodes(const TwoCurves& curves);

  /// The places of the nodes on the contour of section s, as a range of passes[s].
  struct Range {
    std::uint32_t first, last;
  };

  std::vector<OverlayNode> nodes;
  std::array<std::vector<std::uint32_t>, 2> passes;  ///< nodes along contours, one after another
  std::array<std::vector<std::uint32_t>, 2> place;   ///< place[s][node] in passes[s]
  std::array<std::vector<Range>, 2> range;           ///< range[s][contour] of passes[s]
};

}  // namespace tetloft::internal::sections
