// The boundary of a set of tets in the link of a vertex that all of them have.
//
// A vertex of a slab is on the hull of D, and its link a disc, in which the set is a set of
// triangles. What has one simple cycle as its boundary in a disc is all that is inside it: hence
// connected, and a disc itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "slab/slab.hpp"

namespace tetloft::internal {

/// A directed edge of a link: corners of a tet.
struct LinkEdge {
  int from = 0;
  int to = 0;
};

/// By corner and face of a tet: the edge that the face is in the link of the corner, in the order
/// around the triangle that the tet is there.
inline constexpr auto kLinkEdge = [] {
  std::array<std::array<LinkEdge, 4>, 4> edges{};
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const std::array<int, 3>& link = kFaceVertex[corner];
    for (std::size_t k = 0; k < 3; ++k) {
      edges[corner][static_cast<std::size_t>(link[k])] = {link[(k + 1) % 3], link[(k + 2) % 3]};
    }
  }
  return edges;
}();

/// kLinkEdge, of ints.
[[nodiscard]] constexpr const LinkEdge& link_edge(int corner, int face) {
  return kLinkEdge[static_cast<std::size_t>(corner)][static_cast<std::size_t>(face)];
}

/// One vertex after the other; add() all edges between a triangle of the set and none.
class LinkBoundary {
 public:
  explicit LinkBoundary(std::size_t slab_vertices) : step_from_(slab_vertices) {}

  void clear() {
    ++epoch_;
    edges_ = 0;
    pinched_ = false;
  }

  void add(SlabVertexId from, SlabVertexId to) {
    Step& step = step_from_[from];
    const bool pinched = step.epoch == epoch_;
    pinched_ = pinched_ || pinched;
    step = {epoch_, pinched, to};
    start_ = from;
    ++edges_;
  }

  /// Is there a vertex with more than two edges?
  [[nodiscard]] bool is_pinched() const { return pinched_; }
  /// Is this one, which was not asked for yet?
  [[nodiscard]] bool take_pinch(SlabVertexId v) {
    Step& step = step_from_[v];
    if (step.epoch != epoch_ || !step.pinched) return false;
    step.pinched = false;
    return true;
  }

  /// As many edges lead to a vertex as from it: cycles, unless there is a pinch.
  [[nodiscard]] bool is_simple_cycle() const {
    if (pinched_ || edges_ == 0) return false;
    std::size_t steps = 1;
    for (SlabVertexId v = step_from_[start_].to; v != start_; v = step_from_[v].to) ++steps;
    return steps == edges_;
  }

 private:
  struct Step {
    std::uint32_t epoch = 0;  // of the vertex in whose link it was added
    bool pinched = false;     // there is another
    SlabVertexId to;
  };

  IdVector<SlabVertexId, Step> step_from_;
  std::uint32_t epoch_ = 0;
  std::size_t edges_ = 0;
  SlabVertexId start_;  // of the last edge
  bool pinched_ = false;
};

}  // namespace tetloft::internal
