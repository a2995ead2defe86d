#include "triangulation3/auxiliary.hpp"

#include <array>
#include <cmath>

#include "delaunay3/affine_basis.hpp"

namespace tetloft::internal::triangulation3 {

namespace {

// Another number of about the size.
double other(double v) {
  if (v == 0) return 1;
  return std::abs(v) < 1 ? 2 * v : v / 2;
}

}  // namespace

// Of three points each moved along one axis from the first one, those are taken that are not in
// the affine hull of all before.
std::vector<Point3> auxiliary_points(std::span<const Point3> basis) {
  const Point3 a = basis.front();
  const std::array<Point3, 3> moved{
      {{other(a.x), a.y, a.z}, {a.x, other(a.y), a.z}, {a.x, a.y, other(a.z)}}};
  std::vector<Point3> points(basis.begin(), basis.end());
  points.insert(points.end(), moved.begin(), moved.end());
  const delaunay3_detail::AffineBasis all = delaunay3_detail::affine_basis(points);
  std::vector<Point3> result;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(all.dimension); ++k) {
    if (all.place[k] >= basis.size()) result.push_back(points[all.place[k]]);
  }
  return result;
}

}  // namespace tetloft::internal::triangulation3
