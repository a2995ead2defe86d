#include "delaunay3/canonical_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

void expect_canonical(const Points& points) {
  std::vector<std::uint32_t> expected(points.size());
  std::iota(expected.begin(), expected.end(), 0U);
  std::stable_sort(expected.begin(), expected.end(), [&](std::uint32_t a, std::uint32_t b) {
    return canonical_less(points[a], points[b]);
  });
  EXPECT_EQ(delaunay3_detail::canonical_order(points), expected);
}

TEST(CanonicalOrder, IsByCoordinatesThenByPlace) {
  Prng prng(8);
  expect_canonical({});
  expect_canonical({{1, 2, 3}});
  expect_canonical({{0.0, -0.0, 0.0}, {-0.0, 0.0, -0.0}, {-1, 0, 0}, {0, -1e-320, 0}});
  for (const std::uint64_t values : {2U, 5U, 100U}) {
    Points points(5000);
    for (Point3& p : points) {
      const auto drawn = [&] { return (double(prng.below(values)) - double(values / 2)) / 4; };
      p = {drawn(), drawn(), drawn()};
    }
    expect_canonical(points);
  }
  expect_canonical(uniform(5000, prng));
}

}  // namespace
}  // namespace tetloft::test
