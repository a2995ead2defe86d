#include "check/dihedral.hpp"

#include <cmath>
#include <cstddef>

#include <tetloft/tet_mesh.hpp>

#include "core/vector.hpp"

namespace tetloft::internal::checking {

std::array<double, 6> dihedral_degrees(const std::array<Point3, 4>& corner) {
  constexpr double kDegrees = 180 / 3.14159265358979323846;
  using vectors::cross, vectors::dot, vectors::operator-;
  const auto difference = [&](std::size_t i, std::size_t j) { return corner[j] - corner[i]; };
  std::array<double, 6> angles{};
  const double six_volumes = dot(cross(difference(0, 1), difference(0, 2)), difference(0, 3));
  if (!(six_volumes > 0)) return angles;
  std::array<Point3, 4> normal;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& f = kFaceVertex[i];
    const auto a = static_cast<std::size_t>(f[0]);
    normal[i] = cross(difference(a, static_cast<std::size_t>(f[1])),
                      difference(a, static_cast<std::size_t>(f[2])));
  }
  for (std::size_t e = 0; e < 6; ++e) {
    // Edge e lies in the faces opposite the two vertices of edge 5 − e. Their normals n, m
    // have n × m = ± 6 V · (the edge), which stays accurate for small angles.
    const auto i = static_cast<std::size_t>(kEdgeVertex[e][0]);
    const auto j = static_cast<std::size_t>(kEdgeVertex[e][1]);
    const auto n = static_cast<std::size_t>(kEdgeVertex[5 - e][0]);
    const auto m = static_cast<std::size_t>(kEdgeVertex[5 - e][1]);
    const Point3 along = difference(i, j);
    const double sine = six_volumes * std::sqrt(dot(along, along));
    angles[e] = std::atan2(sine, -dot(normal[n], normal[m])) * kDegrees;
  }
  return angles;
}

}  // namespace tetloft::internal::checking
