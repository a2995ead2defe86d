// What sheets tell apart has no contact by the exact test, which shares no code with them.
#include "contact/sheet.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "contact/contact.hpp"
#include "core/prng.hpp"

namespace tetloft::internal {
namespace {

using contact_detail::Sheet;
using contact_detail::Triangle3;
using Bundle = std::vector<Triangle3>;

bool touch_in_space(const Triangle3& a, const Triangle3& b) {
  const std::vector<Point3> points{a[0], a[1], a[2], b[0], b[1], b[2]};
  return triangles_touch(points, {VertexId(0), VertexId(1), VertexId(2)},
                         {VertexId(3), VertexId(4), VertexId(5)});
}

bool any_touch(const Bundle& a, const Bundle& b) {
  for (const Triangle3& s : a) {
    for (const Triangle3& t : b) {
      if (touch_in_space(s, t)) return true;
    }
  }
  return false;
}

struct Counts {
  int apart = 0;
  int touching = 0;
};

Counts compare(const std::function<Bundle()>& bundle, int pairs) {
  Counts counts;
  for (int k = 0; k < pairs; ++k) {
    const Bundle a = bundle();
    const Bundle b = bundle();
    const Sheet of_a(a);
    const Sheet of_b(b);
    const bool apart = of_a.apart(of_b);
    EXPECT_EQ(of_b.apart(of_a), apart);
    const bool touching = any_touch(a, b);
    EXPECT_FALSE(apart && touching) << "pair " << k;
    counts.apart += apart ? 1 : 0;
    counts.touching += touching ? 1 : 0;
  }
  return counts;
}

// Slivers side by side from number `first` on, as long as 100 of them are wide, at `height` in the
// middle.
Bundle strip(double angle, double height, std::size_t end, std::size_t first = 0) {
  const double x = std::cos(angle), y = std::sin(angle);
  const auto at = [&](double along, double aside) {
    return Point3{along * x - aside * y, along * y + aside * x, height + 0.1 * along};
  };
  Bundle strip;
  for (std::size_t k = first; k < end; ++k) {
    const double aside = 0.01 * static_cast<double>(k);
    strip.push_back({at(-0.5, aside), at(0.5, aside), at(0.5, aside + 0.01)});
  }
  return strip;
}

TEST(Sheet, TellsStripsApartSideBySideAndCrossing) {
  EXPECT_TRUE(Sheet(strip(0.7, 0, 8)).apart(Sheet(strip(0.7, 0.002, 8))));
  EXPECT_TRUE(Sheet(strip(0.7, 0, 8)).apart(Sheet(strip(1.1, 0.02, 8))));
  EXPECT_TRUE(Sheet(strip(0.7, 0, 1)).apart(Sheet(strip(0.7 + 1e-6, 1e-5, 1))));
  EXPECT_TRUE(Sheet(strip(0.7, 0, 8)).apart(Sheet(strip(0.7, 0, 16, 9))));
  EXPECT_FALSE(Sheet(strip(0.7, 0, 8)).apart(Sheet(strip(1.1, 0.0001, 8))));
  EXPECT_FALSE(Sheet(strip(0.7, 0, 8)).apart(Sheet(strip(0.7, 0, 8))));
}

TEST(Sheet, TellsNothingApartThatTouches) {
  Prng random(30);
  const auto at = [&] {
    return Point3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  };
  const Counts single = compare([&] { return Bundle{{at(), at(), at()}}; }, 20000);
  EXPECT_GT(single.touching, 1000);
  EXPECT_GT(single.apart, 10000);
  const auto strips = [&] {
    return strip(random.between(0, 3), random.between(-0.02, 0.02), 1 + random.below(8));
  };
  const Counts of_strips = compare(strips, 3000);
  EXPECT_GT(of_strips.touching, 300);
  EXPECT_GT(of_strips.apart, 300);
}

// Ties of all kinds, and degenerate triangles: closed sets that share a point are not apart.
TEST(Sheet, OfLatticePointsTellsNothingApartThatTouches) {
  Prng random(31);
  for (const std::size_t side : {2U, 3U, 6U}) {
    const auto coordinate = [&] { return 0.3 * static_cast<double>(random.below(side)); };
    const auto at = [&] { return Point3{coordinate(), coordinate(), coordinate()}; };
    const Counts counts = compare([&] { return Bundle{{at(), at(), at()}}; }, 20000);
    EXPECT_GT(counts.touching, 1000);
    EXPECT_GT(counts.apart, 100);
  }
}

// Triangles whose planes are off each other by some units in the last place, far from the origin:
// vertices of one are the middles of edges of the other, rounded.
TEST(Sheet, HoldsWhereGapsAreLostByRounding) {
  Prng random(32);
  const auto at = [&](double size) {
    return Point3{1 + size * random.between(-1, 1), 3 + size * random.between(-1, 1),
                  7 + size * random.between(-1, 1)};
  };
  const auto middle = [](const Point3& a, const Point3& b) {
    return Point3{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
  };
  int touching = 0;
  for (const double size : {1.0, 0x1p-20, 0x1p-40, 0x1p-48}) {
    for (int k = 0; k < 5000; ++k) {
      const Triangle3 a{at(size), at(size), at(size)};
      const Triangle3 b{middle(a[0], a[1]), at(size), at(size)};
      if (!touch_in_space(a, b)) continue;
      ++touching;
      EXPECT_FALSE(Sheet(std::span(&a, 1)).apart(Sheet(std::span(&b, 1))));
    }
  }
  EXPECT_GT(touching, 1000);
}

// Nothing over- or underflows into an answer.
TEST(Sheet, HoldsAtTheEndsOfTheRange) {
  Prng random(33);
  for (const double size : {0x1p1023, 0x1p600, 0x1p250, 0x1p-250, 0x1p-537, 0x1p-1074}) {
    const auto sign = [&] { return static_cast<double>(random.below(3)) - 1; };
    const auto at = [&] { return Point3{size * sign(), size * sign(), size * sign()}; };
    EXPECT_GT(compare([&] { return Bundle{{at(), at(), at()}}; }, 2000).touching, 100);
    const auto mixed = [&] { return Point3{size * sign(), size * sign(), sign()}; };
    EXPECT_GT(compare([&] { return Bundle{{mixed(), mixed(), mixed()}}; }, 2000).touching, 100);
  }
}

}  // namespace
}  // namespace tetloft::internal
