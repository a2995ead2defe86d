#include "between/layer_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "core/prng.hpp"
#include "motion/distance_samples.hpp"
#include "unit/between/class_shapes.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
using motion::LatticeWindow;
namespace {

// Discs of changing size, here and there, in up to four sections.
FieldsAround discs_around(Prng& prng) {
  FieldsAround around;
  around.reach = prng.between(1, 9);
  if (prng.chance(0.8)) around.beside.behind = prng.between(0.3, 2);
  if (prng.chance(0.8)) around.beside.beyond = prng.between(0.3, 2);
  around.beside.ends_behind = prng.chance(0.2);
  around.beside.ends_beyond = prng.chance(0.2);
  around.share = {-around.beside.behind.value_or(0), 0, 1, 1 + around.beside.beyond.value_or(0)};
  for (std::size_t s = 0; s < 4; ++s) {
    if (prng.chance(0.15)) {
      around.field[s] = DistanceField(around.reach);
      continue;
    }
    const Contour contour = circle({prng.between(-4, 4), prng.between(-4, 4)}, prng.between(2, 14));
    const auto side = static_cast<std::int64_t>(12 + prng.below(20));
    const motion::LatticeEdges edges(std::vector<const Contour*>{&contour}, 1);
    around.field[s] = DistanceField(
        sample_distances(edges, {-side, -side + 1, side + 2, side}, around.reach), around.reach);
  }
  return around;
}

// One sample after the other, as the README defines it.
double plain_value(const FieldsAround& around, double share, double x, double y, const Point2& u) {
  const auto moved = [&](std::size_t s) {
    const double by = around.share[s] - share;
    return around.field[s].at(x + by * u.x, y + by * u.y);
  };
  const double low = moved(lower);
  const double high = moved(upper);
  if (low >= 0.4 * around.reach && high >= 0.4 * around.reach) return std::min(low, high);
  if (low <= -around.reach && high <= -around.reach) return -around.reach;
  double v = SectionCubic(share, around.beside).at({moved(behind), low, high, moved(beyond)});
  if (low < 0 && high < 0) v = std::min(v, std::max(low, high) / 2);
  return v == 0 ? 0x1p-30 : v;
}

TEST(LayerValues, AreThoseOfEachSampleByItself) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Prng prng(seed);
    const FieldsAround around = discs_around(prng);
    const LatticeWindow window{-static_cast<std::int64_t>(20 + prng.below(9)), -23,
                               static_cast<std::int64_t>(18 + prng.below(9)), 21};
    const double share = prng.between(0.1, 0.9);
    std::vector<Point2> motion;
    for (std::int64_t j = window.j0; j < window.j1; ++j) {
      for (std::int64_t i = window.i0; i < window.i1; ++i) {
        const double x = 0.1 * static_cast<double>(i);
        const double y = 0.1 * static_cast<double>(j);
        motion.push_back({4 * std::sin(x + y), 3 * std::cos(y) - x});
      }
    }
    const WindowMotion moves(window, motion);
    const std::vector<double> at_rest = layer_values(around, window, nullptr, share);
    const std::vector<double> moved = layer_values(around, window, &moves, share);
    for (std::int64_t j = window.j0; j < window.j1; ++j) {
      for (std::int64_t i = window.i0; i < window.i1; ++i) {
        const auto x = static_cast<double>(i);
        const auto y = static_cast<double>(j);
        const std::size_t k = window.place(i, j);
        ASSERT_EQ(moved[k], plain_value(around, share, x, y, motion[k])) << seed;
        const double still = plain_value(around, share, x, y, {});
        // Beyond the last row or column of its samples a field at rest is looked up by whole steps.
        const bool on_border =
            std::any_of(around.field.begin(), around.field.end(), [&](const DistanceField& field) {
              return !field.samples_all({x, y, x, y});
            });
        if (on_border) continue;
        ASSERT_EQ(at_rest[k], still) << seed;
      }
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
