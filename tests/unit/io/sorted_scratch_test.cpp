// More numbers than a run holds come back sorted.
#include "io/sorted_scratch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

std::vector<double> read_back(io::SortedScratch& sorted, std::size_t most) {
  std::vector<double> values;
  sorted.for_each([&](double value) {
    values.push_back(value);
    return values.size() < most;
  });
  return values;
}

TEST(SortedScratch, GivesBackWhatCameSorted) {
  const std::string path = ::testing::TempDir() + "/sorted";
  for (const std::size_t count : {0U, 1U, 6U, 7U, 8U, 49U, 300U}) {
    Prng prng(31 + count);
    io::SortedScratch sorted(path, 7, 3);
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k) {
      values.push_back(static_cast<double>(prng.below(40)) / 3);
      sorted.push_back(values.back());
    }
    std::sort(values.begin(), values.end());
    EXPECT_EQ(read_back(sorted, count + 1), values);
    EXPECT_EQ(read_back(sorted, count + 1), values) << "the second time";
    const std::vector<double> some = read_back(sorted, 5);
    EXPECT_EQ(some, std::vector<double>(values.begin(),
                                        values.begin() + static_cast<std::ptrdiff_t>(some.size())));
    EXPECT_EQ(some.size(), std::min<std::size_t>(count, 5));
    sorted.push_back(-1);
    values.insert(values.begin(), -1);
    EXPECT_EQ(read_back(sorted, count + 2), values);
    EXPECT_FALSE(sorted.failure());
  }
}

TEST(SortedScratch, TellsThatThereIsNoRoom) {
  io::SortedScratch sorted(::testing::TempDir() + "/there/is/none", 2, 1);
  for (const double value : {3.0, 2.0, 1.0}) sorted.push_back(value);
  EXPECT_TRUE(read_back(sorted, 9).empty());
  EXPECT_TRUE(sorted.failure());
}

}  // namespace
}  // namespace tetloft::testing
