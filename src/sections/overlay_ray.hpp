// What a ray straight down from a point meets first of the contours of two sections, exactly.
#pragma once

#include <cstdint>

#include <tetloft/point.hpp>

#include "sections/overlay_graph.hpp"

namespace tetloft::internal::sections {

class OverlayRay {
 public:
  /// Both must outlive it.
  OverlayRay(const TwoCurves& curves, const OverlayGraph& graph) : curves_(curves), graph_(graph) {}

  /// The half-arc with p's side on its left, kNone where nothing is below. The ray is tilted, as
  /// canonical order is: it runs infinitesimally to the right of p, and so through no node.
  [[nodiscard]] std::uint32_t half_below(const Point2& p) const;
  /// Is p on a contour of either section?
  [[nodiscard]] bool meets(const Point2& p) const;

 private:
  struct Edge {
    std::uint32_t section = 0;
    std::uint32_t edge = kNone;
  };
  [[nodiscard]] Edge edge_below(const Point2& p) const;
  [[nodiscard]] bool is_above(const Edge& f, const Edge& e, double x) const;
  [[nodiscard]] bool is_left(const OverlayNode& node, const Edge& e, double x) const;
  [[nodiscard]] std::uint32_t half_of(const Edge& e, double x) const;

  TwoCurves curves_;
  const OverlayGraph& graph_;
};

}  // namespace tetloft::internal::sections
