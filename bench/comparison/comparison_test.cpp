// The corpus and what measures the methods, on solids that are known by heart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/reconstruct.hpp>

#include "comparison/distance_field.hpp"
#include "comparison/marching.hpp"
#include "comparison/methods.hpp"
#include "comparison/metrics.hpp"
#include "comparison/nearest.hpp"
#include "comparison/section_cut.hpp"
#include "comparison/surface_distance.hpp"
#include "comparison/truth.hpp"
#include "core/prng.hpp"
#include "corpus/solids.hpp"

namespace tetloft::bench {

using namespace internal;
namespace {

// Within a test, Run is a member of its base.
using Measured = Run;

template <class Inside>
SampledSolid solid_of(std::size_t n, Inside&& inside) {
  SampledSolid solid{n, n, n, std::vector<float>(n * n * n, 1.0F)};
  for (std::size_t z = 0; z < n; ++z) {
    for (std::size_t y = 0; y < n; ++y) {
      for (std::size_t x = 0; x < n; ++x) {
        if (inside(x, y, z)) solid.value[(z * n + y) * n + x] = -1;
      }
    }
  }
  return solid;
}

SampledSolid ball(std::size_t n, double radius) {
  SampledSolid solid{n, n, n, {}};
  const double middle = static_cast<double>(n - 1) / 2;
  for (std::size_t k = 0; k < n * n * n; ++k) {
    const double x = static_cast<double>(k % n) - middle;
    const double y = static_cast<double>(k / n % n) - middle;
    const double z = static_cast<double>(k / n / n) - middle;
    solid.value.push_back(static_cast<float>(std::hypot(x, y, z) - radius));
  }
  return solid;
}

double ball_volume(double radius) { return 4 * std::numbers::pi / 3 * radius * radius * radius; }

Contour circle(double x, double y, double radius, std::size_t n = 64) {
  Contour contour;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    contour.vertices.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return contour;
}

SectionStack stack_of(std::size_t sections, const std::vector<Contour>& contours) {
  SectionStack stack;
  for (std::size_t s = 0; s < sections; ++s) {
    Section section;
    section.z = 2 * static_cast<double>(s);
    for (const Contour& contour : contours) section.contours.push_back(contour);
    stack.sections.push_back(std::move(section));
  }
  return stack;
}

ScalarGrid grid_of(const SampledSolid& solid) {
  ScalarGrid grid{solid.nx, solid.ny, {0, 0}, 1, {}, solid.value};
  for (std::size_t z = 0; z < solid.nz; ++z) grid.z.push_back(static_cast<double>(z));
  return grid;
}

void expect_manifold(const TriangleMesh& mesh) {
  const SurfaceFaults faults = faults_of(mesh);
  EXPECT_EQ(faults.edges, 0U);
  EXPECT_EQ(faults.vertices, 0U);
}

TEST(SolidTruth, CountsABoxWithACavity) {
  const auto box = solid_of(8, [](auto x, auto y, auto z) {
    const auto within = [](std::size_t a) { return 1 <= a && a <= 5; };
    return within(x) && within(y) && within(z) && !(x == 3 && y == 3 && z == 3);
  });
  const SolidTruth truth = truth_of(box);
  EXPECT_EQ(truth.volume, 124);
  EXPECT_EQ(truth.components, 1);
  EXPECT_EQ(truth.cavities, 1);
  EXPECT_EQ(truth.genus, 0);
}

TEST(SolidTruth, CountsHandlesAndPieces) {
  const auto frame_and_cube = solid_of(10, [](auto x, auto y, auto z) {
    const bool frame =
        z == 2 && 1 <= x && x <= 5 && 1 <= y && y <= 5 && (x == 1 || x == 5 || y == 1 || y == 5);
    return frame || (x == 7 && y == 7 && z == 7);
  });
  const SolidTruth truth = truth_of(frame_and_cube);
  EXPECT_EQ(truth.volume, 17);
  EXPECT_EQ(truth.components, 2);
  EXPECT_EQ(truth.cavities, 0);
  EXPECT_EQ(truth.genus, 1);
}

TEST(Slice, GivesTheCirclesOfABall) {
  for (const Contouring contouring : {Contouring::smooth, Contouring::lattice}) {
    const SlicedSolid sliced = slice(ball(32, 12.3), 4, contouring);
    ASSERT_TRUE(validate(sliced.stack));
    ASSERT_EQ(sliced.stack.sections.size(), 6U);
    for (const Section& section : sliced.stack.sections) {
      ASSERT_EQ(section.contours.size(), 1U);
      const double z = section.z - 15.5;
      const double area = std::numbers::pi * (12.3 * 12.3 - z * z);
      const double tolerance = contouring == Contouring::smooth ? 0.02 : 0.1;
      EXPECT_NEAR(std::abs(twice_area(section.contours[ContourId(0)])) / 2, area, tolerance * area);
    }
    for (const auto& pieces : sliced.piece) {
      ASSERT_EQ(pieces.size(), 2U);
      EXPECT_EQ(pieces[0], pieces[1]);
    }
  }
}

TEST(Truth, IsThatOfTheSolidBetweenTheSections) {
  const SampledSolid solid = ball(32, 12.3);
  const SectionStack stack = slice(solid, 12, Contouring::smooth).stack;
  const double low = stack.sections[SectionId(0)].z - 15.5;
  const double high = stack.sections[SectionId(stack.sections.size() - 1)].z - 15.5;
  const auto integral = [](double z) { return 12.3 * 12.3 * z - z * z * z / 3; };
  const double volume = std::numbers::pi * (integral(high) - integral(low));
  const Truth truth = truth_between_sections(solid, stack);
  EXPECT_EQ(*truth.components, 1);
  EXPECT_EQ(*truth.genus, 0);
  EXPECT_NEAR(*truth.volume, volume, 0.02 * volume);
  expect_manifold(*truth.surface);
}

TEST(Marching, GivesManifoldsOfNoise) {
  Prng prng(7);
  for (int round = 0; round < 20; ++round) {
    const auto noise = solid_of(8, [&](auto x, auto y, auto) {
      return 0 < x && x < 7 && 0 < y && y < 7 && prng.chance(0.4);
    });
    expect_manifold(marching_tets(grid_of(noise)));
  }
}

TEST(Marching, FindsVolumeAndTopology) {
  const TriangleMesh mesh = marching_tets(grid_of(ball(32, 12.3)));
  expect_manifold(mesh);
  EXPECT_NEAR(enclosed_volume(mesh), ball_volume(12.3), 0.01 * ball_volume(12.3));
  const auto shell = solid_of(9, [](auto x, auto y, auto z) {
    return std::min({x, y, z}) > 0 && std::max({x, y, z}) < 8 && !(x == 4 && y == 4 && z == 4);
  });
  const Topology topology = topology_of(marching_tets(grid_of(shell)));
  EXPECT_EQ(topology.components, 1);
  EXPECT_EQ(topology.cavities, 1);
  EXPECT_EQ(topology.genus, 0);
}

TEST(DistanceField, MakesACylinderOfCircles) {
  const SectionStack stack = stack_of(5, {circle(0, 0, 10)});
  const Result<ScalarGrid> grid = distance_field(stack);
  ASSERT_TRUE(grid);
  const TriangleMesh mesh = marching_tets(*grid);
  expect_manifold(mesh);
  const Topology topology = topology_of(mesh);
  EXPECT_EQ(topology.components, 1);
  EXPECT_EQ(topology.cavities, 0);
  EXPECT_EQ(topology.genus, 0);
  const double volume = 800 * std::numbers::pi;
  EXPECT_NEAR(enclosed_volume(mesh), volume, 0.02 * volume);
  EXPECT_LT(section_deviation(mesh, stack), 0.02);
  EXPECT_EQ(lost_contours(SurfaceSearch(mesh), stack, grid->step), 0U);
}

TEST(DistanceField, KeepsHolesOpen) {
  const SectionStack stack = stack_of(3, {circle(0, 0, 10), circle(1, 0, 5), circle(30, 0, 2)});
  const Result<ScalarGrid> grid = distance_field(stack, {.step = 0.5});
  ASSERT_TRUE(grid);
  const Topology topology = topology_of(marching_tets(*grid));
  EXPECT_EQ(topology.components, 2);
  EXPECT_EQ(topology.genus, 1);
}

TEST(DistanceField, IsExact) {
  const SectionStack stack = stack_of(2, {circle(0, 0, 10, 17), circle(3, 1, 4, 9)});
  const ScalarGrid grid = distance_field(stack, {.step = 0.7}).value();
  for (std::size_t k = 0; k < grid.nx * grid.ny; ++k) {
    const Point3 p{grid.origin.x + grid.step * static_cast<double>(k % grid.nx),
                   grid.origin.y + grid.step * static_cast<double>(k / grid.nx), 0};
    double least = 1e9;
    for (const Contour& contour : stack.sections[SectionId(0)].contours) {
      const auto& v = contour.vertices;
      for (std::size_t i = 0; i < v.size(); ++i) {
        const Point2 &a = v[i], &b = v[(i + 1) % v.size()];
        least = std::min(least, distance2_to_segment(p, {a.x, a.y, 0}, {b.x, b.y, 0}));
      }
    }
    EXPECT_NEAR(std::abs(grid.value[k]), std::sqrt(least), 1e-5);
  }
}

TEST(DistanceField, RefusesWhatHasNoSlab) {
  EXPECT_FALSE(distance_field(stack_of(1, {circle(0, 0, 1)})));
  EXPECT_FALSE(distance_field(stack_of(2, {})));
}

TEST(SurfaceSearch, AgreesWithAllTriangles) {
  Prng prng(3);
  const auto point = [&](double size) {
    const double x = prng.between(-size, size), y = prng.between(-size, size);
    return Point3{x, y, prng.between(-size, size)};
  };
  TriangleMesh soup;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Point3 a = point(10), b = point(10);
    soup.points.push_back(a);
    soup.points.push_back(b);
    soup.points.push_back(i % 10 == 0 ? a : point(10));  // some without area
    soup.triangles.push_back({VertexId(3 * i), VertexId(3 * i + 1), VertexId(3 * i + 2)});
  }
  const SurfaceSearch search(soup);
  for (int k = 0; k < 500; ++k) {
    const Point3 p = point(15);
    double least = 1e9;
    for (const auto& [a, b, c] : soup.triangles) {
      least =
          std::min(least, distance2_to_triangle(p, soup.points[a], soup.points[b], soup.points[c]));
    }
    EXPECT_EQ(search.distance(p), std::sqrt(least));
  }
}

TEST(SurfaceSearch, KnowsTheDistanceOfATriangle) {
  const Point3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  EXPECT_EQ(distance2_to_triangle({1, 1, 3}, a, b, c), 9);
  EXPECT_EQ(distance2_to_triangle({1, -2, 0}, a, b, c), 4);
  EXPECT_EQ(distance2_to_triangle({-3, -4, 0}, a, b, c), 25);
  EXPECT_DOUBLE_EQ(distance2_to_triangle({4, 4, 1}, a, b, c), 9);
  EXPECT_EQ(distance2_to_triangle({1, 1, 0}, a, a, a), 2);
}

TEST(SurfaceDistance, IsThatOfConcentricBalls) {
  const TriangleMesh large = marching_tets(grid_of(ball(40, 15)));
  const TriangleMesh small = marching_tets(grid_of(ball(40, 12)));
  const SurfaceSearch near_large(large), near_small(small);
  const auto on_large = sample_surface(large, -1, 99, 2000, 1);
  const auto on_small = sample_surface(small, -1, 99, 2000, 1);
  ASSERT_EQ(on_large.size(), 2000U);
  const auto apart = surface_distance({near_large, on_large}, {near_small, on_small});
  ASSERT_TRUE(apart);
  EXPECT_NEAR(apart->mean, 3, 0.05);
  EXPECT_NEAR(apart->hausdorff, 3, 0.1);
  const auto same = surface_distance({near_large, on_large}, {near_large, on_large});
  EXPECT_LT(same->hausdorff, 1e-6);
}

TEST(SurfaceDistance, LeavesTheEndsOut) {
  const SectionStack stack = stack_of(3, {circle(0, 0, 10)});
  const TriangleMesh mesh = marching_tets(distance_field(stack).value());
  for (const Point3& p : sample_surface(mesh, 0, 4, 1000, 1)) {
    EXPECT_GT(std::hypot(p.x, p.y), 9);
  }
}

// Two tets with an edge, two with a vertex, and two with a face in common.
TEST(TetBoundary, IsPartedWhereTheSolidTouchesItself) {
  IdVector<VertexId, Point3> points;
  for (const Point3& p : {Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1},
                          Point3{0, -1, 0}, Point3{0, 0, -1}, Point3{-1, 0, 0}}) {
    points.push_back(p);
  }
  const auto tet = [](unsigned a, unsigned b, unsigned c, unsigned d) {
    return TetVertices{VertexId(a), VertexId(b), VertexId(c), VertexId(d)};
  };
  const auto topology = [&](const std::vector<TetVertices>& tets) {
    const TetMesh mesh = TetMesh::from_tets(points.size(), tets).value();
    const TriangleMesh surface = boundary_of(mesh, points);
    expect_manifold(surface);
    EXPECT_NEAR(enclosed_volume(surface), 2.0 / 6, 1e-12);
    return topology_of(surface);
  };
  EXPECT_EQ(topology({tet(0, 1, 2, 3), tet(0, 1, 4, 5)}).components, 2);
  EXPECT_EQ(topology({tet(0, 1, 2, 3), tet(0, 6, 4, 3)}).components, 2);
  EXPECT_EQ(topology({tet(0, 1, 2, 3), tet(0, 2, 1, 5)}).components, 1);
}

TEST(SurfaceFaults, NamesOpenEdgesAndPinchedVertices) {
  TriangleMesh mesh;
  mesh.points.resize(7);
  const auto tet = [&](std::array<unsigned, 4> v) {
    for (const auto& face : kFaceVertex) {
      const auto at = [&](int i) { return VertexId(v[static_cast<std::size_t>(i)]); };
      mesh.triangles.push_back({at(face[0]), at(face[1]), at(face[2])});
    }
  };
  tet({0, 1, 2, 3});
  expect_manifold(mesh);
  tet({0, 4, 5, 6});
  EXPECT_EQ(faults_of(mesh).edges, 0U);
  EXPECT_EQ(faults_of(mesh).vertices, 1U);
  mesh.triangles.pop_back();
  EXPECT_EQ(faults_of(mesh).edges, 3U);
}

TEST(SectionDeviation, TellsWhatIsMissing) {
  const TriangleMesh mesh = marching_tets(distance_field(stack_of(3, {circle(0, 0, 10)})).value());
  const double other = section_deviation(mesh, stack_of(3, {circle(0, 0, 10), circle(30, 0, 10)}));
  EXPECT_NEAR(other, 0.5, 0.02);
  EXPECT_NEAR(section_deviation({}, stack_of(3, {circle(0, 0, 10)})), 1, 1e-12);
  EXPECT_EQ(
      lost_contours(SurfaceSearch(mesh), stack_of(3, {circle(0, 0, 10), circle(30, 0, 9)}), 1), 3U);
}

// A solid that branches: what is measured of a model is what check() says of it.
TEST(MeasureRun, AgreesWithCheck) {
  SectionStack stack = stack_of(4, {circle(0, 0, 10), circle(0, 0, 5), circle(40, 0, 5)});
  Section branched;
  branched.z = 8;
  branched.contours.push_back(circle(-6, 0, 3));
  branched.contours.push_back(circle(6, 0, 3));
  stack.sections.push_back(std::move(branched));
  const Subject subject{"by hand", "", "", 0, "", stack};
  // As the first method does: nothing put between.
  const CheckReport checked = check(reconstruct(stack, {.between = 0})->model, stack).value();
  long genus = 0;
  for (const long g : checked.genus) genus += g;
  const auto components = static_cast<long>(checked.components);
  const auto surfaces = static_cast<long>(checked.genus.size());

  Truth truth;
  truth.components = components + 3;
  const Measured run = measure_run(all_methods().front(), subject, Reference(truth), 100);
  ASSERT_EQ(run.refusal, "");
  EXPECT_TRUE(*run.valid);
  EXPECT_EQ(run.singular_vertices + run.singular_edges, 0U);
  EXPECT_EQ(run.topology.components, components);
  EXPECT_EQ(run.topology.cavities, surfaces - components);
  EXPECT_EQ(run.topology.genus, genus);
  EXPECT_NEAR(run.volume, checked.volume, 1e-9 * checked.volume);
  EXPECT_LT(run.deviation, 1e-12);
  EXPECT_EQ(run.lost, 0U);
  EXPECT_EQ(*run.component_error, 3);
  EXPECT_FALSE(run.genus_error || run.volume_error || run.distance);
  EXPECT_TRUE((*run.guarantees)[4]);
  EXPECT_EQ(*run.exceptions, 0);
}

// A thin ring just outside another, and no part of it: the hole of the upper one hardly overlaps
// what is around the lower, yet no wall can part them, which the model lists. A method without
// criterion is not asked.
TEST(MeasureRun, CountsExceptionsFromTheFifthGuarantee) {
  SectionStack stack;
  for (const auto& [z, half] : {std::pair{0.0, 10.0}, std::pair{3.0, 10.12}}) {
    Section section;
    section.z = z;
    for (const double h : {half, half - 0.1}) {
      section.contours.push_back({{{-h, -h}, {h, -h}, {h, h}, {-h, h}}});
    }
    stack.sections.push_back(std::move(section));
  }
  const Subject subject{"rings", "", "", 0, "", stack};
  Truth truth;
  truth.cavities = 2;
  const Method apart = tetloft_by("apart", {.criterion = Criterion::overlap, .lone = false});
  const Measured run = measure_run(apart, subject, Reference(truth), 0);
  ASSERT_EQ(run.refusal, "");
  EXPECT_TRUE((*run.guarantees)[4]);
  EXPECT_EQ(*run.exceptions, 1);
  EXPECT_EQ(*run.cavity_error, 2);
  EXPECT_FALSE(measure_run(geiger(), subject, Reference(truth), 0).exceptions);
}

TEST(Methods, AllMakeACylinder) {
  const Subject subject{"cylinder", "", "", 0, "", stack_of(4, {circle(0, 0, 10)})};
  const double volume = 600 * std::numbers::pi;
  for (const Method& method : all_methods()) {
    const Measured run = measure_run(method, subject, Reference({}), 100);
    EXPECT_EQ(run.refusal, "") << method.name;
    EXPECT_EQ(run.topology.components, 1) << method.name;
    EXPECT_NEAR(run.volume, volume, 0.02 * volume) << method.name;
  }
}

TEST(Aggregate, CountsRefusedStacksAsNotValid) {
  Measured good, refused;
  good.guarantees = {true, true, true, true, true};
  good.exceptions = 2;
  good.valid = true;
  good.deviation = 0.5;
  good.seconds = 2;
  good.component_error = 0;
  good.cavity_error = 1;
  refused.refusal = "no room";
  refused.deviation = 9;
  const Aggregate all = aggregate({{&good, 1000}, {&refused, 500}});
  EXPECT_EQ(all.refused, 1U);
  EXPECT_EQ(*all.valid, 0.5);
  EXPECT_EQ(*all.defined, 0.5);
  EXPECT_EQ(*all.exceptions, 2);
  EXPECT_EQ(all.deviation, 0.5);
  EXPECT_EQ(all.seconds_per_10k, 20);
  EXPECT_EQ(*all.right_topology, 0);
  EXPECT_EQ(*all.cavity_errors, 1);
  EXPECT_FALSE(all.genus_errors);
}

}  // namespace
}  // namespace tetloft::bench
