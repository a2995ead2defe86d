// Contact of two triangles with small integer coordinates, from linear algebra alone.
//
// The common points are Σ αᵢ aᵢ = Σ βⱼ bⱼ with α, β >= 0 of sum 1: a polytope, whose extreme
// points have supports (sets of nonzero αᵢ, βⱼ) that determine them. So solve the linear
// system for every support; contact iff some solution is not in the shared simplex, which
// is convex and therefore holds all common points iff it holds the extreme ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::contact_test {

using Int = std::int64_t;
using Grid3 = std::array<Int, 3>;

/// at / scale, scale > 0.
struct RationalPoint {
  Grid3 at{};
  Int scale = 1;
};

/// Five equations in up to five unknowns: coefficients, then the right-hand side.
using System = std::array<std::array<Int, 6>, 5>;

/// A solution as numerators over one denominator > 0.
struct Solution {
  std::array<Int, 5> numerator{};
  Int denominator = 1;
};

/// The solution of the first n columns and column n as right-hand side, where it is unique.
/// Bareiss elimination: every entry is a minor of the matrix, so all divisions are exact.
inline std::optional<Solution> solve(System rows, std::size_t n) {
  Int previous = 1;
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t p = c;
    while (p < 5 && rows[p][c] == 0) ++p;
    if (p == 5) return std::nullopt;
    std::swap(rows[p], rows[c]);
    for (std::size_t r = 0; r < 5; ++r) {
      if (r == c) continue;
      const Int factor = rows[r][c];
      for (std::size_t k = 0; k <= n; ++k) {
        rows[r][k] = (rows[c][c] * rows[r][k] - factor * rows[c][k]) / previous;
      }
    }
    previous = rows[c][c];
  }
  for (std::size_t r = n; r < 5; ++r) {
    if (rows[r][n] != 0) return std::nullopt;
  }
  Solution x;
  x.denominator = previous < 0 ? -previous : previous;
  for (std::size_t i = 0; i < n; ++i) x.numerator[i] = previous < 0 ? -rows[i][n] : rows[i][n];
  return x;
}

inline Grid3 minus(const Grid3& p, const Grid3& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline bool collinear(const Grid3& a, const Grid3& b, const Grid3& c) {
  const Grid3 u = minus(b, a);
  const Grid3 v = minus(c, a);
  return u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2];
}

inline bool on_segment(const RationalPoint& x, const Grid3& s, const Grid3& t) {
  Grid3 scaled_s{};
  Grid3 scaled_t{};
  for (std::size_t k = 0; k < 3; ++k) {
    scaled_s[k] = x.scale * s[k];
    scaled_t[k] = x.scale * t[k];
    if ((x.at[k] < scaled_s[k]) != (x.at[k] < scaled_t[k]) || x.at[k] == scaled_s[k] ||
        x.at[k] == scaled_t[k]) {
      continue;
    }
    return false;
  }
  return collinear(scaled_s, scaled_t, x.at);
}

/// The extreme points of the intersection of two closed triangles; some more than once.
inline std::vector<RationalPoint> extreme_common_points(const std::array<Grid3, 3>& a,
                                                        const std::array<Grid3, 3>& b) {
  std::vector<RationalPoint> result;
  for (std::size_t s = 1; s < 8; ++s) {
    for (std::size_t t = 1; t < 8; ++t) {
      // Six unknowns in five equations have no unique solution.
      if (s == 7 && t == 7) continue;
      System rows{};
      std::size_t n = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        if ((s >> i & 1U) == 0) continue;
        for (std::size_t k = 0; k < 3; ++k) rows[k][n] = a[i][k];
        rows[3][n++] = 1;
      }
      const std::size_t alphas = n;
      for (std::size_t j = 0; j < 3; ++j) {
        if ((t >> j & 1U) == 0) continue;
        for (std::size_t k = 0; k < 3; ++k) rows[k][n] = -b[j][k];
        rows[4][n++] = 1;
      }
      rows[3][n] = rows[4][n] = 1;
      const std::optional<Solution> x = solve(rows, n);
      if (!x) continue;
      bool feasible = true;
      for (const Int numerator : x->numerator) feasible = feasible && numerator >= 0;
      if (!feasible) continue;
      RationalPoint p{{}, x->denominator};
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < alphas; ++i) p.at[k] += rows[k][i] * x->numerator[i];
      }
      result.push_back(p);
    }
  }
  return result;
}

/// The contract of triangles_touch().
inline bool oracle_touch(const std::vector<Grid3>& points, const TriangleVertices& a,
                         const TriangleVertices& b) {
  std::array<Grid3, 3> pa{};
  std::array<Grid3, 3> pb{};
  std::vector<Grid3> shared;
  for (std::size_t i = 0; i < 3; ++i) {
    pa[i] = points[a[i].index()];
    pb[i] = points[b[i].index()];
    for (const VertexId v : b) {
      if (v == a[i]) shared.push_back(pa[i]);
    }
  }
  const std::vector<RationalPoint> common = extreme_common_points(pa, pb);
  if (collinear(pa[0], pa[1], pa[2]) || collinear(pb[0], pb[1], pb[2])) return !common.empty();
  if (shared.size() == 3) return true;
  for (const RationalPoint& x : common) {
    if (shared.empty()) return true;
    if (!on_segment(x, shared.front(), shared.back())) return true;
  }
  return false;
}

}  // namespace tetloft::contact_test
