#include "between/distance_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
using motion::DistanceSamples;
using motion::LatticeWindow;
namespace {

constexpr double kFar = 3;

// A disc, far from its border nothing but ±kFar.
DistanceSamples disc(const LatticeWindow& window) {
  DistanceSamples samples{window, {}, {}};
  for (std::int64_t j = window.j0; j < window.j1; ++j) {
    for (std::int64_t i = window.i0; i < window.i1; ++i) {
      const auto x = static_cast<double>(i);
      const auto y = static_cast<double>(j);
      samples.value.push_back(std::clamp((x * x + y * y - 400) / 40, -kFar, kFar));
    }
  }
  constexpr std::size_t kTile = DistanceSamples::kTile;
  samples.near.assign(samples.tiles_in_row() * ((window.ny() + kTile - 1) / kTile), 0);
  for (std::size_t k = 0; k < samples.value.size(); ++k) {
    if (std::abs(samples.value[k]) == kFar) continue;
    samples.near[k / window.nx() / kTile * samples.tiles_in_row() + k % window.nx() / kTile] = 1;
  }
  return samples;
}

TEST(DistanceField, IsBilinearAndFarOutsideBeyondItsSamples) {
  const DistanceSamples samples{{2, 3, 4, 5}, {0, 1, 2, 4}, {1}};
  const DistanceField field(samples, 9);
  EXPECT_EQ(field.at(2, 3), 0);
  EXPECT_EQ(field.at(2.5, 3), 0.5);
  EXPECT_EQ(field.at(2, 3.5), 1);
  EXPECT_EQ(field.at(2.5, 3.5), 1.75);
  EXPECT_EQ(field.at(1.5, 3), 9);
  EXPECT_EQ(field.at(2, 4), 9);
  EXPECT_EQ(field.at(3, 3.5), 9);
  std::vector<double> row;
  const double* const got = field.row(1, 6, 4, row);
  EXPECT_EQ(std::vector<double>(got, got + 5), (std::vector<double>{9, 2, 4, 9, 9}));
  EXPECT_EQ(field.row(2, 4, 3, row)[1], 1);
  EXPECT_EQ(DistanceField(7).at(0, 0), 7);
  EXPECT_EQ(DistanceField(7).depth({-5, -5, 5, 5}), Depth::far_outside);
}

TEST(DistanceField, ItsDepthIsThatOfAllPlacesInABox) {
  const DistanceField field(disc({-40, -33, 37, 42}), kFar);
  Prng prng(1);
  std::array<int, 3> seen{};
  for (int trial = 0; trial < 4000; ++trial) {
    const Point2 low{prng.between(-50, 45), prng.between(-50, 45)};
    const Box2 box{low.x, low.y, low.x + prng.between(0, 12), low.y + prng.between(0, 12)};
    const Depth depth = field.depth(box);
    ++seen[static_cast<std::size_t>(depth)];
    for (int k = 0; k < 20; ++k) {
      const Point2 p{prng.between(box.x0, box.x1), prng.between(box.y0, box.y1)};
      const double value = field.at(p.x, p.y);
      if (depth == Depth::far_outside) {
        EXPECT_EQ(value, kFar);
      }
      if (depth == Depth::far_inside) {
        EXPECT_EQ(value, -kFar);
      }
      if (field.samples_all(box)) {
        EXPECT_EQ(value, field.sampled().at(p.x, p.y));
      }
    }
  }
  for (const int times : seen) EXPECT_GT(times, 50);
}

}  // namespace
}  // namespace tetloft::testing
