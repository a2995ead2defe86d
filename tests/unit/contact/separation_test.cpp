// What Separation tells apart has no contact by the exact test, which shares no code with it.
#include "contact/separation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "contact/contact.hpp"
#include "contact/triangle_pair.hpp"

namespace tetloft::internal {
namespace {

using contact_detail::Axis;
using contact_detail::corners;
using contact_detail::facing_of;
using contact_detail::Separation;

constexpr TriangleVertices kFirst{VertexId(0), VertexId(1), VertexId(2)};
constexpr TriangleVertices kApart{VertexId(3), VertexId(4), VertexId(5)};
constexpr TriangleVertices kSharing{VertexId(0), VertexId(3), VertexId(4)};
constexpr std::array<std::uint32_t, 2> kBoth{0, 1};

struct Counts {
  int parted = 0;
  int touching = 0;
};

// Pairs of triangles without and with a common vertex, of points by `point`.
Counts compare(const std::function<Point3()>& point, int pairs) {
  Counts counts;
  for (int k = 0; k < pairs; ++k) {
    std::vector<Point3> points;
    for (int i = 0; i < 6; ++i) points.push_back(point());
    for (const TriangleVertices& other : {kApart, kSharing}) {
      const std::vector<TriangleVertices> both{kFirst, other};
      const bool share = other == kSharing;
      if (share && (facing_of(corners(points, kFirst)).axis == Axis::none ||
                    facing_of(corners(points, other)).axis == Axis::none)) {
        continue;  // may not be asked
      }
      const Separation separation(points, both, kBoth);
      const bool parted =
          share ? separation.meet_in_first_alone(kFirst, other) : separation.apart(kFirst, other);
      const bool touching = triangles_touch(points, kFirst, other);
      EXPECT_FALSE(parted && touching) << "pair " << k << (share ? ", sharing a vertex" : "");
      counts.parted += parted ? 1 : 0;
      counts.touching += touching ? 1 : 0;
    }
  }
  return counts;
}

TEST(Separation, PartsMostPairsThatAreApartAndNoneInContact) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> real(-1, 1);
  const Counts counts = compare(
      [&] {
        return Point3{real(random), real(random), real(random)};
      },
      20000);
  EXPECT_GT(counts.touching, 1000);
  EXPECT_GT(3 * counts.parted, 40000 - counts.touching);
}

// Ties of all kinds.
TEST(Separation, OfLatticePointsPartsNonePairInContact) {
  std::mt19937_64 random(21);
  for (const int side : {2, 3, 5}) {
    std::uniform_int_distribution<int> coordinate(0, side - 1);
    const auto at = [&] { return 0.5 * coordinate(random); };
    const Counts counts = compare([&] { return Point3{at(), at(), at()}; }, 20000);
    EXPECT_GT(counts.touching, 1000);
    EXPECT_GT(counts.parted, 100);
  }
}

// Differences are lost by rounding: of forms to doubles, and of these to floats.
TEST(Separation, HoldsWhereValuesDifferByLessThanRounding) {
  std::mt19937_64 random(22);
  std::uniform_int_distribution<int> step(0, 3);
  for (const double ulp : {0x1p-52, 0x1p-40, 0x1p-24, 0x1p-20}) {
    const auto near = [&] { return 1 + step(random) * ulp; };
    const auto thin = [&] { return Point3{near(), near() - 1, step(random) * 0x1p-70}; };
    EXPECT_GT(compare([&] { return Point3{near(), near(), near()}; }, 5000).touching, 100);
    EXPECT_GT(compare(thin, 5000).touching, 100);
  }
}

// Nothing overflows into an answer.
TEST(Separation, HoldsAtTheEndsOfTheRange) {
  std::mt19937_64 random(23);
  std::uniform_int_distribution<int> sign(-1, 1);
  for (const double size : {0x1p1023, 0x1p900, 0x1p-1000, 0x1p-1074}) {
    const auto at = [&] { return size * sign(random); };
    EXPECT_GT(compare([&] { return Point3{at(), at(), at()}; }, 3000).touching, 100);
    EXPECT_GT(compare([&] { return Point3{at(), at(), 1.0 * sign(random)}; }, 3000).touching, 100);
  }
}

}  // namespace
}  // namespace tetloft::internal
