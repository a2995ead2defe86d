// The contours of two sections as one planar graph, and the cycles that bound its faces.
//
// Arcs run from node to node; a contour without nodes is an arc of its own, a loop. Pieces that
// both sections share are one arc. Half-arc 2k follows arc k, 2k + 1 comes back; the face of a
// half-arc is on its left. A cycle is a component of a face's border, seen from the face: at a node
// where the face touches itself the cycle turns within one sector, as open sets demand.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sections/overlay_curves.hpp"
#include "sections/overlay_nodes.hpp"

namespace tetloft::internal::sections {

inline constexpr std::uint32_t kNone = 0xFFFFFFFFU;

struct OverlayArc {
  std::array<std::uint32_t, 2> contour{kNone, kNone};  ///< of each section, if it runs there
  /// Does half-arc 2k follow the contour of the section?
  std::array<bool, 2> along{true, true};
};

struct OverlayCycle {
  std::uint32_t first;     ///< a half-arc of it
  bool counter_clockwise;  ///< the outer cycle of a face
};

class OverlayGraph {
 public:
  /// `curves` must outlive it.
  explicit OverlayGraph(const TwoCurves& curves);

  [[nodiscard]] const OverlayNodes& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<OverlayArc>& arcs() const { return arcs_; }
  [[nodiscard]] const std::vector<OverlayCycle>& cycles() const { return cycles_; }
  /// kNone for the upper section's half-arcs of pieces that are the lower one's as well.
  [[nodiscard]] std::uint32_t cycle(std::uint32_t half) const { return cycle_[half]; }
  [[nodiscard]] bool is_loop(std::uint32_t half) const { return half / 2 >= first_loop_; }
  /// The next half-arc of the cycle.
  [[nodiscard]] std::uint32_t next(std::uint32_t half) const;

  /// Where a half-arc leaves: the node, and the place among those that leave there,
  /// counter-clockwise from straight down. Not of loops.
  struct Leaving {
    std::uint32_t node = kNone;
    std::uint8_t place = 0;
    bool rises = false;
  };
  [[nodiscard]] const Leaving& leaving(std::uint32_t half) const { return leaving_[half]; }

  /// Does the left side of the half-arc lie inside the contour of section s that it follows?
  [[nodiscard]] bool is_inside(std::uint32_t half, std::size_t s) const;
  /// The half-arc, the same or one before it clockwise about its node, that follows section s:
  /// what is on the left of it by that section is on the left of `half`. Not of loops.
  [[nodiscard]] std::uint32_t clockwise_on(std::uint32_t half, std::size_t s) const;
  /// The half-arc that follows the contour of section s from its k-th pass of a node on. Requires
  /// that it is no piece of both, or s the lower section.
  [[nodiscard]] std::uint32_t half_from(std::size_t s, std::uint32_t pass) const {
    return static_cast<std::uint32_t>(2 * (pass + (s == 0 ? 0 : nodes_.nodes.size())));
  }
  /// The half-arc along a contour without nodes.
  [[nodiscard]] std::uint32_t loop(std::size_t s, std::uint32_t contour) const {
    return loop_[s][contour];
  }

 private:
  struct Star {
    std::array<std::uint32_t, 4> half{};  // leaving, counter-clockwise from straight down
    std::uint32_t degree = 0;
  };

  void make_arcs();
  void make_star(std::uint32_t node);
  void make_loops();
  void walk_cycles();
  [[nodiscard]] std::int32_t turns_within(std::uint32_t half) const;

  TwoCurves curves_;
  OverlayNodes nodes_;
  std::vector<OverlayArc> arcs_;  // of the lower section, of the upper one, loops
  std::uint32_t first_loop_ = 0;
  std::vector<Star> stars_;          // of nodes
  std::vector<Leaving> leaving_;     // of half-arcs
  std::vector<std::int32_t> turns_;  // of arcs: half turns on the way, as half-arc 2k goes
  std::array<std::vector<std::uint32_t>, 2> loop_;  // of contours
  std::vector<std::uint32_t> cycle_;                // of half-arcs
  std::vector<OverlayCycle> cycles_;
};

}  // namespace tetloft::internal::sections
