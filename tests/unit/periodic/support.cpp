#include "support.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "core/prng.hpp"
#include "core/vector.hpp"

namespace tetloft::test {

using internal::Prng;
using namespace internal::vectors;

std::vector<NamedBox> periodic_boxes() {
  return {{"cube", orthorhombic_box(1, 1, 1)},
          {"orthorhombic", orthorhombic_box(10.1, 3.3, 7.7)},
          {"left-handed", orthorhombic_box(1, -2, 1.5)},
          {"triclinic", {{4, 0, 0}, {1.3, 3.7, 0}, {-0.9, 1.1, 5.2}}},
          {"turned", {{1.1, 2.2, -0.7}, {-2.1, 0.4, 1.9}, {0.3, 1.7, 2.9}}},
          {"thin", orthorhombic_box(1, 1, 12)},
          {"flat", orthorhombic_box(9, 8, 0.7)},
          {"skewed", {{1, 0, 0}, {1000.3, 1.2, 0}, {-731.8, 2002.1, 0.9}}},
          {"badly skewed", {{1, 0, 0}, {1234567.3, 1, 0}, {0.3, 0.4, 1}}},
          // Very many steps where the second is shortened by both others before these are.
          {"skewed by two that are nearly parallel", {{4, 0, 0}, {17, 3, 2e6}, {4000, 0, 5}}}};
}

double volume_of(const PeriodicBox& box) { return std::abs(dot(box.a, cross(box.b, box.c))); }

Point3 shifted(const Point3& p, const LatticeShift& shift, const PeriodicBox& box) {
  return p + (static_cast<double>(shift[0]) * box.a + static_cast<double>(shift[1]) * box.b +
              static_cast<double>(shift[2]) * box.c);
}

std::vector<Point3> points_in(const PeriodicBox& box, std::size_t n, std::uint64_t seed, int bits) {
  Prng prng(seed);
  std::vector<Point3> points;
  const auto draw = [&] {
    return std::ldexp(static_cast<double>(prng.below(std::uint64_t{1} << bits)), -bits);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double s = draw(), t = draw(), u = draw();
    points.push_back(s * box.a + t * box.b + u * box.c);
  }
  return points;
}

namespace {

// Corners of a face are as near to the neighbour as to the site.
void expect_halfway(const PeriodicCell& cell, const PeriodicFace& face, const Point3& neighbour,
                    double size) {
  const double length = std::sqrt(dot(neighbour, neighbour));
  EXPECT_NEAR(dot(face.normal, neighbour) / length, 1, 1e-9);
  if (face.area < 1e-9 * size * size) return;
  Point3 twice;
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    const Point3& a = cell.corners[face.corners[k]];
    const Point3& b = cell.corners[face.corners[(k + 1) % face.corners.size()]];
    EXPECT_NEAR(dot(a, neighbour) / length, length / 2, 1e-8 * size);
    twice = twice + cross(a, b);
  }
  EXPECT_NEAR(dot(twice, neighbour) / (2 * length), face.area, 1e-8 * size * size);
}

}  // namespace

void expect_sound(const PeriodicVoronoi3& diagram, const std::vector<Point3>& points,
                  const PeriodicBox& box) {
  ASSERT_EQ(diagram.cells.size(), points.size());
  const double size = std::cbrt(volume_of(box));
  std::map<std::tuple<std::size_t, std::size_t, LatticeShift>, const PeriodicFace*> faces;
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += diagram.cells[i].volume;
    for (const PeriodicFace& face : diagram.cells[i].faces) {
      EXPECT_TRUE(faces.insert({{i, face.neighbour, face.shift}, &face}).second);
      expect_halfway(diagram.cells[i], face,
                     shifted(points[face.neighbour], face.shift, box) - points[i], size);
    }
  }
  EXPECT_NEAR(sum / volume_of(box), 1, 1e-12);
  for (const auto& [key, face] : faces) {
    const auto& [i, neighbour, s] = key;
    const auto mirror = faces.find({neighbour, i, {-s[0], -s[1], -s[2]}});
    ASSERT_NE(mirror, faces.end());
    EXPECT_EQ(mirror->second->area, face->area);
    EXPECT_EQ(mirror->second->normal, (-1.0) * face->normal);
  }
}

}  // namespace tetloft::test
