// See affine_basis.hpp.
#include "delaunay3/affine_basis.hpp"

#include <tetloft/predicates.hpp>

namespace tetloft::internal::delaunay3_detail {

bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  // The components of (b − a) × (c − a) are the orientations of the three projections.
  return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == Sign::zero &&
         orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == Sign::zero &&
         orient2d({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == Sign::zero;
}

AffineBasis affine_basis(std::span<const Point3> points) {
  AffineBasis basis;
  const auto independent = [&](const Point3& p) {
    const auto member = [&](std::size_t k) { return points[basis.place[k]]; };
    switch (basis.dimension) {
      case -1: return true;
      case 0: return p != member(0);
      case 1: return !collinear(member(0), member(1), p);
      default: return orient3d(member(0), member(1), member(2), p) != Sign::zero;
    }
  };
  for (std::size_t i = 0; i < points.size() && basis.dimension < 3; ++i) {
    if (!independent(points[i])) continue;
    ++basis.dimension;
    basis.place[static_cast<std::size_t>(basis.dimension)] = i;
  }
  return basis;
}

}  // namespace tetloft::internal::delaunay3_detail
