// What a plan says of the whole stack, where nobody but an attacker wrote it.
#include "pieces/plan_head.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace tetloft::testing {

using namespace internal::pieces;
namespace {

PlanHead some_head() {
  PlanHead head;
  head.facts.sections = 3;
  return head;
}

TEST(PlanHead, ReadsBack) {
  const std::string bytes = to_record(some_head());
  const auto head = plan_head_from_record(bytes, "name");
  ASSERT_TRUE(head.ok()) << to_string(head.error());
  EXPECT_EQ(to_record(*head), bytes);
}

// Whose negative is no int, or by which no double is multiplied.
TEST(PlanHead, OfAUnitThatNoStackHasIsRefused) {
  using Limits = std::numeric_limits<std::int32_t>;
  for (const int exponent : {-2098, 2098}) {
    PlanHead head = some_head();
    head.facts.exponent = exponent;
    EXPECT_TRUE(plan_head_from_record(to_record(head), "name").ok()) << exponent;
  }
  for (const int exponent : {Limits::min(), -2099, 2099, Limits::max()}) {
    PlanHead head = some_head();
    head.facts.exponent = exponent;
    const auto read = plan_head_from_record(to_record(head), "name");
    ASSERT_FALSE(read.ok()) << exponent;
    EXPECT_EQ(read.error().code, ErrorCode::invalid_input);
  }
}

TEST(PlanHead, ThatCountsComponentsOtherwiseThanItNamesThemIsRefused) {
  PlanHead head = some_head();
  head.contours = head.facts.components = 2;
  EXPECT_TRUE(plan_head_from_record(to_record(head), "name").ok());
  head.component_names.raw() = {"a", "b"};
  EXPECT_TRUE(plan_head_from_record(to_record(head), "name").ok());
  for (const std::size_t components : {std::size_t{1}, std::size_t{3}}) {
    head.facts.components = components;
    EXPECT_FALSE(plan_head_from_record(to_record(head), "name").ok()) << components;
  }
  head.component_names.clear();  // more than contours
  EXPECT_FALSE(plan_head_from_record(to_record(head), "name").ok());
}

}  // namespace
}  // namespace tetloft::testing
