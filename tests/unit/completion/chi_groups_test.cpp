// How far groups of classes are from what their Euler characteristics should be.
#include "completion/chi_groups.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "unit/completion/void_slab.hpp"

namespace tetloft::testing {
namespace {

TEST(ChiGroups, TellHowFarSumsAreFromTheirRanges) {
  // Two columns, one of them hollow.
  const auto s =
      void_slab(stack_of_boxes({{box(-9, -4, -1, 4), box(1, -4, 9, 4), box(3, -2, 7, 2)},
                                {box(-9, -4, -1, 4), box(1, -4, 9, 4), box(3, -2, 7, 2)}}),
                true);
  ASSERT_TRUE(s);
  ASSERT_EQ(s->classes().class_count(), 2U);
  const ClassId a(0U);
  const ClassId b(1U);
  const auto chi = attached_chi(s->slab(), s->classes(), s->active, s->completion.complex());
  ASSERT_EQ(chi[a] + chi[b], 1);
  const auto groups = [&](std::vector<ChiRange> ranges) {
    return ChiGroups(s->slab(), s->classes(), s->active, std::move(ranges));
  };
  const ChiGroups one = groups({{{a, b}, 0, 0}});
  const ChiGroups::Sums sums = one.sums(s->completion.complex());
  EXPECT_EQ(sums, (ChiGroups::Sums{1}));
  EXPECT_EQ(one.deviation(sums), 1);
  EXPECT_TRUE(one.any_high(sums) && one.is_high(a, sums) && one.is_high(b, sums));
  EXPECT_FALSE(one.any_low(sums) || one.is_low(a, sums));
  const ChiGroups two = groups({{{a}, chi[a] - 1, chi[a]}, {{b}, chi[b] + 2, chi[b] + 3}});
  EXPECT_EQ(two.sums(s->completion.complex()), (ChiGroups::Sums{chi[a], chi[b]}));
  EXPECT_EQ(two.deviation({chi[a], chi[b]}), 2);
  EXPECT_EQ(two.deviation({chi[a] - 3, chi[b] + 5}), 4);
  EXPECT_TRUE(two.is_low(b, {chi[a], chi[b]}));
  EXPECT_FALSE(two.is_low(a, {chi[a], chi[b]}) || two.is_high(a, {chi[a], chi[b]}));
  // Of a class in no group nothing is asked.
  const ChiGroups none = groups({{{a}, 5, 5}});
  EXPECT_FALSE(none.is_low(b, {chi[a]}) || none.is_high(b, {chi[a]}));
}

}  // namespace
}  // namespace tetloft::testing
