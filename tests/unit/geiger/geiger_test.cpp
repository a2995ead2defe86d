// Geiger's algorithm: its steps, what it promises, and what it is known to break.
#include <tetloft/geiger.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/io.hpp>
#include <tetloft/predicates.hpp>
#include <tetloft/reconstruct.hpp>

#include "core/prng.hpp"
#include "geiger/obtuse.hpp"
#include "geiger/projection.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

Contour ngon(std::size_t n, double x, double y, double r) {
  Contour contour;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n);
    contour.vertices.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
  }
  return contour;
}

Section section(double z, std::vector<Contour> contours) {
  Section result;
  result.z = z;
  for (Contour& contour : contours) result.contours.push_back(std::move(contour));
  return result;
}

SectionStack stack_of(std::vector<Section> sections) {
  SectionStack stack;
  for (Section& s : sections) stack.sections.push_back(std::move(s));
  return stack;
}

// Some stacks of every kind that Geiger's algorithm is asked to bear.
std::vector<std::pair<std::string, SectionStack>> generated_stacks() {
  std::vector<std::pair<std::string, SectionStack>> stacks;
  for (const StackKind kind :
       {StackKind::lattice_marching_squares, StackKind::checkerboard, StackKind::nesting,
        StackKind::branching_one_to_many, StackKind::holes, StackKind::stars_combs,
        StackKind::crossing_bars, StackKind::isolated_contours}) {
    for (std::uint64_t seed = 500; seed < 506; ++seed) {
      SectionStack stack = generate(kind, seed).stack;
      if (stack.sections.size() < 2) continue;
      stacks.emplace_back(std::string(name_of(kind)) + " " + std::to_string(seed),
                          std::move(stack));
    }
  }
  return stacks;
}

const CheckFailure* failure(const CheckReport& report, int number) {
  for (const GuaranteeVerdict& verdict : report.guarantees) {
    if (verdict.number == number && !verdict.failures.empty()) return &verdict.failures.front();
  }
  return nullptr;
}

TEST(WithFeet, NoObtuseCornerFacesAContourEdgeAfterIt) {
  // A flat triangle with its obtuse corner opposite the long side.
  const Section flat = section(0, {Contour{{{0, 0}, {10, 0}, {5, 1}}}});
  std::size_t feet = 0;
  const auto result = geiger::with_feet(flat, SectionId(0), feet);
  ASSERT_TRUE(result);
  EXPECT_GE(feet, 1U);
  const auto& vertices = result->contours[ContourId(0)].vertices;
  EXPECT_NE(std::find(vertices.begin(), vertices.end(), Point2{5, 0}), vertices.end());

  const auto conforming = conform(*result, SectionId(0));
  ASSERT_TRUE(conforming);
  for (std::size_t t = 0; t < conforming->internal.size(); ++t) {
    if (conforming->internal[TriangleId(t)] == 0) continue;
    const PlaneTriangleVertices& v = conforming->triangulation.triangles[TriangleId(t)];
    for (std::size_t i = 0; i < 3; ++i) {
      const PlaneVertexId a = v[(i + 1) % 3], b = v[(i + 2) % 3];
      if (conforming->next[a] != b) continue;
      const Point2 p = conforming->point(a), q = conforming->point(b), c = conforming->point(v[i]);
      EXPECT_GE((p.x - c.x) * (q.x - c.x) + (p.y - c.y) * (q.y - c.y), 0);
    }
  }
}

TEST(WithFeet, LeavesAcuteSectionsAlone) {
  const Section acute = section(0, {ngon(8, 0, 0, 1)});
  std::size_t feet = 0;
  const auto result = geiger::with_feet(acute, SectionId(0), feet);
  ASSERT_TRUE(result);
  EXPECT_EQ(feet, 0U);
  EXPECT_EQ(result->contours[ContourId(0)].vertices, acute.contours[ContourId(0)].vertices);
}

TEST(Projection, KeepsWhatIsWellInsideAndApart) {
  const Section ring = section(0, {ngon(24, 0, 0, 10), ngon(12, 0, 0, 4)});
  const auto conforming = conform(ring, SectionId(0));
  ASSERT_TRUE(conforming);
  Prng prng(3);
  std::vector<Point2> candidates{{7, 0}, {7, 0}, {7.0001, 0}, {0, 0}, {20, 0}};
  for (int k = 0; k < 500; ++k)
    candidates.push_back({prng.between(-12, 12), prng.between(-12, 12)});
  const std::vector<Point2> kept = geiger::projected_into(*conforming, candidates);
  EXPECT_GT(kept.size(), 50U);
  // Contour edges are about 2.4 long: a tenth of that to everything.
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const double r = std::hypot(kept[i].x, kept[i].y);
    EXPECT_GT(r, 4.0);
    EXPECT_LT(r, 10.0 - 0.2);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(std::hypot(kept[i].x - kept[j].x, kept[i].y - kept[j].y), 0.2);
    }
  }
}

TEST(Geiger, ATubeIsWhole) {
  const SectionStack tube =
      stack_of({section(0, {ngon(16, 0, 0, 2)}), section(1, {ngon(16, 0.1, 0, 2)}),
                section(2, {ngon(16, 0.2, 0, 2)})});
  const auto made = reconstruct_geiger(tube);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->model.component_count, 1U);
  EXPECT_EQ(made->report.lost_contours, 0U);
  EXPECT_EQ(made->report.input_vertices, 48U);
  const auto report = check(made->model, tube);
  ASSERT_TRUE(report);
  EXPECT_EQ(failure(*report, 3), nullptr);
}

TEST(Geiger, TetsArePositiveAndDoNotOverlap) {
  std::size_t broken = 0;
  for (const auto& [name, stack] : generated_stacks()) {
    SCOPED_TRACE(name);
    const auto made = reconstruct_geiger(stack);
    ASSERT_TRUE(made) << to_string(made.error());
    const Model& model = made->model;
    for (std::size_t t = 0; t < model.tets.size(); ++t) {
      const TetVertices& v = model.tets[TetId(t)];
      ASSERT_EQ(
          orient3d(model.points[v[0]], model.points[v[1]], model.points[v[2]], model.points[v[3]]),
          Sign::positive);
    }
    const auto report = check(model, stack);
    ASSERT_TRUE(report);
    // Touching itself it may be, in singular vertices and edges; but no tet is inverted.
    broken += report->pass() ? 0U : 1U;
    // No external edge, no external triangle.
    for (const TetKind kind : model.kind) {
      ASSERT_TRUE(kind == TetKind::t1_internal || kind == TetKind::ii || kind == TetKind::ic ||
                  kind == TetKind::cc);
    }
  }
  EXPECT_GT(broken, 0U);
}

TEST(Geiger, LosesAnIsolatedContourThatNonatoKeeps) {
  const SectionStack stack = stack_of({section(0, {ngon(16, 0, 0, 2)}),
                                       section(1, {ngon(16, 0, 0, 2), ngon(8, 9, 0, 0.5)}),
                                       section(2, {ngon(16, 0, 0, 2)})});
  const auto geiger = reconstruct_geiger(stack);
  ASSERT_TRUE(geiger);
  EXPECT_EQ(geiger->report.lost_contours, 1U);
  EXPECT_EQ(geiger->model.component_count, 1U);
  const auto nonato = reconstruct(stack);
  ASSERT_TRUE(nonato);
  EXPECT_EQ(nonato->model.component_count, 2U);
}

TEST(Geiger, IsSingularWhereBothSectionsBranch) {
  // Nonato et al. 2000, figure 16: two bars below, two across them above.
  const auto bar = [](double x0, double y0, double x1, double y1) {
    Contour contour;
    const double n = 12;
    const auto side = [&](Point2 a, Point2 b) {
      for (double k = 0; k < n; ++k) {
        contour.vertices.push_back({a.x + k / n * (b.x - a.x), a.y + k / n * (b.y - a.y)});
      }
    };
    side({x0, y0}, {x1, y0});
    side({x1, y0}, {x1, y1});
    side({x1, y1}, {x0, y1});
    side({x0, y1}, {x0, y0});
    return contour;
  };
  const SectionStack stack = stack_of({section(0, {bar(-3, -3, -1, 3), bar(1, -3, 3, 3)}),
                                       section(1, {bar(-3, -3, 3, -1), bar(-3, 1, 3, 3)})});
  const auto geiger = reconstruct_geiger(stack);
  ASSERT_TRUE(geiger);
  const auto report = check(geiger->model, stack);
  ASSERT_TRUE(report);
  EXPECT_NE(failure(*report, 1), nullptr);
  const auto nonato = reconstruct(stack);
  ASSERT_TRUE(nonato);
  const auto good = check(nonato->model, stack);
  ASSERT_TRUE(good);
  EXPECT_TRUE(good->pass());
  EXPECT_EQ(good->genus, std::vector<long>{1});
}

TEST(Geiger, DependsOnNeitherThreadsNorOrderOfContours) {
  for (const auto& [name, stack] : generated_stacks()) {
    SCOPED_TRACE(name);
    const auto made = reconstruct_geiger(stack, {.execution = {.threads = 1}});
    const auto threaded = reconstruct_geiger(stack, {.execution = {.threads = 3}});
    ASSERT_TRUE(made && threaded);
    EXPECT_EQ(made->model.points, threaded->model.points);
    EXPECT_EQ(made->model.tets, threaded->model.tets);
    EXPECT_EQ(made->model.component, threaded->model.component);
    SectionStack turned = stack;
    for (Section& s : turned.sections) {
      std::vector<Contour> contours(s.contours.begin(), s.contours.end());
      std::reverse(contours.begin(), contours.end());
      s.contours = {};
      for (Contour& c : contours) {
        std::reverse(c.vertices.begin(), c.vertices.end());
        s.contours.push_back(std::move(c));
      }
    }
    const auto again = reconstruct_geiger(turned);
    ASSERT_TRUE(again);
    EXPECT_EQ(made->model.points, again->model.points);
    EXPECT_EQ(made->model.tets, again->model.tets);
  }
}

TEST(Geiger, RefusesASingleSectionAndInvalidStacks) {
  const auto one = reconstruct_geiger(stack_of({section(0, {ngon(8, 0, 0, 1)})}));
  ASSERT_FALSE(one);
  EXPECT_EQ(one.error().code, ErrorCode::invalid_input);
  const auto crossing = reconstruct_geiger(stack_of(
      {section(0, {Contour{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}), section(1, {ngon(8, 0, 0, 1)})}));
  ASSERT_FALSE(crossing);
  EXPECT_EQ(crossing.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(crossing.error().where.section, 0U);
}

}  // namespace
}  // namespace tetloft::testing
