// The centre of the sphere through four points, relative to one of them.
#pragma once

#include <tetloft/point.hpp>

namespace tetloft::internal::voronoi {

/// The centre minus a, with an error of some units in the last place of its length, of flat tets at
/// most 2^-38 of it; but where the differences of points span more than 2^300. Not a number where
/// the points are coplanar, exactly.
[[nodiscard]] Point3 circumcentre_from(const Point3& a, const Point3& b, const Point3& c,
                                       const Point3& d);

}  // namespace tetloft::internal::voronoi
