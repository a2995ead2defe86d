// Contours of slices: of any pixels they are valid, hold just the right centres, and areas are
// those that counting gives.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "core/prng.hpp"
#include "io/volume/stack_of_volume.hpp"
#include "support/memory_volume.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::MemoryVolume;
using Size = MemoryVolume::Size;

constexpr VolumeContours kBothWays[] = {VolumeContours::sub_pixel, VolumeContours::lattice};

ReadStack stack_of(MemoryVolume& volume, const ReadOptions& options) {
  Result<io::StackOfFile> made = io::stack_of_volume(volume, "file", options);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : to_string(made.error()));
  return made.ok() ? std::move(made->read) : ReadStack{};
}

ReadOptions label(double value, VolumeContours way) {
  ReadOptions options;
  options.structure = std::to_string(static_cast<int>(value));
  options.contours = way;
  return options;
}

bool holds(const Section& section, const Point2& p) {
  bool inside = false;
  for (const Contour& contour : section.contours) {
    const auto& v = contour.vertices;
    for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
      if ((v[i].y > p.y) == (v[j].y > p.y)) continue;
      if (p.x < v[i].x + (p.y - v[i].y) / (v[j].y - v[i].y) * (v[j].x - v[i].x)) inside = !inside;
    }
  }
  return inside;
}

// Of coordinates of few bits, exact.
double area_of(const Section& section) {
  double twice = 0;
  for (const Contour& contour : section.contours) {
    const auto& v = contour.vertices;
    for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
      twice += v[j].x * v[i].y - v[i].x * v[j].y;
    }
  }
  return twice / 2;
}

// The pixels of a slice: how many, how many corners of which two opposite pixels of four are in,
// and the Euler number of their union where pixels are neighbours over edges, by counting squares
// of four (Gray 1971).
struct Counted {
  int pixels = 0;
  int touching = 0;
  int euler = 0;
};
Counted counted(MemoryVolume& volume, std::size_t k) {
  const auto& size = volume.header().size;
  const auto in = [&](std::size_t i, std::size_t j) {
    return i - 1 < size[0] && j - 1 < size[1] && volume.at(i - 1, j - 1, k) == 1 ? 1 : 0;
  };
  Counted result;
  int ones = 0;
  int threes = 0;
  for (std::size_t j = 0; j <= size[1]; ++j) {
    for (std::size_t i = 0; i <= size[0]; ++i) {
      const int a = in(i, j), b = in(i + 1, j), c = in(i, j + 1), d = in(i + 1, j + 1);
      const int sum = a + b + c + d;
      result.pixels += a;
      ones += sum == 1 ? 1 : 0;
      threes += sum == 3 ? 1 : 0;
      result.touching += sum == 2 && a == d ? 1 : 0;
    }
  }
  result.euler = (ones - threes + 2 * result.touching) / 4;
  return result;
}

void expect_right_pixels(MemoryVolume& volume, const ReadStack& read, std::size_t first) {
  const auto& size = volume.header().size;
  for (std::size_t s = 0; s < read.stack.sections.size(); ++s) {
    const Section& section = read.stack.sections[SectionId(s)];
    ASSERT_EQ(section.z, static_cast<double>(first + s));
    for (std::size_t j = 0; j < size[1]; ++j) {
      for (std::size_t i = 0; i < size[0]; ++i) {
        ASSERT_EQ(holds(section, {static_cast<double>(i), static_cast<double>(j)}),
                  volume.at(i, j, first + s) == 1)
            << i << ' ' << j << ' ' << s;
      }
    }
  }
}

TEST(VolumeContours, OfRandomPixelsAreValidAndOfTheRightArea) {
  Prng prng(21);
  int touching = 0;
  for (int round = 0; round < 60; ++round) {
    const Size size{1 + prng.below(9), 1 + prng.below(9), 3};
    MemoryVolume volume(size);
    const std::uint64_t density = 1 + prng.below(9);
    volume.fill([&](auto, auto, auto k) { return k == 1 || prng.below(10) < density ? 1.0 : 2.0; });
    for (const VolumeContours way : kBothWays) {
      const ReadStack read = stack_of(volume, label(1, way));
      if (read.stack.sections.size() != 3) continue;  // an end without a pixel
      expect_right_pixels(volume, read, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        const Counted c = counted(volume, k);
        touching += c.touching;
        const double expected = way == VolumeContours::lattice ? c.pixels - c.touching / 16.0
                                                               : c.pixels - c.euler / 2.0;
        EXPECT_EQ(area_of(read.stack.sections[SectionId(k)]), expected);
      }
    }
  }
  EXPECT_GT(touching, 100);
}

TEST(VolumeContours, OfACheckerboardAreApart) {
  MemoryVolume volume({8, 7, 1});
  volume.fill([](auto i, auto j, auto) { return (i + j) % 2 == 0 ? 1.0 : 0.0; });
  for (const VolumeContours way : kBothWays) {
    const ReadStack read = stack_of(volume, label(1, way));
    EXPECT_EQ(read.stack.contour_count(), 28U);
    expect_right_pixels(volume, read, 0);
  }
}

TEST(VolumeContours, HolesRunClockwise) {
  MemoryVolume volume({5, 5, 1});
  volume.fill([](auto i, auto j, auto) { return i == 2 && j == 2 ? 0.0 : 1.0; });
  for (const VolumeContours way : kBothWays) {
    const Section section = stack_of(volume, label(1, way)).stack.sections[SectionId(0)];
    ASSERT_EQ(section.contours.size(), 2U);
    EXPECT_EQ(area_sign(section.contours[ContourId(0)]), Sign::positive);
    EXPECT_EQ(area_sign(section.contours[ContourId(1)]), Sign::negative);
  }
}

TEST(VolumeContours, OfTheLatticeHaveNoVerticesOnStraightRuns) {
  MemoryVolume volume({6, 4, 1});
  volume.fill([](auto, auto, auto) { return 1.0; });
  const Section section =
      stack_of(volume, label(1, VolumeContours::lattice)).stack.sections[SectionId(0)];
  ASSERT_EQ(section.contours.size(), 1U);
  const std::vector<Point2> expected{{5.5, -0.5}, {5.5, 3.5}, {-0.5, 3.5}, {-0.5, -0.5}};
  EXPECT_EQ(section.contours[ContourId(0)].vertices, expected);
}

TEST(VolumeContours, OfOnePixel) {
  MemoryVolume volume({1, 1, 1});
  volume.at(0, 0, 0) = 3;
  const Section diamond = stack_of(volume, {}).stack.sections[SectionId(0)];
  const std::vector<Point2> expected{{0, -0.5}, {0.5, 0}, {0, 0.5}, {-0.5, 0}};
  EXPECT_EQ(diamond.contours[ContourId(0)].vertices, expected);
}

TEST(VolumeContours, AtAnIsoValueAreInterpolated) {
  MemoryVolume volume({4, 1, 1});
  volume.fill([](auto i, auto, auto) { return std::array<double, 4>{0, 4, 12, 8}[i]; });
  ReadOptions options;
  options.iso = 3;
  const auto vertices =
      stack_of(volume, options).stack.sections[SectionId(0)].contours[ContourId(0)].vertices;
  // Half way at the border, a quarter from 4 to 0.
  const std::vector<Point2> expected{{1, -0.5}, {2, -0.5}, {3, -0.5}, {3.5, 0},
                                     {3, 0.5},  {2, 0.5},  {1, 0.5},  {0.75, 0}};
  EXPECT_EQ(vertices, expected);
}

TEST(VolumeContours, AtAnIsoValueThatVoxelsHaveDoNotMeet) {
  Prng prng(3);
  for (int round = 0; round < 60; ++round) {
    MemoryVolume volume({2 + prng.below(8), 2 + prng.below(8), 2});
    volume.fill([&](auto, auto, auto) { return static_cast<double>(prng.below(4)); });
    MemoryVolume mask = volume;
    mask.fill([&](auto i, auto j, auto k) { return volume.at(i, j, k) >= 2 ? 1.0 : 0.0; });
    ReadOptions options;
    options.iso = 2;
    for (const VolumeContours way : kBothWays) {
      options.contours = way;
      const Result<io::StackOfFile> made = io::stack_of_volume(volume, "file", options);
      if (!made) {
        EXPECT_EQ(made.error().code, ErrorCode::invalid_input) << made.error().message;
        continue;
      }
      const ReadStack& read = made->read;
      expect_right_pixels(mask, read,
                          static_cast<std::size_t>(read.stack.sections[SectionId(0)].z));
    }
  }
}

TEST(VolumeContours, OfValuesThatAreNoNumbersOrInfinite) {
  MemoryVolume volume({5, 5, 1});
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  volume.fill([&](auto i, auto j, auto) {
    return std::array<double, 5>{nan, inf, 1e308, -inf, -1e308}[(i + 2 * j) % 5];
  });
  MemoryVolume mask = volume;
  mask.fill([&](auto i, auto j, auto k) { return volume.at(i, j, k) >= 0 ? 1.0 : 0.0; });
  ReadOptions options;
  options.iso = 0;
  expect_right_pixels(mask, stack_of(volume, options), 0);
}

// The distance to a centre: sections at 0 are discs.
TEST(VolumeContours, OfABallHaveTheAreaOfDiscs) {
  const double radius = 14.25;
  MemoryVolume volume({33, 33, 33});
  const auto distance = [](std::size_t i, std::size_t j, std::size_t k) {
    const double x = static_cast<double>(i) - 16, y = static_cast<double>(j) - 16,
                 z = static_cast<double>(k) - 16;
    return std::sqrt(x * x + y * y + z * z);
  };
  volume.fill([&](auto i, auto j, auto k) { return radius - distance(i, j, k); });
  for (const int axis : {0, 1, 2}) {
    ReadOptions options;
    options.iso = 0;
    options.axis = axis;
    const ReadStack read = stack_of(volume, options);
    ASSERT_EQ(read.stack.sections.size(), 29U);
    for (const Section& section : read.stack.sections) {
      const double z = section.z - 16;
      const double disc = 3.14159265358979 * (radius * radius - z * z);
      // Chords of about a pixel cut off π/6 square pixels in all, whatever the disc, and distances
      // grow faster than linearly.
      EXPECT_NEAR(disc - std::abs(area_of(section)), 0.7, 0.6) << section.z;
    }
  }
}

TEST(VolumeContours, OfALabelledBallComeCloseToDiscs) {
  MemoryVolume volume({45, 45, 45});
  volume.fill([&](auto i, auto j, auto k) {
    const double x = static_cast<double>(i) - 22, y = static_cast<double>(j) - 22,
                 z = static_cast<double>(k) - 22;
    return x * x + y * y + z * z <= 400 ? 1.0 : 0.0;
  });
  for (const VolumeContours way : kBothWays) {
    double volume_of_ball = 0;
    for (const Section& section : stack_of(volume, label(1, way)).stack.sections) {
      volume_of_ball += area_of(section);
    }
    EXPECT_NEAR(volume_of_ball / (4.0 / 3 * 3.14159265358979 * 8000), 1, 0.01);
  }
}

}  // namespace
}  // namespace tetloft
