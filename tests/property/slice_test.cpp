// Boundaries of reconstructed stacks, cut along every axis: each section is, point by point, what a
// ray through the triangles says.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <tetloft/predicates.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/slice.hpp>

#include "core/prng.hpp"
#include "io/surface.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;

namespace {

// The coordinates of the stack of a point of the mesh.
Point3 turned(const Point3& p, int axis) {
  if (axis == 0) return {p.y, p.z, p.x};
  return axis == 1 ? Point3{p.z, p.x, p.y} : p;
}

// Whether a ray upwards from p meets an odd number of triangles; none where it meets an edge.
std::optional<bool> inside_by_ray(const TriangleMesh& mesh, int axis, const Point3& p) {
  bool inside = false;
  for (const auto& t : mesh.triangles) {
    std::array<Point3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = turned(mesh.points[t[k]], axis);
    std::array<Sign, 3> side;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& a = corner[k];
      const Point3& b = corner[(k + 1) % 3];
      side[k] = orient2d({a.x, a.y}, {b.x, b.y}, {p.x, p.y});
    }
    if (side[0] == Sign::zero || side[1] == Sign::zero || side[2] == Sign::zero) {
      // On the line of an edge: only off its end is that no crossing for sure.
      const auto [low, high] = std::minmax({corner[0].x, corner[1].x, corner[2].x});
      const auto [near, far] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
      if (p.x < low || p.x > high || p.y < near || p.y > far) continue;
      return std::nullopt;
    }
    if (side[0] != side[1] || side[1] != side[2]) continue;
    const Sign height = orient3d(corner[0], corner[1], corner[2], p);
    if (height == Sign::zero) return std::nullopt;
    // Positive above a triangle that turns counter-clockwise from above.
    if (height != side[0]) inside = !inside;
  }
  return inside;
}

bool inside_section(const Section& section, const Point2& p) {
  bool inside = false;
  for (const Contour& contour : section.contours) {
    const auto& v = contour.vertices;
    for (std::size_t k = 0; k < v.size(); ++k) {
      const Point2& a = v[k];
      const Point2& b = v[(k + 1) % v.size()];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const Sign side = orient2d(a, b, p);
      if (side == (b.y > a.y ? Sign::positive : Sign::negative)) inside = !inside;
    }
  }
  return inside;
}

double distance_to(const Section& section, const Point2& p) {
  double least = INFINITY;
  for (const Contour& contour : section.contours) {
    const auto& v = contour.vertices;
    for (std::size_t k = 0; k < v.size(); ++k) {
      const Point2& a = v[k];
      const Point2& b = v[(k + 1) % v.size()];
      const double dx = b.x - a.x;
      const double dy = b.y - a.y;
      const double t =
          std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      least = std::min(least, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
    }
  }
  return least;
}

TriangleMesh boundary_of(StackKind kind, std::uint64_t seed) {
  const GeneratedStack generated = generate(kind, seed);
  ReconstructOptions options;
  options.correspondence = generated.correspondence;
  options.execution.threads = 1;
  const auto made = reconstruct(generated.stack, options);
  if (!made || made->model.tets.empty()) return {};
  const io::SurfaceMesh surface = io::surface_mesh(made->model);
  return {surface.points, surface.triangles};
}

struct Box {
  Point3 low{INFINITY, INFINITY, INFINITY};
  Point3 high{-INFINITY, -INFINITY, -INFINITY};
};

Box box_of(const TriangleMesh& mesh, int axis) {
  Box box;
  for (const Point3& q : mesh.points) {
    const Point3 p = turned(q, axis);
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

constexpr std::array kKinds{StackKind::lattice_marching_squares,
                            StackKind::nesting,
                            StackKind::branching_one_to_many,
                            StackKind::holes,
                            StackKind::stars_combs,
                            StackKind::oblique,
                            StackKind::pores,
                            StackKind::channels,
                            StackKind::rings,
                            StackKind::checkerboard};

TEST(SlicedBoundaries, AreWhatARayThroughTheMeshSays) {
  std::size_t compared = 0;
  std::size_t within = 0;
  for (const StackKind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const TriangleMesh mesh = boundary_of(kind, seed);
      if (mesh.triangles.empty()) continue;
      Prng prng(seed);
      for (const int axis : {0, 1, 2}) {
        SliceOptions options;
        options.axis = axis;
        options.planes = 5;
        options.execution.threads = 1;
        const Result<Sliced> sliced = slice(mesh, options);
        ASSERT_TRUE(sliced.ok()) << to_string(sliced.error());
        ASSERT_TRUE(validate(sliced->stack).ok());
        const Box box = box_of(mesh, axis);
        const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y) +
                            std::max(std::abs(box.low.x), std::abs(box.low.y));
        for (const Section& section : sliced->stack.sections) {
          for (int i = 0; i < 20; ++i) {
            const Point2 p{prng.between(box.low.x, box.high.x),
                           prng.between(box.low.y, box.high.y)};
            // Repair may move the boundary by 2^-20 of the largest coordinate.
            if (distance_to(section, p) < 0x1p-18 * size) continue;
            const auto expected = inside_by_ray(mesh, axis, {p.x, p.y, section.z});
            if (!expected) continue;
            ++compared;
            within += *expected ? 1U : 0U;
            EXPECT_EQ(inside_section(section, p), *expected)
                << "axis " << axis << " at " << p.x << ' ' << p.y << ' ' << section.z;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 5000U);
  EXPECT_GT(within, 500U);
}

}  // namespace
}  // namespace tetloft::testing
