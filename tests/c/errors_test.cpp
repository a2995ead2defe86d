// What is told of failures, and names.
#include <gtest/gtest.h>

#include <cstring>
#include <thread>

#include <tetloft/tetloft.hpp>

#include "c/owned.hpp"
#include "c/sample_files.hpp"

namespace tetloft::c_test {
namespace {

TEST(ErrorsOfC, HaveTheTextAndPlaceOfCpp) {
  const std::string text = "S 2\nv 4 z 0\n{\n0 0\n4 4\n4 0\n0 4\n}\nv 3 z 1\n{\n0 0\n4 0\n4 4\n}\n";
  const Error expected = parse_stack(text, "some.cnt").error();
  Owned<tetloft_stack> stack;
  EXPECT_EQ(static_cast<int>(tetloft_stack_parse(text.data(), text.size(), "some.cnt", nullptr,
                                                 stack.out(), nullptr)),
            static_cast<int>(expected.code));
  EXPECT_EQ(tetloft_last_error(), to_string(expected));
  EXPECT_EQ(tetloft_last_message(), expected.message);
  tetloft_place place;
  place.version = TETLOFT_PLACE_VERSION;
  ASSERT_OK(tetloft_last_place(&place));
  const auto number = [](const std::optional<std::size_t>& value) {
    return value ? static_cast<std::int64_t>(*value) : -1;
  };
  ASSERT_FALSE(expected.where.file.empty());
  EXPECT_EQ(place.file, expected.where.file);
  EXPECT_EQ(place.line, number(expected.where.line));
  EXPECT_EQ(place.section, number(expected.where.section));
  EXPECT_EQ(place.slab, number(expected.where.slab));
  EXPECT_EQ(place.contour, number(expected.where.contour));
  EXPECT_EQ(place.vertex, number(expected.where.vertex));
  EXPECT_GE(place.section, 0);
  ASSERT_EQ(place.has_point != 0, expected.where.point.has_value());
  if (expected.where.point) {
    EXPECT_EQ(place.point[0], expected.where.point->x);
    EXPECT_EQ(place.point[1], expected.where.point->y);
    EXPECT_EQ(place.point[2], expected.where.point->z);
  }
}

TEST(ErrorsOfC, StayWhereTheirPlaceIsAskedForWrongly) {
  EXPECT_EQ(tetloft_stack_counts(nullptr, nullptr, nullptr, nullptr), TETLOFT_BAD_HANDLE);
  const std::string before = tetloft_last_error();
  tetloft_place place = {};
  EXPECT_EQ(tetloft_last_place(&place), TETLOFT_USAGE);
  EXPECT_EQ(tetloft_last_place(nullptr), TETLOFT_USAGE);
  EXPECT_EQ(tetloft_last_error(), before);
  place = {TETLOFT_PLACE_VERSION, nullptr, 0, 0, 0, 0, 0, 0, {0, 0, 0}};
  EXPECT_EQ(tetloft_last_place(&place), TETLOFT_OK);
  EXPECT_EQ(place.section, -1);
}

TEST(ErrorsOfC, NamePointsThatATetLacks) {
  const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint32_t tet[] = {0, 1, 2, 9};
  Owned<tetloft_model> model;
  ASSERT_OK(tetloft_model_create(xyz, 3, tet, 1, model.out()));
  double volume = 1;
  EXPECT_EQ(tetloft_model_volume(model, &volume), TETLOFT_INVALID_INPUT);
  EXPECT_EQ(volume, 0);
  EXPECT_NE(std::string(tetloft_last_error()).find("vertex 9"), std::string::npos);
}

TEST(ErrorsOfC, BelongToTheirThread) {
  EXPECT_EQ(tetloft_stack_counts(nullptr, nullptr, nullptr, nullptr), TETLOFT_BAD_HANDLE);
  const std::string mine = tetloft_last_error();
  EXPECT_NE(mine, "");
  std::thread([] {
    EXPECT_STREQ(tetloft_last_error(), "");
    EXPECT_STREQ(tetloft_last_message(), "");
    tetloft_place place;
    place.version = TETLOFT_PLACE_VERSION;
    EXPECT_EQ(tetloft_last_place(&place), TETLOFT_OK);
    EXPECT_EQ(place.file, nullptr);
    EXPECT_EQ(place.line, -1);
    EXPECT_EQ(place.vertex, -1);
    EXPECT_EQ(place.has_point, 0);
    EXPECT_EQ(tetloft_execution_defaults(nullptr), TETLOFT_USAGE);
    EXPECT_STRNE(tetloft_last_error(), "");
  }).join();
  EXPECT_EQ(tetloft_last_error(), mine);
}

TEST(ErrorsOfC, ThatAreTooLongAreCutAfterAWholeCharacter) {
  for (const std::size_t before : {0U, 1U}) {
    std::string path(before, 'x');
    while (path.size() < 6000) path += "\xc3\xa4";  // ä
    Owned<tetloft_stack> stack;
    ASSERT_NE(tetloft_stack_read(path.c_str(), nullptr, stack.out(), nullptr), TETLOFT_OK);
    const std::string told = tetloft_last_error();
    EXPECT_GE(told.size(), 4094U);
    EXPECT_LE(told.size(), 4095U);
    EXPECT_EQ(told, path.substr(0, told.size()));
    EXPECT_EQ(told.size() % 2, before);
  }
}

TEST(NamesOfC, AreThoseOfCpp) {
  EXPECT_STREQ(tetloft_version(), version());
  for (const int status : {TETLOFT_USAGE, TETLOFT_INVALID_INPUT, TETLOFT_IO,
                           TETLOFT_UNREPRESENTABLE, TETLOFT_CANCELLED, TETLOFT_WORK_LIMIT,
                           TETLOFT_INTERNAL, TETLOFT_OUT_OF_MEMORY, TETLOFT_UNFIT_ARITHMETIC}) {
    EXPECT_STREQ(tetloft_status_name(status), name_of(static_cast<ErrorCode>(status)));
  }
  EXPECT_STREQ(tetloft_status_name(TETLOFT_OK), "ok");
  EXPECT_STREQ(tetloft_status_name(TETLOFT_BAD_HANDLE), "bad_handle");
  EXPECT_STREQ(tetloft_status_name(TETLOFT_TOO_SMALL), "too_small");
  for (const int none : {-1, 1, 10, 69, 73, 1000}) {
    EXPECT_STREQ(tetloft_status_name(none), "unknown");
    EXPECT_STREQ(tetloft_tet_kind_name(none == 1 ? kTetKinds : none), "unknown");
  }
  for (int k = 0; k < kTetKinds; ++k) {
    EXPECT_STREQ(tetloft_tet_kind_name(k), name_of(static_cast<TetKind>(k)));
  }
  for (int k = 0; k < kPointOrigins; ++k) {
    EXPECT_STREQ(tetloft_point_origin_name(k), name_of(static_cast<PointOrigin>(k)));
  }
  for (int k = 0; k < kEvidences; ++k) {
    EXPECT_STREQ(tetloft_evidence_name(k), name_of(static_cast<Evidence>(k)));
  }
  for (int k = 0; k < kLinkFates; ++k) {
    EXPECT_STREQ(tetloft_fate_name(k), name_of(static_cast<LinkFate>(k)));
  }
  EXPECT_STREQ(tetloft_point_origin_name(kPointOrigins), "unknown");
  EXPECT_STREQ(tetloft_evidence_name(kEvidences), "unknown");
  EXPECT_STREQ(tetloft_fate_name(kLinkFates), "unknown");
}

TEST(NamesOfC, FormatsAreThoseOfCpp) {
  ASSERT_EQ(tetloft_format_count(), formats().size());
  for (std::size_t i = 0; i < formats().size(); ++i) {
    const FormatInfo& expected = formats()[i];
    tetloft_format format;
    format.version = TETLOFT_FORMAT_VERSION;
    ASSERT_OK(tetloft_format_info(i, &format));
    EXPECT_EQ(format.name, expected.name);
    EXPECT_EQ(format.summary, expected.summary);
    EXPECT_EQ(format.extension, expected.extensions.front());
    for (int k = 0; k < kContents; ++k) {
      EXPECT_EQ((format.reads >> k & 1U) != 0, expected.reads.has(static_cast<Contents>(k)));
      EXPECT_EQ((format.writes >> k & 1U) != 0, expected.writes.has(static_cast<Contents>(k)));
    }
  }
  tetloft_format format;
  format.version = TETLOFT_FORMAT_VERSION;
  EXPECT_EQ(tetloft_format_info(formats().size(), &format), TETLOFT_USAGE);
  EXPECT_EQ(format.name, nullptr);
}

}  // namespace
}  // namespace tetloft::c_test
