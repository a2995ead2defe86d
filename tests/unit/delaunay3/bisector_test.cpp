// The slab engine's predicate against the perturbed in-sphere predicate in space.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <tetloft/predicates.hpp>

#include "delaunay3/nearer.hpp"
#include "support.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

using delaunay3_detail::Bisector;
using delaunay3_detail::CentresAndSites;
using delaunay3_detail::PlaneDiagram;
using delaunay3_detail::turn_between;

Triangulation2 plane_of(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return std::move(delaunay2(points).value());
}

Point3 lift(const Point2& p, double z) { return {p.x, p.y, z}; }

// All triangles of one plane against all pairs of the other.
void expect_insphere(const Triangulation2& centres, const Triangulation2& sites, bool sites_above) {
  if (centres.triangles.empty() || sites.triangles.empty()) return;
  const double reach = std::max(delaunay3_detail::reach_of(centres.points),
                                delaunay3_detail::reach_of(sites.points));
  const PlaneDiagram centre_diagram(centres, reach);
  const PlaneDiagram site_diagram(sites, reach);
  const CentresAndSites planes{&centre_diagram, &site_diagram, sites_above};
  const double z_sites = sites_above ? 1 : -1;
  for (std::size_t k = 0; k < centre_diagram.finite_count(); ++k) {
    const auto corner = [&](std::uint32_t i) {
      const auto h = PlaneDiagram::half_edge(TriangleId(k), i);
      return lift(centre_diagram.point(centre_diagram.apex(h)), 0);
    };
    for (std::size_t p = 0; p < sites.points.size(); ++p) {
      for (std::size_t q = 0; q < sites.points.size(); ++q) {
        if (p == q) continue;
        const Point3 a = lift(sites.points[PlaneVertexId(p)], z_sites);
        const Point3 b = lift(sites.points[PlaneVertexId(q)], z_sites);
        // Positive iff b lies within the sphere of the corners and a: b is nearer.
        const Sign inside = sites_above ? insphere_perturbed(corner(0), corner(1), corner(2), a, b)
                                        : insphere_perturbed(corner(1), corner(0), corner(2), a, b);
        ASSERT_NE(inside, Sign::zero);
        EXPECT_EQ(
            Bisector(planes, PlaneVertexId(p), PlaneVertexId(q)).nearer_to_first(TriangleId(k)),
            inside == Sign::negative);
      }
    }
  }
}

std::vector<Point2> draw(std::size_t n, Prng& prng, auto&& coordinate) {
  std::vector<Point2> points(n);
  for (Point2& p : points) {
    p.x = coordinate(prng);
    p.y = coordinate(prng);
  }
  return points;
}

TEST(Bisector, IsThePerturbedInsphere) {
  Prng prng(61);
  const auto grid = [](Prng& r) { return static_cast<double>(r.below(4)); };
  const auto unit = [](Prng& r) { return r.unit(); };
  const auto thirds = [](Prng& r) { return static_cast<double>(r.below(5)) / 3; };
  const auto tiny = [](Prng& r) { return 1e-160 * static_cast<double>(r.below(5)); };
  const auto far = [](Prng& r) { return 1e9 + 1e-6 * static_cast<double>(r.below(5)); };
  const auto wide = [](Prng& r) {
    return std::ldexp(r.unit() - 0.5, static_cast<int>(r.below(80)) - 40);
  };
  for (int round = 0; round < 40; ++round) {
    const bool above = round % 2 == 0;
    expect_insphere(plane_of(draw(7, prng, grid)), plane_of(draw(7, prng, grid)), above);
    expect_insphere(plane_of(draw(7, prng, unit)), plane_of(draw(7, prng, unit)), above);
    expect_insphere(plane_of(draw(7, prng, thirds)), plane_of(draw(7, prng, thirds)), above);
    expect_insphere(plane_of(draw(7, prng, tiny)), plane_of(draw(7, prng, tiny)), above);
    expect_insphere(plane_of(draw(7, prng, far)), plane_of(draw(7, prng, far)), above);
    expect_insphere(plane_of(draw(7, prng, wide)), plane_of(draw(7, prng, wide)), above);
  }
}

// Bisectors of sites far from centres that are known well, and that they pass nearby: what is lost
// comes from the sites.
TEST(Bisector, IsThePerturbedInsphereOfSitesAroundCentres) {
  Prng prng(63);
  const auto circle = [&](double radius) {
    std::vector<Point2> points(7);
    for (Point2& p : points) {
      const double angle = prng.between(0, 2 * std::numbers::pi);
      p = {radius * std::cos(angle), radius * std::sin(angle)};
    }
    return points;
  };
  for (int round = 0; round < 100; ++round) {
    const double radius = std::ldexp(1.0, static_cast<int>(prng.below(20)));
    expect_insphere(plane_of(circle(1)), plane_of(circle(radius)), round % 2 == 0);
  }
}

TEST(Bisector, EveryStageAnswers) {
  Prng prng(62);
  PredicateCounters counters;
  {
    const PredicateCounting counting(counters);
    const auto grid = [](Prng& r) { return static_cast<double>(r.below(4)); };
    const auto rounded = [](Prng& r) { return static_cast<double>(r.below(7)) / 10; };
    const auto wide = [](Prng& r) {
      return std::ldexp(r.unit() - 0.5, static_cast<int>(r.below(90)) - 45);
    };
    const auto huge = [](Prng& r) { return 1e250 * static_cast<double>(r.below(5)); };
    for (int round = 0; round < 60; ++round) {
      for (int kind = 0; kind < 4; ++kind) {
        const auto points = [&] {
          return plane_of(kind == 0   ? draw(12, prng, grid)
                          : kind == 1 ? draw(12, prng, rounded)
                          : kind == 2 ? draw(12, prng, wide)
                                      : draw(12, prng, huge));
        };
        const Triangulation2 centres = points();
        const Triangulation2 sites = points();
        if (centres.triangles.empty() || sites.triangles.empty()) continue;
        const double reach = std::max(delaunay3_detail::reach_of(centres.points),
                                      delaunay3_detail::reach_of(sites.points));
        const PlaneDiagram centre_diagram(centres, reach);
        const PlaneDiagram site_diagram(sites, reach);
        const CentresAndSites planes{&centre_diagram, &site_diagram, true};
        for (std::size_t k = 0; k < centre_diagram.finite_count(); ++k) {
          for (std::size_t p = 1; p < sites.points.size(); ++p) {
            (void)Bisector(planes, PlaneVertexId(p - 1), PlaneVertexId(p))
                .nearer_to_first(TriangleId(k));
          }
        }
      }
    }
  }
  EXPECT_GT(counters.insphere.filter, 0U);
  EXPECT_GT(counters.insphere.expansion, 0U);
  EXPECT_GT(counters.insphere.integer, 0U);
  EXPECT_GT(counters.insphere.symbolic, 0U);
}

TEST(TurnBetween, IsTheSignOfTheCrossProduct) {
  EXPECT_EQ(turn_between({0, 0}, {1, 0}, {5, 5}, {5, 6}), 1);
  EXPECT_EQ(turn_between({0, 0}, {1, 0}, {5, 6}, {5, 5}), -1);
  EXPECT_EQ(turn_between({0, 0}, {3, 1}, {5, 5}, {11, 7}), 0);
  // Parallel but for the last bit.
  EXPECT_EQ(turn_between({0, 0}, {1, 1}, {0, 0}, {1, 1 + 0x1p-52}), 1);
}

}  // namespace
}  // namespace tetloft::test
