// Lattices whose coordination is known.
#include <cmath>

#include <gtest/gtest.h>

#include "support.hpp"

namespace tetloft::test {
namespace {

struct Crystal {
  std::string name;
  PeriodicBox cell;
  std::vector<Point3> sites;  // in coordinates of the cell
  std::vector<std::size_t> coordination;
};

std::vector<Crystal> crystals() {
  const double root = std::sqrt(3.0) / 2, ideal = std::sqrt(8.0 / 3);
  const PeriodicBox cube = orthorhombic_box(1, 1, 1);
  const PeriodicBox hexagonal{{1, 0, 0}, {0.5, root, 0}, {0, 0, ideal}};
  return {
      {"simple cubic", cube, {{0, 0, 0}}, {6}},
      {"bcc", cube, {{0, 0, 0}, {0.5, 0.5, 0.5}}, {14, 14}},
      {"fcc", cube, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}, {12, 12, 12, 12}},
      {"hexagonal", hexagonal, {{0, 0, 0}}, {8}},
      {"hcp", hexagonal, {{0, 0, 0}, {1.0 / 3, 1.0 / 3, 0.5}}, {12, 12}},
      {"fcc, primitive", {{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}, {{0, 0, 0}}, {12}},
      {"bcc, primitive", {{-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}, {{0.3, 0.1, 0.2}}, {14}},
      // 4 at the distance of bonds, and 12 beyond.
      {"diamond", {{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}, {{0, 0, 0}, {0.25, 0.25, 0.25}}, {16, 16}}};
}

Point3 in_cell(const Point3& p, const PeriodicBox& b) {
  return {p.x * b.a.x + p.y * b.b.x + p.z * b.c.x, p.x * b.a.y + p.y * b.b.y + p.z * b.c.y,
          p.x * b.a.z + p.y * b.b.z + p.z * b.c.z};
}

PeriodicBox scaled(const PeriodicBox& b, double by) {
  const auto times = [&](const Point3& p) { return Point3{by * p.x, by * p.y, by * p.z}; };
  return {times(b.a), times(b.b), times(b.c)};
}

TEST(Crystals, HaveTheirCoordination) {
  for (const Crystal& crystal : crystals()) {
    for (const double size : {1.0, 3.61}) {
      for (const int copies : {1, 3}) {
        SCOPED_TRACE(crystal.name + ", " + std::to_string(copies));
        const PeriodicBox box = scaled(crystal.cell, copies * size);
        std::vector<Point3> points;
        for (int k = 0; k < copies * copies * copies; ++k) {
          for (const Point3& p : crystal.sites) {
            points.push_back(
                in_cell({(p.x + k % copies) / copies, (p.y + k / copies % copies) / copies,
                         (p.z + k / copies / copies) / copies},
                        box));
          }
        }
        const PeriodicVoronoi3 diagram = value_of(periodic_voronoi(points, box));
        expect_sound(diagram, points, box);
        const double share = volume_of(box) / static_cast<double>(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
          EXPECT_NEAR(diagram.cells[i].volume / share, 1, 1e-12);
          std::size_t true_faces = 0;
          for (const PeriodicFace& face : diagram.cells[i].faces) {
            if (face.area > 1e-6 * size * size) ++true_faces;
          }
          EXPECT_EQ(true_faces, crystal.coordination[i % crystal.sites.size()]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace tetloft::test
