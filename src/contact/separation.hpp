// Pairs of triangles that a plane keeps apart, found without a predicate.
//
// A linear form whose coefficients are powers of two, at least 1, and at most two of them not zero,
// is computed with one rounding: products are exact, and a sum with zero is. Rounding is monotone,
// and so are taking off a constant and rounding to a float; so where stored values differ, the
// exact ones differ in the same way. If all values of one triangle are below all of another, they
// have no common point. If they share a vertex, and the others of one are above it and those of the
// other below, they have that vertex alone in common, unless one of them is degenerate.
//
// That decides most pairs whose boxes meet. Which forms are asked is a matter of speed, not of
// truth.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal::contact_detail {

class Separation {
 public:
  /// Heights are weighed against widths as the triangles with these numbers have them.
  Separation(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
             std::span<const std::uint32_t> members);

  /// Is it certain that two triangles without common vertices have no common point?
  [[nodiscard]] bool apart(const TriangleVertices& a, const TriangleVertices& b) const;
  /// Is it certain that two triangles, neither degenerate, have nothing in common but the first
  /// vertex of both?
  [[nodiscard]] bool meet_in_first_alone(const TriangleVertices& a,
                                         const TriangleVertices& b) const;

 private:
  // All forms of a vertex; a multiple of four, as processors take them.
  static constexpr std::size_t kForms = 24;
  using Values = std::array<float, kForms>;

  [[nodiscard]] const Values& values(VertexId v) const { return values_[v.index()]; }

  std::vector<Values> values_;  // by vertex; empty where coordinates are too large
};

}  // namespace tetloft::internal::contact_detail
