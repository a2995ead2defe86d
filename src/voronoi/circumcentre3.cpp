#include "voronoi/circumcentre3.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <tetloft/voronoi.hpp>

#include "arithmetic/rounded_sum.hpp"
#include "voronoi/moderate.hpp"
#include "voronoi/near_one.hpp"

namespace tetloft {

namespace internal::voronoi {

namespace {

// Determinants by Cramer's rule, rounded; the centre is `minors` over twice `determinant`.
struct SphereMinors {
  Point3 minors;
  double determinant = 0;
};

// With numbers as difference(u, v) makes them: doubles, their pairs, or exact sums.
template <class Difference>
SphereMinors sphere_minors(const std::array<Point3, 4>& p, const Difference& difference) {
  const auto bx = difference(p[1].x, p[0].x), by = difference(p[1].y, p[0].y),
             bz = difference(p[1].z, p[0].z);
  const auto cx = difference(p[2].x, p[0].x), cy = difference(p[2].y, p[0].y),
             cz = difference(p[2].z, p[0].z);
  const auto dx = difference(p[3].x, p[0].x), dy = difference(p[3].y, p[0].y),
             dz = difference(p[3].z, p[0].z);
  const auto bb = bx * bx + by * by + bz * bz;
  const auto cc = cx * cx + cy * cy + cz * cz;
  const auto dd = dx * dx + dy * dy + dz * dz;
  const auto cd_x = cy * dz - cz * dy, cd_y = cz * dx - cx * dz, cd_z = cx * dy - cy * dx;
  const auto db_x = dy * bz - dz * by, db_y = dz * bx - dx * bz, db_z = dx * by - dy * bx;
  const auto bc_x = by * cz - bz * cy, bc_y = bz * cx - bx * cz, bc_z = bx * cy - by * cx;
  return {{rounded_sum(bb * cd_x + cc * db_x + dd * bc_x),
           rounded_sum(bb * cd_y + cc * db_y + dd * bc_y),
           rounded_sum(bb * cd_z + cc * db_z + dd * bc_z)},
          rounded_sum(bx * cd_x + by * cd_y + bz * cd_z)};
}

// With enough digits: of u = 2^-53 and rounded differences the error of the determinant is below
// 20 u times the product of the edges, and of the minors below 20 u times that and the sum of the
// edges, which are at most two radii each; with pairs of doubles 200 u² takes the place of 20 u. So
// at these limits the determinant's is below 2^-40 of it, and the centre's below
// (20 u / kFlat) · (1 + 6 / 2) < 2^-38 radii.
SphereMinors sphere_minors_within(const std::array<Point3, 4>& p) {
  constexpr double kFlat = 0x1p-8, kFlatter = 0x1p-56;
  const double edges = product_of_edges(p);
  const SphereMinors rough = sphere_minors(p, [](double u, double v) { return u - v; });
  if (std::abs(rough.determinant) > kFlat * edges) return rough;
  const SphereMinors fine = sphere_minors(p, [](double u, double v) {
    const Rounded exact = two_difference(u, v);
    return DoubleDouble{exact.value, exact.error};
  });
  if (std::abs(fine.determinant) > kFlatter * edges) return fine;
  return sphere_minors(p, [](double u, double v) { return to_expansion(two_difference(u, v)); });
}

}  // namespace

Point3 circumcentre_from(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::array<Point3, 4> p{a, b, c, d};
  const double largest = largest_difference(p);
  if (largest == 0 || !std::isfinite(largest)) return {kNone, kNone, kNone};
  const int exponent = bring_near_one(p, largest);
  const SphereMinors found = sphere_minors_within(p);
  if (found.determinant == 0) return {kNone, kNone, kNone};
  const double twice = 2 * found.determinant;
  return times_power_of_two(
      {found.minors.x / twice, found.minors.y / twice, found.minors.z / twice}, exponent);
}

}  // namespace internal::voronoi

Sphere3 circumsphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Point3 r = internal::voronoi::circumcentre_from(a, b, c, d);
  if (std::isnan(r.x)) return {r, std::numeric_limits<double>::infinity()};
  return {{a.x + r.x, a.y + r.y, a.z + r.z}, std::hypot(r.x, r.y, r.z)};
}

}  // namespace tetloft
