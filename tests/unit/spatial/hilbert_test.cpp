#include "spatial/hilbert.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace tetloft::internal::core {
namespace {

// Walks over all cells of a grid.
template <unsigned dimension>
void expect_unit_steps(unsigned bits) {
  using Cell = std::array<std::uint32_t, dimension>;
  const std::uint32_t side = 1U << bits;
  std::vector<Cell> at(std::size_t{1} << (dimension * bits));
  std::vector<bool> taken(at.size(), false);
  for (std::size_t i = 0; i < at.size(); ++i) {
    Cell cell;
    std::size_t rest = i;
    for (std::uint32_t& coordinate : cell) {
      coordinate = static_cast<std::uint32_t>(rest % side);
      rest /= side;
    }
    const std::uint64_t place = hilbert_index<dimension>(cell, bits);
    ASSERT_LT(place, at.size());
    ASSERT_FALSE(taken[place]);
    taken[place] = true;
    at[place] = cell;
  }
  for (std::size_t i = 1; i < at.size(); ++i) {
    int distance = 0;
    for (unsigned k = 0; k < dimension; ++k) {
      distance += std::abs(static_cast<int>(at[i][k]) - static_cast<int>(at[i - 1][k]));
    }
    ASSERT_EQ(distance, 1) << "step " << i << ", " << bits << " bits";
  }
}

TEST(HilbertIndex, VisitsEveryCellOfASquareByUnitSteps) {
  for (unsigned bits = 1; bits <= 6; ++bits) expect_unit_steps<2>(bits);
}

TEST(HilbertIndex, VisitsEveryCellOfACubeByUnitSteps) {
  for (unsigned bits = 1; bits <= 5; ++bits) expect_unit_steps<3>(bits);
}

TEST(HilbertIndex, UsesAllBits) {
  constexpr std::uint32_t top = 0xFFFFFFFF;
  EXPECT_EQ(hilbert_index<2>({0, 0}, 32), 0U);
  EXPECT_NE(hilbert_index<2>({top, 0}, 32), hilbert_index<2>({top - 1, 0}, 32));
  // The curve ends in a corner next to the one where it starts.
  EXPECT_EQ(std::max(hilbert_index<2>({top, 0}, 32), hilbert_index<2>({0, top}, 32)),
            ~std::uint64_t{0});
  constexpr std::uint32_t high = (1U << 21) - 1;
  EXPECT_NE(hilbert_index<3>({high, 0, 0}, 21), hilbert_index<3>({high - 1, 0, 0}, 21));
  EXPECT_EQ(std::max({hilbert_index<3>({high, 0, 0}, 21), hilbert_index<3>({0, high, 0}, 21),
                      hilbert_index<3>({0, 0, high}, 21)}),
            ~std::uint64_t{0} >> 1);
}

}  // namespace
}  // namespace tetloft::internal::core
