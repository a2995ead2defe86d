#include "motion/distance_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace tetloft::testing
