// Touches of regions and voids against pixels: a touch is what is there once both sections are
// grown by a little, and is not once they are shrunk.
#include "sections/face_overlay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <tetloft/sections.hpp>

#include "core/prng.hpp"
#include "support/stacks/bitmap.hpp"

namespace tetloft::testing {
namespace {

using namespace internal::sections;

constexpr int kFine = 4;  // subpixels to a pixel: growing by one joins nothing within a section
constexpr int kSize = 7;

// A number for each pixel of a frame around: of its part of the set, or of what is not set; −1 on
// the other side. Parts by their lowest pixels, (x, y), but the outside, which is first.
struct Parts {
  int size = 0;
  std::vector<int> of;
  int count = 0;
  [[nodiscard]] int at(int x, int y) const { return of[static_cast<std::size_t>(x * size + y)]; }
};

Parts parts(const Bitmap& bitmap, bool set) {
  Parts result;
  result.size = kSize + 2;
  result.of.assign(static_cast<std::size_t>(result.size * result.size), -1);
  for (int x = 0; x < result.size; ++x) {
    for (int y = 0; y < result.size; ++y) {
      if (bitmap.at(x - 1, y - 1) != set || result.at(x, y) != -1) continue;
      std::vector<std::pair<int, int>> stack{{x, y}};
      while (!stack.empty()) {
        const auto [u, v] = stack.back();
        stack.pop_back();
        if (u < 0 || v < 0 || u >= result.size || v >= result.size) continue;
        if (bitmap.at(u - 1, v - 1) != set || result.at(u, v) != -1) continue;
        result.of[static_cast<std::size_t>(u * result.size + v)] = result.count;
        for (const auto& [du, dv] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          stack.emplace_back(u + du, v + dv);
        }
      }
      ++result.count;
    }
  }
  return result;
}

// In subpixels, the part that holds all of a square of three about the subpixel (shrunk), or any
// of it (grown); −1: none. Grown parts of one section do not meet.
Parts resized(const Parts& coarse, bool grown) {
  Parts fine;
  fine.size = coarse.size * kFine;
  fine.of.assign(static_cast<std::size_t>(fine.size * fine.size), -1);
  fine.count = coarse.count;
  const auto part = [&](int x, int y) {
    const auto inside = [&](int u) { return std::clamp(u, 0, fine.size - 1) / kFine; };
    return coarse.at(inside(x), inside(y));
  };
  for (int x = 0; x < fine.size; ++x) {
    for (int y = 0; y < fine.size; ++y) {
      int any = -1;
      bool all = true;
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) {
          const int p = part(x + dx, y + dy);
          any = std::max(any, p);
          all = all && p == part(x, y);
        }
      }
      fine.of[static_cast<std::size_t>(x * fine.size + y)] = grown ? any : (all ? part(x, y) : -1);
    }
  }
  return fine;
}

// Of each pair of parts that have subpixels in common: the Euler characteristic of these.
using Common = std::map<std::pair<int, int>, long>;

Common common(const Parts& lower, const Parts& upper) {
  Common chi;
  const auto at = [&](int x, int y) { return std::pair{lower.at(x, y), upper.at(x, y)}; };
  for (int x = 0; x < lower.size; ++x) {
    for (int y = 0; y < lower.size; ++y) {
      const auto pair = at(x, y);
      if (pair.first < 0 || pair.second < 0) continue;
      const bool right = x + 1 < lower.size && at(x + 1, y) == pair;
      const bool above = y + 1 < lower.size && at(x, y + 1) == pair;
      const bool corner = right && above && at(x + 1, y + 1) == pair;
      chi[pair] += 1 - (right ? 1 : 0) - (above ? 1 : 0) + (corner ? 1 : 0);
    }
  }
  return chi;
}

long sum(const Common& common) {
  long total = 0;
  for (const auto& [pair, chi] : common) total += chi;
  return total;
}

struct Pair {
  Bitmap lower, upper;
};

// Blocks of few pixels with holes: touches of every kind.
Pair random_pair(Prng& prng) {
  const double density = prng.between(0.3, 0.8);
  const auto draw = [&] {
    return without_diagonals(random_bitmap(prng, kSize, kSize, density, 0));
  };
  return {draw(), draw()};
}

Section section_of(const Bitmap& bitmap, bool merge) {
  Section section;
  for (Contour& contour : staircase(bitmap, merge)) section.contours.push_back(std::move(contour));
  return section;
}

FaceOverlay overlay_of(const Section& lower, const Section& upper) {
  return {lower, nest(lower), upper, nest(upper)};
}

TEST(OverlayTouches, OfRegionsAreWhatGrowingAdds) {
  Prng prng(71);
  long touches = 0, connections = 0;
  std::size_t meetings = 0, touching_only = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    const Pair pair = random_pair(prng);
    const FaceOverlay overlay =
        overlay_of(section_of(pair.lower, round % 2 == 0), section_of(pair.upper, round % 3 == 0));
    const Parts lower = parts(pair.lower, true);
    const Parts upper = parts(pair.upper, true);
    const Common grown = common(resized(lower, true), resized(upper, true));
    const Common shrunk = common(resized(lower, false), resized(upper, false));
    long chi = 0, with_touches = 0;
    std::size_t overlapping = 0;
    for (const RegionMeeting& m : overlay.meetings()) {
      EXPECT_GE(m.touches, 0);
      EXPECT_GE(m.connections, 0);
      chi += m.chi;
      with_touches += m.chi + m.touches - m.connections;
      overlapping += m.overlap ? 1 : 0;
      touches += m.touches;
      connections += m.connections;
    }
    EXPECT_EQ(overlay.meetings().size(), grown.size());
    EXPECT_EQ(overlapping, shrunk.size());
    EXPECT_EQ(chi, sum(shrunk));
    EXPECT_EQ(with_touches, sum(grown));
    meetings += grown.size();
    touching_only += grown.size() - shrunk.size();
  }
  EXPECT_GT(meetings, 1000U);
  EXPECT_GT(touching_only, 300U);
  EXPECT_GT(touches, 300);
  EXPECT_GT(connections, 100);
}

TEST(OverlayTouches, OfVoidsAreWhatGrowingThemAdds) {
  Prng prng(72);
  std::size_t touching = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    const Pair pair = random_pair(prng);
    const FaceOverlay overlay =
        overlay_of(section_of(pair.lower, true), section_of(pair.upper, true));
    const Parts lower = parts(pair.lower, false);
    const Parts upper = parts(pair.upper, false);
    const Common grown = common(resized(lower, true), resized(upper, true));
    const Common shrunk = common(resized(lower, false), resized(upper, false));
    std::vector<std::pair<int, int>> told;
    for (const VoidPair& voids : overlay.touching_voids()) {
      told.emplace_back(static_cast<int>(voids.lower.value()),
                        static_cast<int>(voids.upper.value()));
    }
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    for (const auto& voids : told) EXPECT_TRUE(grown.contains(voids));
    for (const auto& [voids, chi] : grown) {
      if (shrunk.contains(voids)) continue;
      EXPECT_EQ(std::count(told.begin(), told.end(), voids), 1);
      ++touching;
    }
  }
  EXPECT_GT(touching, 100U);
}

}  // namespace
}  // namespace tetloft::testing
