#include "between/cheapest_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// Samples with random costs, a few of them closed, and the border as well.
struct Terrain {
  motion::LatticeWindow window{0, 0, 16, 13};
  std::vector<double> cost;
  bool diagonal;

  Terrain(Prng& random, bool with_diagonals) : diagonal(with_diagonals) {
    for (std::int64_t j = 0; j < 13; ++j) {
      for (std::int64_t i = 0; i < 16; ++i) {
        const bool closed = i == 0 || j == 0 || i == 15 || j == 12 || random.chance(0.15);
        cost.push_back(closed ? kNever : 0.1 + static_cast<double>(random.below(40)) / 8);
      }
    }
  }
  [[nodiscard]] PathSearch search() const {
    return PathSearch(window.size(),
                      diagonal ? steps_with_diagonals(window) : straight_steps(window));
  }
  [[nodiscard]] SampleCost costs() const {
    return [this](std::uint32_t place) { return cost[place]; };
  }
  [[nodiscard]] bool are_neighbours(std::uint32_t a, std::uint32_t b) const {
    const int di = std::abs(static_cast<int>(a % 16) - static_cast<int>(b % 16));
    const int dj = std::abs(static_cast<int>(a / 16) - static_cast<int>(b / 16));
    return diagonal ? std::max(di, dj) == 1 : di + dj == 1;
  }
  [[nodiscard]] std::uint32_t random_place(Prng& random) const {
    return static_cast<std::uint32_t>((1 + random.below(11)) * 16 + 1 + random.below(14));
  }
  // The least sum of costs strictly between the two, by going over all until nothing changes.
  [[nodiscard]] double least_between(const std::vector<std::uint32_t>& from,
                                     const std::vector<std::uint32_t>& to) const {
    std::vector<double> least(cost.size(), kNever);
    for (const std::uint32_t a : from) least[a] = 0;
    double best = kNever;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t a = 0; a < cost.size(); ++a) {
        for (std::uint32_t b = 0; b < cost.size(); ++b) {
          if (least[a] == kNever || !are_neighbours(a, b)) continue;
          if (least[a] + cost[b] < least[b]) {
            least[b] = least[a] + cost[b];
            changed = true;
          }
          if (std::find(to.begin(), to.end(), b) != to.end()) best = std::min(best, least[a]);
        }
      }
    }
    return best;
  }
  // Of a path, without its ends; checks that it is one.
  [[nodiscard]] double cost_of(const SamplePath& path) const {
    double sum = 0;
    for (std::size_t k = 1; k < path.size(); ++k) {
      EXPECT_TRUE(are_neighbours(path[k - 1], path[k]));
      if (k + 1 < path.size()) sum += cost[path[k]];
    }
    return sum;
  }
};

TEST(CheapestPaths, TheTargetIsReachedAtTheLeastCost) {
  std::size_t reached = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Prng random(seed);
    const Terrain terrain(random, seed % 2 == 0);
    const std::uint32_t from = terrain.random_place(random);
    const std::uint32_t to = terrain.random_place(random);
    if (from == to) continue;
    // Being on the target costs nothing.
    const auto cost = [&](std::uint32_t place) { return place == to ? 0 : terrain.cost[place]; };
    const auto path = terrain.search().reach(
        {from}, [&](std::uint32_t at) { return at == to; }, cost);
    const double least = terrain.least_between({from}, {to});
    ASSERT_EQ(path.has_value(), least < kNever);
    if (!path) continue;
    ++reached;
    EXPECT_EQ(path->front(), to);
    EXPECT_EQ(path->back(), from);
    EXPECT_NEAR(terrain.cost_of(*path), least, 1e-9);
  }
  EXPECT_GT(reached, 40U);
}

TEST(CheapestPaths, SourcesAreJoinedByALeastTree) {
  std::size_t joined = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Prng random(seed);
    const Terrain terrain(random, seed % 2 == 0);
    std::vector<std::vector<std::uint32_t>> sources;
    std::vector<std::uint32_t> used;
    while (sources.size() < 4) {
      const std::uint32_t at = terrain.random_place(random);
      if (std::find(used.begin(), used.end(), at) != used.end()) continue;
      used.push_back(at);
      sources.push_back({at});
    }
    double cost = 0;
    const std::vector<SamplePath> paths = terrain.search().join(sources, terrain.costs());
    for (const SamplePath& path : paths) cost += terrain.cost_of(path);
    // Kruskal on all pairs.
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> pairs;
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = a + 1; b < 4; ++b) {
        // Sources stand in nobody's way: one that is passed through joins at once.
        pairs.push_back({terrain.least_between(sources[a], sources[b]), {a, b}});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<std::size_t> set{0, 1, 2, 3};
    double want = 0;
    std::size_t edges = 0;
    for (const auto& [least, ends] : pairs) {
      const std::size_t a = set[ends.first];
      const std::size_t b = set[ends.second];
      if (a == b || least == kNever) continue;
      std::replace(set.begin(), set.end(), a, b);
      want += least;
      ++edges;
    }
    ASSERT_EQ(paths.size(), edges) << seed;
    EXPECT_NEAR(cost, want, 1e-9) << seed;
    joined += edges;
  }
  EXPECT_GT(joined, 80U);
}

TEST(CheapestPaths, SourcesSideBySideAreJoinedForNothing) {
  Prng random(1);
  const Terrain terrain(random, false);
  const std::vector<SamplePath> paths =
      terrain.search().join({{5 * 16 + 5}, {5 * 16 + 6}}, terrain.costs());
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].size(), 2U);
}

TEST(CheapestPaths, OnlyPassagesAreTaken) {
  const motion::LatticeWindow window{0, 0, 9, 9};
  // Nothing leads from column 4 to column 5 but in row 7.
  PathSearch search(window.size(), straight_steps(window), [](std::uint32_t a, std::uint32_t b) {
    return a / 9 == 7 || std::min(a, b) % 9 != 4 || a / 9 != b / 9;
  });
  const auto cost = [](std::uint32_t at) {
    return at % 9 == 0 || at % 9 == 8 || at < 9 || at >= 72 ? kNever : 1.0;
  };
  const std::vector<SamplePath> paths = search.join({{2 * 9 + 2}, {2 * 9 + 6}}, cost);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].size(), 15U);
  EXPECT_NE(std::find(paths[0].begin(), paths[0].end(), 7 * 9 + 4U), paths[0].end());
}

}  // namespace
}  // namespace tetloft::testing
