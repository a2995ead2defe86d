// Which rows of a window an edge passes, and where: even-odd, each sample with what is to its left.
#pragma once

#include <cmath>
#include <cstdint>

#include <tetloft/point.hpp>

#include "motion/lattice_window.hpp"

namespace tetloft::internal::motion {

/// The least index of [low, high] that is at least `at`.
inline std::int64_t first_index(double at, std::int64_t low, std::int64_t high) {
  const double k = std::ceil(at);
  if (!(k > static_cast<double>(low))) return low;
  return k < static_cast<double>(high) ? static_cast<std::int64_t>(k) : high;
}

/// Calls visit(i, j) for the rows that the edge between p and q passes, whichever way it runs: all
/// samples from i on change sides.
template <class Visit>
void visit_passed(const Point2& p, const Point2& q, const LatticeWindow& w, const Visit& visit) {
  const bool up = p.y < q.y;
  const Point2& low = up ? p : q;
  const Point2& high = up ? q : p;
  const std::int64_t end = first_index(high.y, w.j0, w.j1);
  for (std::int64_t j = first_index(low.y, w.j0, w.j1); j < end; ++j) {
    const double t = (static_cast<double>(j) - low.y) / (high.y - low.y);
    visit(first_index(low.x + t * (high.x - low.x), w.i0, w.i1), j);
  }
}

}  // namespace tetloft::internal::motion
