// Lattices computed in two ways: the bits named merge what rounding tells apart, and no more.
#include "reconstruct/lattice_hint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace tetloft::testing {

using namespace internal;
namespace {

using Computed = std::function<double(int)>;

Section squares(const Computed& at, double z) {
  Section section;
  section.z = z;
  for (int i = 1; i < 20; i += 2) {
    Contour contour;
    contour.vertices = {{at(i), at(7)}, {at(i + 1), at(7)}, {at(i + 1), at(8)}, {at(i), at(8)}};
    section.contours.push_back(contour);
  }
  return section;
}

int bits_of(const Section& lower, const Section& upper) {
  return merging_bits(conform(lower, SectionId(0)).value(), conform(upper, SectionId(1)).value());
}

TEST(LatticeHint, MergesLatticesComputedInTwoWays) {
  const std::pair<Computed, Computed> exporters[] = {
      {[](int i) { return i * 0.1; }, [](int i) { return i / 10.0; }},
      {[](int i) { return i * 0.1; }, [](int i) { return (i * 0.1 + 77.7) - 77.7; }},
      {[](int i) { return i * 0.7; },
       [](int i) { return static_cast<double>(static_cast<float>(i) * 0.7F); }}};
  for (const auto& [first, second] : exporters) {
    const Section lower = squares(first, 0);
    const Section upper = squares(second, 1);
    const int bits = bits_of(lower, upper);
    ASSERT_GT(bits, 0);
    double largest = 0;
    for (int i = 1; i <= 20; ++i) largest = std::max({largest, first(i), second(i)});
    int exponent = 0;
    (void)std::frexp(largest, &exponent);
    for (int i = 1; i <= 20; ++i) {
      const auto cell = [&](double t) { return std::nearbyint(std::ldexp(t, bits - exponent)); };
      EXPECT_LE(std::abs(cell(first(i)) - cell(second(i))), 1);
      EXPECT_GT(cell(first(i + 1)) - cell(first(i)), 1);
    }
  }
}

TEST(LatticeHint, SaysNothingWithoutSmallDifferences) {
  const Computed at = [](int i) { return i * 0.25; };
  EXPECT_EQ(bits_of(squares(at, 0), squares(at, 1)), 0);
}

}  // namespace
}  // namespace tetloft::testing
