// What of a vertex's cell is in a tet, signed.
//
// A cell is the signed sum, over the flags vertex, edge, facet, tet at its site, of orthoschemes:
// the site, the edge's midpoint, the facet's circumcentre and the tet's. Each is a sixth of the
// product of three lengths at right angles: half the edge; from there to the facet's centre,
// negative where the third vertex is on the other side; from there to the tet's centre, likewise
// with the fourth. What sticks out of the cell is taken away by another flag. So every tet is
// looked at once, in coordinates of its own.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <tetloft/point.hpp>

#include "core/vector.hpp"
#include "voronoi/circumcentre3.hpp"
#include "voronoi/near_one.hpp"

namespace tetloft::internal::voronoi {

/// A tet as seen from one of its vertices: edges from there to the others, and the centre.
struct CornerOfTet {
  std::array<Point3, 3> edge;
  Point3 centre;
};

/// A facet of the tet at the vertex, by two edges p and q.
struct FacetAtCorner {
  Point3 normal;           ///< p × q: as long as twice the area
  double lengths = 0;      ///< |p|² |q|²
  double of_p = 0;         ///< |p|² q · (q − p)
  double of_q = 0;         ///< |q|² p · (p − q)
  bool is_turned = false;  ///< does the normal point away from the fourth vertex?
};

[[nodiscard]] inline FacetAtCorner facet_at(const CornerOfTet& at, std::size_t k) {
  using namespace vectors;
  const Point3& p = at.edge[k];
  const Point3& q = at.edge[(k + 1) % 3];
  const double p_squared = dot(p, p), q_squared = dot(q, q);
  const Point3 normal = cross(p, q);
  return {normal, p_squared * q_squared, p_squared * dot(q, q - p), q_squared * dot(p, p - q),
          dot(at.edge[(k + 2) % 3], normal) < 0};
}

/// The part of the vertex's cell.
[[nodiscard]] inline double flag_volume(const CornerOfTet& at) {
  using namespace vectors;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const FacetAtCorner facet = facet_at(at, k);
    // Distance to the facet's plane times twice its area: positive on the fourth vertex' side.
    const double height =
        facet.is_turned ? -dot(at.centre, facet.normal) : dot(at.centre, facet.normal);
    // In the facet the distance of its centre from p is half |p| times the cotangent of the angle
    // opposite, that of its inner product and twice the area; from q likewise.
    sum += height * (facet.of_p + facet.of_q) / (24 * dot(facet.normal, facet.normal));
  }
  return sum;
}

/// How large it might be without what cancels, times how much larger the product of two edges is
/// than their area, which loses as many digits: rounding is some units in the last place of this.
[[nodiscard]] inline double flag_volume_terms(const CornerOfTet& at) {
  using namespace vectors;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const FacetAtCorner facet = facet_at(at, k);
    const double lengths = std::sqrt(facet.lengths * dot(at.centre, at.centre));
    sum += lengths * (std::abs(facet.of_p) + std::abs(facet.of_q)) /
           (24 * dot(facet.normal, facet.normal));
  }
  return sum;
}

/// Calls visit(i, corner i, exponent) for the four vertices: volumes are to be multiplied by
/// 2^(3 exponent).
template <class Visit>
void for_each_corner(std::array<Point3, 4> p, const Visit& visit) {
  using namespace vectors;
  const int exponent = bring_near_one(p, largest_difference(p));
  const Point3 centre = circumcentre_from(p[0], p[1], p[2], p[3]);
  for (std::size_t i = 0; i < 4; ++i) {
    const CornerOfTet corner{{p[(i + 1) % 4] - p[i], p[(i + 2) % 4] - p[i], p[(i + 3) % 4] - p[i]},
                             centre - (p[i] - p[0])};
    visit(i, corner, exponent);
  }
}

}  // namespace tetloft::internal::voronoi
