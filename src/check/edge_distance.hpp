// How far an inserted vertex lies off its contour edge, exactly.
#pragma once

#include <tetloft/point.hpp>

namespace tetloft::internal::checking {

/// The unit in the last place of the largest coordinate magnitude of a and b: 2^(e − 52)
/// for a magnitude in [2^e, 2^(e + 1)), and never below 2^-1074.
[[nodiscard]] double edge_ulp(const Point2& a, const Point2& b);

struct EdgeDistance {
  bool within = false;  ///< exact: the distance of p from the line is at most `ulps` ulps
  double ulps = 0;      ///< that distance in ulps, rounded
};

/// The distance of p from the line through a and b (Euclidean). Requires a ≠ b, finite
/// coordinates, ulps ≥ 0. `ulps` times the ulp is rounded once where it is denormal or
/// overflows.
[[nodiscard]] EdgeDistance distance_from_edge(const Point2& a, const Point2& b, const Point2& p,
                                              double ulps);

/// Exact: q lies strictly farther along the direction from a to b than p.
[[nodiscard]] bool advances(const Point2& a, const Point2& b, const Point2& p, const Point2& q);

}  // namespace tetloft::internal::checking
