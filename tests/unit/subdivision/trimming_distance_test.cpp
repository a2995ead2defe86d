// Distances to a region through the tree are those of a search of all edges, bit for bit.
#include "subdivision/trimming_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

double by_all_edges(const ConformingSection& section, const Point2& p) {
  double best = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t k = 0; k < section.vertex_count(); ++k) {
    const Point2 a = section.point(PlaneVertexId(k));
    const Point2 b = section.point(section.next[PlaneVertexId(k)]);
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
    const double t = std::clamp(along, 0.0, 1.0);
    best = std::min(best, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / dy * dx) inside = !inside;
  }
  return inside ? 0 : best;
}

/// Rings around one centre, far from the origin or not, on a lattice of quarters or not.
ConformingSection rings(int count, int corners, double centre, bool lattice, Prng& prng) {
  Section section;
  for (int ring = 0; ring < count; ++ring) {
    Contour contour;
    for (int k = 0; k < corners; ++k) {
      const double angle = 6.283185307179586 * (k + 0.3 * prng.unit()) / corners;
      const double radius = 4 + 4 * ring + prng.unit();
      Point2 p{centre + radius * std::cos(angle), centre - radius * std::sin(angle)};
      if (lattice) p = {std::round(4 * p.x) / 4, std::round(4 * p.y) / 4};
      contour.vertices.push_back(p);
    }
    section.contours.push_back(contour);
  }
  return conform(section, SectionId(0)).value();
}

TEST(RegionDistance, IsTheLeastOfAllEdges) {
  Prng prng(5);
  std::size_t inside = 0;
  std::size_t outside = 0;
  for (const double centre : {0.0, -3.0, 1e9}) {
    for (const bool lattice : {false, true}) {
      const ConformingSection section = rings(6, 9, centre, lattice, prng);
      const RegionDistance region(section);
      for (int k = 0; k < 2000; ++k) {
        Point2 p{centre + prng.between(-40, 40), centre + prng.between(-40, 40)};
        if (k % 2 == 0) p = {std::round(4 * p.x) / 4, std::round(4 * p.y) / 4};
        if (k % 10 == 0) p = section.point(PlaneVertexId(prng.below(section.vertex_count())));
        const double expected = by_all_edges(section, p);
        ++(expected == 0 ? inside : outside);
        const double enough = k % 3 == 0 ? 0.0 : prng.between(0, 3);
        // On a contour the oracle may say either.
        if (expected > 1e-6 * (1 + std::abs(centre))) {
          ASSERT_FALSE(region.contains(p));
        }
        if (expected == 0) {
          ASSERT_TRUE(region.contains(p));
          continue;
        }
        const double found = region.distance(p, enough);
        if (expected > enough) {
          ASSERT_EQ(found, expected);
        } else {
          ASSERT_LE(found, enough);
        }
      }
    }
  }
  EXPECT_GT(inside, 1000U);
  EXPECT_GT(outside, 1000U);
}

TEST(RegionDistance, WithoutContoursIsInfinite) {
  const ConformingSection section = conform(Section{}, SectionId(0)).value();
  EXPECT_EQ(RegionDistance(section).distance({0, 0}, 1), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(RegionDistance(section).contains({0, 0}));
}

}  // namespace
}  // namespace tetloft::testing
