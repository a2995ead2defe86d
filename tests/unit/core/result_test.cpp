// Results, and the texts of places, errors and warnings.
#include <tetloft/result.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/guard.hpp"

namespace tetloft {

using namespace internal;
namespace {

TEST(Result, HoldsAValue) {
  const Result<int> result(7);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(static_cast<bool>(result));
  EXPECT_EQ(result.value(), 7);
  EXPECT_EQ(*result, 7);
}

TEST(Result, HoldsAnError) {
  const Result<int> result(Error{ErrorCode::io, "gone", {}});
  ASSERT_FALSE(result.ok());
  EXPECT_FALSE(static_cast<bool>(result));
  EXPECT_EQ(result.error().code, ErrorCode::io);
  EXPECT_EQ(result.error().message, "gone");
}

TEST(Result, GivesAwayWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(3));
  EXPECT_EQ(**result, 3);
  const std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 3);
}

TEST(Result, OfNothingIsSuccessByDefault) {
  EXPECT_TRUE(Result<void>().ok());
  const Result<void> failed(Error{ErrorCode::usage, "no", {}});
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().message, "no");
}

TEST(ErrorCode, NamesAreThoseOfTheReports) {
  EXPECT_STREQ(name_of(ErrorCode::usage), "usage");
  EXPECT_STREQ(name_of(ErrorCode::invalid_input), "invalid_input");
  EXPECT_STREQ(name_of(ErrorCode::io), "io");
  EXPECT_STREQ(name_of(ErrorCode::unrepresentable), "unrepresentable");
  EXPECT_STREQ(name_of(ErrorCode::work_limit), "work_limit");
  EXPECT_STREQ(name_of(ErrorCode::internal), "internal");
}

TEST(Place, TextHasTheDocumentedForm) {
  Place place;
  EXPECT_EQ(to_string(place), "");
  place.file = "file.cnt";
  EXPECT_EQ(to_string(place), "file.cnt:");
  place.line = 12;
  place.section = 3;
  place.contour = 0;
  place.vertex = 7;
  place.point = Point3{1.5, 2, 30};
  EXPECT_EQ(to_string(place), "file.cnt:12: section 3, contour 0, vertex 7 (1.5, 2, 30)");
}

TEST(Place, TextOfPartsAlone) {
  Place slab;
  slab.slab = 4;
  EXPECT_EQ(to_string(slab), "slab 4");
  Place line;
  line.line = 9;
  EXPECT_EQ(to_string(line), "line 9:");
  Place point;
  point.point = Point3{0.1, 0, -1};
  EXPECT_EQ(to_string(point), "(0.10000000000000001, 0, -1)");
}

TEST(Error, TextIsPlaceThenMessage) {
  Error error{ErrorCode::invalid_input, "crossed", {}};
  EXPECT_EQ(to_string(error), "crossed");
  error.where.section = 1;
  EXPECT_EQ(to_string(error), "section 1: crossed");
  Place place;
  place.file = std::string("a");
  place.line = 2;
  EXPECT_EQ(to_string(Error{ErrorCode::io, "gone", place}), "a:2: gone");
}

TEST(Warning, TextIsPlaceThenMessage) {
  Warning warning{"mended", {}};
  warning.where.contour = 5;
  EXPECT_EQ(to_string(warning), "contour 5: mended");
}

TEST(Check, FailureNamesConditionAndFileWithoutFolders) {
  const Result<int> result = guard_internal([]() -> Result<int> {
    TETLOFT_CHECK(1 + 1 == 3);
    return 1;
  });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::internal);
  EXPECT_NE(result.error().message.find("1 + 1 == 3 (result_test.cpp:"), std::string::npos)
      << result.error().message;
}

TEST(GuardInternal, TurnsWhatIsThrownIntoErrors) {
  const Result<void> memory = guard_internal([]() -> Result<void> { throw std::bad_alloc(); });
  ASSERT_FALSE(memory.ok());
  EXPECT_EQ(memory.error().message, "out of memory");
  const Result<int> other =
      guard_internal([]() -> Result<int> { throw std::runtime_error("odd"); });
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(other.error().code, ErrorCode::internal);
  EXPECT_EQ(other.error().message, "odd");
}

TEST(GuardInternal, PassesResultsThrough) {
  EXPECT_EQ(*guard_internal([]() -> Result<int> { return 5; }), 5);
  const Result<int> error = guard_internal([]() -> Result<int> {
    return Error{ErrorCode::usage, "u", {}};
  });
  EXPECT_EQ(error.error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace tetloft
