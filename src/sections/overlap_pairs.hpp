// The terms of the area that two regions share.
//
// With the regions as signed trapezoids (trapezoids.hpp) and the base levels cancelled,
//   area(A ∩ B) = Σ side_e side_f ∫ min(e(x) − f(x), 0) dx
// over all pairs of an edge e of A and an edge f of B, x in their common range: only pairs
// where e runs below f somewhere contribute. No intersection point is ever constructed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sections/trapezoids.hpp"

namespace tetloft::internal::sections {

/// As visit_pairs() needs edges, independently of the order of contours and vertices.
inline void sort_for_pairs(std::vector<Trapezoid>& edges) {
  std::sort(edges.begin(), edges.end(), [](const Trapezoid& e, const Trapezoid& f) {
    return e.left == f.left ? canonical_less(e.right, f.right) : canonical_less(e.left, f.left);
  });
}

/// The edges that have a common range of x with `box`, sorted.
inline std::vector<Trapezoid> edges_for_pairs(const std::vector<Trapezoid>& edges,
                                              const Box2& box) {
  std::vector<Trapezoid> result;
  for (const Trapezoid& e : edges) {
    if (e.left.x < box.x1 && box.x0 < e.right.x) result.push_back(e);
  }
  sort_for_pairs(result);
  return result;
}

/// Calls visit(i, j) for all edges a[i] and b[j] with a common range of x where a[i] is not
/// wholly above b[j]. Requires both sorted.
template <class Edge, class Visit>
void visit_pairs(const std::vector<Edge>& a, const std::vector<Edge>& b, Visit visit) {
  const auto low = [](const Trapezoid& e) { return std::min(e.left.y, e.right.y); };
  const auto high = [](const Trapezoid& e) { return std::max(e.left.y, e.right.y); };
  // The edges that the vertical line at the current left end still meets.
  std::vector<std::uint32_t> open_a;
  std::vector<std::uint32_t> open_b;
  // Calls body(k) for the open edges, dropping those that end at or before x.
  const auto sweep = [](std::vector<std::uint32_t>& open, const std::vector<Edge>& edges, double x,
                        auto body) {
    for (std::size_t k = 0; k < open.size();) {
      if (edges[open[k]].right.x <= x) {
        open[k] = open.back();
        open.pop_back();
      } else {
        body(open[k++]);
      }
    }
  };
  std::uint32_t i = 0;
  std::uint32_t j = 0;
  while ((i < a.size() || !open_a.empty()) && (j < b.size() || !open_b.empty()) &&
         (i < a.size() || j < b.size())) {
    if (j == b.size() || (i < a.size() && a[i].left.x <= b[j].left.x)) {
      const double bottom = low(a[i]);
      sweep(open_b, b, a[i].left.x, [&](std::uint32_t f) {
        if (bottom < high(b[f])) visit(i, f);
      });
      open_a.push_back(i++);
    } else {
      const double top = high(b[j]);
      sweep(open_a, a, b[j].left.x, [&](std::uint32_t e) {
        if (low(a[e]) < top) visit(e, j);
      });
      open_b.push_back(j++);
    }
  }
}

}  // namespace tetloft::internal::sections
