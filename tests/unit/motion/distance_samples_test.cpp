#include "motion/distance_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/prng.hpp"
#include "unit/motion/distance_oracle.hpp"
#include "unit/motion/motion_stacks.hpp"

namespace tetloft::testing {

using namespace internal;
using motion::DistanceSamples;
using motion::LatticeEdges;
using motion::LatticeWindow;
using motion::sample_distances;
namespace {

// A square of half width 5 with a hole of half width 2, about the origin.
Section frame() {
  Section section;
  for (const double h : {5.0, 2.0}) {
    section.contours.push_back(Contour{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}});
  }
  return section;
}

TEST(DistanceSamples, AreExactAroundAFrame) {
  const DistanceSamples samples =
      sample_distances(LatticeEdges(frame(), 1), LatticeWindow{-12, -12, 13, 13});
  // Of the frame by its two squares: signed distance to a square about the origin.
  const auto square = [](double x, double y, double h) {
    const double dx = std::abs(x) - h;
    const double dy = std::abs(y) - h;
    const double outside =
        std::sqrt(std::max(dx, 0.0) * std::max(dx, 0.0) + std::max(dy, 0.0) * std::max(dy, 0.0));
    return outside + std::min(std::max(dx, dy), 0.0);
  };
  for (int y = -12; y <= 12; ++y) {
    for (int x = -12; x <= 12; ++x) {
      const double want = std::clamp(std::max(square(x, y, 5), -square(x, y, 2)), -4.0, 4.0);
      EXPECT_DOUBLE_EQ(std::abs(*samples.at(x, y)), std::abs(want)) << x << ' ' << y;
      EXPECT_TRUE(want == 0 || (*samples.at(x, y) < 0) == (want < 0)) << x << ' ' << y;
    }
  }
}

TEST(DistanceSamples, DoNotDependOnTheWindow) {
  const SectionStack stack = drifting_polygons(7, 1);
  const LatticeEdges edges(stack.sections[SectionId(0)], 0.21);
  const DistanceSamples all = sample_distances(edges, LatticeWindow{-20, -20, 60, 60});
  const DistanceSamples part = sample_distances(edges, LatticeWindow{7, 3, 25, 18});
  for (int j = 3; j < 18; ++j) {
    for (int i = 7; i < 25; ++i) EXPECT_EQ(*part.at(i, j), *all.at(i, j));
  }
}

TEST(DistanceSamples, OfNothingAreFarOutside) {
  const DistanceSamples samples =
      sample_distances(LatticeEdges(Section{}, 1), LatticeWindow{0, 0, 3, 2});
  EXPECT_EQ(samples.value, std::vector<double>(6, motion::kFarthest));
}

// A star-shaped polygon, jagged or smooth; or with its vertices on a lattice.
Contour star(Prng& prng, std::size_t vertices, double lattice) {
  const bool smooth = prng.chance(0.5);
  const double radius = prng.between(1, 12);
  const double phase = prng.unit();
  Contour contour;
  for (std::size_t v = 0; v < vertices; ++v) {
    const double angle =
        6.283185307179586 * (static_cast<double>(v) + phase) / static_cast<double>(vertices);
    const double r = radius * (smooth ? 1 + 0.1 * std::sin(3 * angle) : prng.between(0.3, 1));
    Point2 p{r * std::cos(angle) + 0.3, r * std::sin(angle) - 0.2};
    if (lattice > 0) p = {std::round(p.x / lattice) * lattice, std::round(p.y / lattice) * lattice};
    contour.vertices.push_back(p);
  }
  return contour;
}

void expect_by_all_edges(const Section& section, double step, double farthest) {
  const LatticeEdges edges(section, step);
  const LatticeWindow window{-31, -29, 30, 33};
  const DistanceSamples samples = sample_distances(edges, window, farthest);
  const motion::InsideSamples inside(edges, window);
  std::vector<std::uint8_t> near(samples.near.size(), 0);
  for (std::int64_t j = window.j0; j < window.j1; ++j) {
    std::int64_t count = 0;
    for (std::int64_t i = window.i0; i < window.i1; ++i) {
      const Point2 at{static_cast<double>(i), static_cast<double>(j)};
      ASSERT_EQ(*samples.at(i, j), distance_by_all_edges(section, step, at, farthest))
          << i << ' ' << j;
      const auto runs = inside.row(j);
      const auto in_runs = std::count_if(
          runs.begin(), runs.end(), [&](const auto& run) { return run.first <= i && i < run.end; });
      ASSERT_EQ(in_runs, *samples.at(i, j) < 0 ? 1 : 0) << i << ' ' << j;
      count += in_runs;
    }
    for (std::int64_t i = window.i0; i < window.i1; ++i) {
      constexpr auto kTile = static_cast<std::int64_t>(DistanceSamples::kTile);
      const std::int64_t row = (j - window.j0) / kTile;
      const std::int64_t column = (i - window.i0) / kTile;
      const auto tile =
          static_cast<std::size_t>(row) * samples.tiles_in_row() + static_cast<std::size_t>(column);
      if (std::abs(*samples.at(i, j)) < farthest) near[tile] = 1;
      if (samples.near[tile] != 0) continue;
      ASSERT_EQ(std::abs(*samples.at(i, j)), farthest) << i << ' ' << j;
      const double* const first = samples.at(window.i0 + kTile * column, window.j0 + kTile * row);
      ASSERT_EQ(*samples.at(i, j), *first) << i << ' ' << j;
    }
    std::int64_t length = 0;
    for (const auto& run : inside.row(j)) length += run.end - run.first;
    EXPECT_EQ(length, count);
  }
  EXPECT_EQ(samples.near, near);
}

TEST(DistanceSamples, AreThoseOfAllEdgesBitByBit) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    Prng prng(seed);
    const double lattice = seed % 3 == 0 ? 0.5 : 0;
    Section section;
    section.contours.push_back(star(prng, 3 + prng.below(60), lattice));
    if (prng.chance(0.3)) section.contours.push_back(star(prng, 3 + prng.below(9), lattice));
    const double step = lattice > 0 ? prng.chance(0.5) ? 0.25 : 0.375 : prng.between(0.2, 2);
    SCOPED_TRACE(seed);
    expect_by_all_edges(section, step, prng.between(1, 20));
  }
}

TEST(DistanceSamples, NeedNoLongEdgesToBeRight) {
  // Too long for what is left out, with ends at which much would be; and with edges of no length.
  Section section;
  section.contours.push_back(Contour{{{-1e5, -3}, {0.1, 0.2}, {0.1, 0.2}, {1e5, -3}, {7, 9}}});
  expect_by_all_edges(section, 1, 6);
}

TEST(DistanceSamples, OfDoubledAndTinyEdgesAreRight) {
  Section section;
  section.contours.push_back(Contour{{{-5, -5}, {6.3, 2.1}}});
  section.contours.push_back(Contour{{{1, 1}, {1 + 1e-9, 1}, {1, 1 + 1e-300}, {1, 1e-3}, {9, 4}}});
  section.contours.push_back(Contour{{{0, 0}, {0, 1e-200}, {1e-170, 0}, {-8, 3}}});
  expect_by_all_edges(section, 1, 5);
}

}  // namespace
}  // namespace tetloft::testing
