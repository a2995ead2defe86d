// The centre of the sphere through four points, relative to one of them.
#pragma once

#include <array>

#include <tetloft/point.hpp>

namespace tetloft::internal::voronoi {

/// The largest coordinate in magnitude of a difference from p[0].
[[nodiscard]] double largest_difference(const std::array<Point3, 4>& p);

/// Where that is so far from 1 that products of seven differences might leave the range of doubles,
/// or what they are exact by, divides all points by a power of two near it; its exponent, else 0.
[[nodiscard]] int bring_near_one(std::array<Point3, 4>& p, double largest);

/// The centre minus a, with an error of some units in the last place of its length, of flat tets at
/// most 2^-38 of it; but where the differences of points span more than 2^300. Not a number where
/// the points are coplanar, exactly.
[[nodiscard]] Point3 circumcentre_from(const Point3& a, const Point3& b, const Point3& c,
                                       const Point3& d);

}  // namespace tetloft::internal::voronoi
