// Closed segments in the plane, on all segments of a small grid.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "contact/planar.hpp"
#include "unit/contact/oracle.hpp"

namespace tetloft::contact_test {

using namespace internal;
namespace {

using contact_detail::segments_meet;

TEST(SegmentsMeet, AgreesWithLinearAlgebraOnAllSegmentsOfAGrid) {
  // Segments are triangles whose third vertex repeats the second.
  std::vector<std::array<Grid3, 3>> segments;
  for (Int i = 0; i < 9; ++i) {
    for (Int j = 0; j < 9; ++j) {
      const Grid3 p{i % 3, i / 3, 0};
      const Grid3 q{j % 3, j / 3, 0};
      segments.push_back({p, q, q});
    }
  }
  const auto point = [](const Grid3& p) {
    return Point2{static_cast<double>(p[0]), static_cast<double>(p[1])};
  };
  for (const auto& s : segments) {
    for (const auto& t : segments) {
      EXPECT_EQ(segments_meet({point(s[0]), point(s[1])}, {point(t[0]), point(t[1])}),
                !extreme_common_points(s, t).empty());
    }
  }
}

}  // namespace
}  // namespace tetloft::contact_test
