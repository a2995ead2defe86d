// Surface meshes cut by planes: crossings, loops, areas, and meshes that are not closed.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <tetloft/slice.hpp>

#include "core/prng.hpp"
#include "sections/edge_crossing.hpp"
#include "support/exact/rational.hpp"
#include "support/surface_meshes.hpp"

namespace tetloft::testing {

using namespace internal;

namespace {

using oracle::Rational;

Sliced sliced(const TriangleMesh& mesh, const SliceOptions& options) {
  Result<Sliced> result = slice(mesh, options);
  if (!result) {
    ADD_FAILURE() << to_string(result.error());
    return {};
  }
  EXPECT_TRUE(validate(result->stack).ok());
  return *std::move(result);
}

SliceOptions planes(std::size_t n, int axis = 2) {
  SliceOptions options;
  options.planes = n;
  options.axis = axis;
  return options;
}

SliceOptions step(double dz) {
  SliceOptions options;
  options.step = dz;
  return options;
}

std::string refusal(const TriangleMesh& mesh, const SliceOptions& options, ErrorCode code) {
  const Result<Sliced> result = slice(mesh, options);
  if (result) return "accepted";
  EXPECT_EQ(result.error().code, code);
  return result.error().message;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Whether no double is nearer to the exact coordinate at height z.
bool is_nearest(double x, double a, double b, const Point3& low, const Point3& high, double z) {
  const auto q = [](double value) { return Rational::exactly(value); };
  const Rational exact = q(a) + (q(b) - q(a)) * (q(z) - q(low.z)) / (q(high.z) - q(low.z));
  const Rational off = (exact - q(x)).abs();
  return off <= (exact - q(std::nextafter(x, INFINITY))).abs() &&
         off <= (exact - q(std::nextafter(x, -INFINITY))).abs();
}

TEST(EdgeCrossing, IsTheNearestDouble) {
  Prng prng(11);
  const auto number = [&](int kind) {
    const double unit = prng.between(-1, 1);
    if (kind == 0) return unit;
    if (kind == 1) return static_cast<double>(prng.below(17)) - 8;
    if (kind == 2) return 1e6 + unit;
    return std::ldexp(unit, static_cast<int>(prng.below(1900)) - 950);
  };
  for (int i = 0; i < 3000; ++i) {
    const int kind = i % 4;
    const Point3 low{number(kind), number(kind), number(kind)};
    const Point3 high{number(kind), -low.y, number(kind)};
    const double part = i % 3 == 0 ? 0.5 : prng.unit();
    const double z = low.z + (high.z - low.z) * part;
    if (!(low.z < z && z <= high.z)) continue;
    const Point2 p = sections::crossing_at(low, high, z);
    EXPECT_TRUE(is_nearest(p.x, low.x, high.x, low, high, z)) << i;
    EXPECT_TRUE(is_nearest(p.y, low.y, high.y, low, high, z)) << i;
  }
  EXPECT_EQ(sections::crossing_at({1, 2, 0}, {1, 5, 3}, 1), (Point2{1, 3}));
  EXPECT_EQ(sections::crossing_at({1, 2, 0}, {0.1, 0.7, 3}, 3), (Point2{0.1, 0.7}));
}

TEST(Slice, PutsPlanesEvenlyOrByAStep) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {4, 4, 4});
  const Sliced two = sliced(box, planes(2));
  ASSERT_EQ(two.stack.sections.size(), 2U);
  EXPECT_EQ(two.stack.sections[SectionId(0)].z, 1);
  EXPECT_EQ(two.stack.sections[SectionId(1)].z, 3);
  EXPECT_EQ(two.vertices, 8U);
  EXPECT_EQ(two.triangles, 12U);
  for (const Section& section : two.stack.sections) {
    ASSERT_EQ(section.contours.size(), 1U);
    EXPECT_EQ(area_of(section), 16);
  }
  const Sliced stepped = sliced(box, step(1.5));
  ASSERT_EQ(stepped.stack.sections.size(), 3U);
  EXPECT_EQ(stepped.stack.sections[SectionId(2)].z, 3.75);
}

TEST(Slice, TakesVerticesInAPlaneForAboveIt) {
  // The plane z = 2 holds the upper face of the wide box and the lower one of the narrow box.
  TriangleMesh mesh = box_mesh({0, 0, 0}, {4, 4, 2});
  append(mesh, box_mesh({1, 1, 2}, {3, 3, 4}));
  EXPECT_EQ(area_of(sliced(mesh, planes(1)).stack.sections[SectionId(0)]), 16);
  // An octahedron through whose four corners the plane goes.
  TriangleMesh octahedron;
  octahedron.points = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  for (std::uint32_t k = 1; k < 5; ++k) {
    octahedron.triangles.push_back({5, k, k % 4 + 1});
    octahedron.triangles.push_back({0, k % 4 + 1, k});
  }
  const Sliced middle = sliced(octahedron, planes(1));
  ASSERT_EQ(middle.stack.contour_count(), 1U);
  EXPECT_EQ(middle.stack.vertex_count(), 4U);
  EXPECT_EQ(area_of(middle.stack.sections[SectionId(0)]), 2);
  EXPECT_TRUE(middle.warnings.empty());
}

TEST(Slice, HasTheAreasOfATorus) {
  const TriangleMesh torus = torus_mesh(3, 1, 120, 80);
  const Sliced result = sliced(torus, planes(16));
  double volume = 0;
  for (const Section& section : result.stack.sections) {
    EXPECT_EQ(section.contours.size(), 2U);
    const double half = std::sqrt(1 - section.z * section.z);
    EXPECT_NEAR(area_of(section), 4 * kPi * 3 * half, 0.01 * 4 * kPi * 3 * half);
    volume += area_of(section) * 2 / 16;
  }
  EXPECT_NEAR(volume, volume_of(torus), 0.01 * volume);
}

TEST(Slice, LiesWhereTheMeshLiesAlongEveryAxis) {
  const TriangleMesh torus = torus_mesh(3, 1, 40, 24);
  for (const int axis : {0, 1, 2}) {
    TriangleMesh turned = torus;
    for (Point3& p : turned.points) {
      if (axis == 0) p = {p.z, p.x, p.y};
      if (axis == 1) p = {p.y, p.z, p.x};
    }
    const Sliced result = sliced(turned, planes(5, axis));
    const Sliced upright = sliced(torus, planes(5));
    ASSERT_EQ(result.stack.sections.size(), 5U);
    EXPECT_TRUE(is_exact(result.stack.frame));
    for (const SectionId s : result.stack.sections.ids()) {
      const Section& section = result.stack.sections[s];
      const Section& same = upright.stack.sections[s];
      EXPECT_EQ(section.z, same.z);
      EXPECT_EQ(section.contours[ContourId(0)].vertices, same.contours[ContourId(0)].vertices);
      const Point2& p = section.contours[ContourId(0)].vertices[0];
      const Point3 placed = place(result.stack.frame, {p.x, p.y, section.z});
      const Point3 expected = axis == 0   ? Point3{section.z, p.x, p.y}
                              : axis == 1 ? Point3{p.y, section.z, p.x}
                                          : Point3{p.x, p.y, section.z};
      EXPECT_EQ(placed, expected);
    }
  }
}

TEST(Slice, KeepsShellsInShells) {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {8, 8, 8});
  append(mesh, box_mesh({1, 1, 1}, {7, 7, 7}));
  append(mesh, box_mesh({2, 2, 2}, {6, 6, 6}));
  const Sliced result = sliced(mesh, planes(8));
  const Section& middle = result.stack.sections[SectionId(4)];
  EXPECT_EQ(middle.contours.size(), 3U);
  EXPECT_EQ(std::abs(twice_area(middle.contours[ContourId(0)])) / 2 +
                std::abs(twice_area(middle.contours[ContourId(1)])) / 2 +
                std::abs(twice_area(middle.contours[ContourId(2)])) / 2,
            64 + 36 + 16);
  // Two boxes one above the other: a section between them without contours.
  TriangleMesh apart = box_mesh({0, 0, 0}, {2, 2, 1});
  append(apart, box_mesh({0, 0, 4}, {2, 2, 5}));
  EXPECT_EQ(sliced(apart, planes(5)).stack.sections[SectionId(2)].contours.size(), 0U);
}

TEST(Slice, DoesNotDependOnTheOrderOfAnything) {
  const TriangleMesh torus = torus_mesh(3, 1, 30, 20);
  const Sliced first = sliced(torus, planes(7, 0));
  Prng prng(5);
  for (int round = 0; round < 5; ++round) {
    // Three points of its own for each triangle, as in an STL.
    TriangleMesh soup;
    std::vector<std::array<std::uint32_t, 3>> triangles = torus.triangles;
    prng.shuffle(triangles);
    for (const auto& t : triangles) {
      const auto from = static_cast<std::uint32_t>(soup.points.size());
      const auto turn = static_cast<std::size_t>(prng.below(3));
      for (std::size_t k = 0; k < 3; ++k) soup.points.push_back(torus.points[t[(k + turn) % 3]]);
      soup.triangles.push_back({from, from + 1, from + 2});
    }
    const Sliced again = sliced(soup, planes(7, 0));
    ASSERT_EQ(again.stack.contour_count(), first.stack.contour_count());
    for (const SectionId s : first.stack.sections.ids()) {
      for (const ContourId c : first.stack.sections[s].contours.ids()) {
        EXPECT_EQ(again.stack.sections[s].contours[c].vertices,
                  first.stack.sections[s].contours[c].vertices);
      }
    }
  }
}

TEST(Slice, RefusesMeshesThatAreNotClosed) {
  TriangleMesh box = box_mesh({0, 0, 0}, {4, 4, 4});
  box.triangles.pop_back();
  const std::string message = refusal(box, planes(3), ErrorCode::invalid_input);
  EXPECT_TRUE(has(message, "not closed: the edge from (4, 0, 0) to (4, 0, 4) has 1 triangle"))
      << message;
  EXPECT_TRUE(has(message, "3 edges")) << message;
}

TEST(Slice, LeavesOutCopiesWallsAndTrianglesWithoutExtent) {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {4, 4, 4});
  mesh.triangles.push_back(mesh.triangles[3]);
  mesh.triangles.push_back({0, 0, 5});
  const Sliced copies = sliced(mesh, planes(2));
  EXPECT_EQ(copies.triangles, 12U);
  ASSERT_EQ(copies.warnings.size(), 2U);
  EXPECT_TRUE(has(copies.warnings[0].message, "1 triangle with equal corners"));
  EXPECT_TRUE(has(copies.warnings[1].message, "1 triangle repeating others"));
  // A wall between two boxes, triangulated alike from both sides.
  TriangleMesh left = box_mesh({0, 0, 0}, {4, 4, 4});
  TriangleMesh right = left;
  for (Point3& p : right.points) p.x = 8 - p.x;
  for (auto& t : right.triangles) std::swap(t[1], t[2]);
  append(left, right);
  const Sliced both = sliced(left, planes(2));
  EXPECT_EQ(both.triangles, 20U);
  EXPECT_EQ(both.stack.contour_count(), 2U);
  EXPECT_EQ(area_of(both.stack.sections[SectionId(0)]), 32);
}

TEST(Slice, RepairsWhatTouches) {
  // Two boxes that share an edge: four triangles there.
  TriangleMesh mesh = box_mesh({0, 0, 0}, {4, 4, 4});
  append(mesh, box_mesh({4, 4, 0}, {8, 8, 4}));
  const Sliced result = sliced(mesh, planes(2));
  EXPECT_GT(result.repaired, 0U);
  double area = 0;
  for (const Contour& c : result.stack.sections[SectionId(0)].contours) {
    area += std::abs(twice_area(c)) / 2;
  }
  EXPECT_NEAR(area, 32, 1e-4);
  // Overlapping bodies by each rule.
  TriangleMesh overlapping = box_mesh({0, 0, 0}, {4, 4, 4});
  append(overlapping, box_mesh({2, 2, 0}, {6, 6, 4}));
  for (const FillRule rule : {FillRule::unite, FillRule::winding, FillRule::odd}) {
    SliceOptions options = planes(1);
    options.fill = rule;
    const Sliced filled = sliced(overlapping, options);
    double sum = 0;
    for (const Contour& c : filled.stack.sections[SectionId(0)].contours) {
      sum += std::abs(twice_area(c)) / 2;
    }
    EXPECT_NEAR(sum, rule == FillRule::odd ? 24 : 28, 1e-3) << static_cast<int>(rule);
  }
}

TEST(Slice, CutsShearedMeshes) {
  TriangleMesh torus = torus_mesh(3, 1, 60, 40);
  for (Point3& p : torus.points) p = {p.x + 0.7 * p.z + 1000, p.y - 0.3 * p.x, p.z + 0.2 * p.y};
  for (const int axis : {0, 1, 2}) {
    const Sliced result = sliced(torus, planes(60, axis));
    const auto& sections = result.stack.sections;
    const double gap = sections[SectionId(1)].z - sections[SectionId(0)].z;
    double volume = 0;
    for (const Section& section : sections) volume += area_of(section) * gap;
    EXPECT_NEAR(volume, volume_of(torus), 0.01 * volume) << axis;
  }
}

TEST(Slice, RefusesWhatMakesNoSense) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {4, 4, 4});
  EXPECT_TRUE(has(refusal(box, {}, ErrorCode::usage), "one of them"));
  EXPECT_TRUE(has(refusal(box, planes(2, 3), ErrorCode::usage), "axis"));
  EXPECT_TRUE(has(refusal(box, planes(kMostSlicePlanes + 1), ErrorCode::usage), "2^20"));
  EXPECT_TRUE(has(refusal(box, step(1e-9), ErrorCode::usage), "2^20"));
  EXPECT_TRUE(has(refusal(box, step(9), ErrorCode::usage), "no plane crosses"));
  EXPECT_TRUE(has(refusal(box, step(-1), ErrorCode::usage), "step"));
  EXPECT_TRUE(has(refusal({}, planes(1), ErrorCode::invalid_input), "no triangles"));
  TriangleMesh wrong = box;
  wrong.triangles[0][1] = 8;
  EXPECT_TRUE(has(refusal(wrong, planes(1), ErrorCode::invalid_input), "point 8 of 8"));
  wrong = box;
  wrong.points[3].y = NAN;
  EXPECT_TRUE(has(refusal(wrong, planes(1), ErrorCode::invalid_input), "not finite"));
  TriangleMesh flat = box_mesh({0, 0, 0}, {4, 4, 0});
  EXPECT_NE(refusal(flat, planes(1), ErrorCode::invalid_input), "accepted");
  TriangleMesh far = box_mesh({0, 0, 1e16}, {4, 4, 1e16 + 4});
  EXPECT_TRUE(has(refusal(far, planes(100), ErrorCode::invalid_input), "nearer together"));
}

}  // namespace
}  // namespace tetloft::testing
