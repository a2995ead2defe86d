// IMOD models.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include <tetloft/formats.hpp>

#include "support/imod_writer.hpp"
#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

using namespace test;

const std::string kEnd = "IEOF";
constexpr unsigned kOpen = 1U << 3;
constexpr unsigned kScattered = 1U << 9;

// An object of closed contours, one of open ones, one of scattered points.
std::string three_objects() {
  return imod_header({.objects = 3, .z_scale = 2.5, .pixel = 0.5}) + imod_object("membrane", 2) +
         imod_contour(imod_square(0)) + imod_contour(imod_square(4)) + imod_mesh(3, 5) +
         imod_piece("IMAT", std::string(16, '\1')) + imod_object("fibre", 1, kOpen) +
         imod_contour(imod_square(1)) + imod_piece("XYZW", "anything") +
         imod_object("", 1, kScattered | kOpen) + imod_contour({{1, 2, 3}}) +
         imod_piece("MINX", std::string(72, '\7')) + kEnd;
}

TEST(Imod, IsRecognisedAndCounted) {
  const auto read = inspected(three_objects() + "what stands behind the end");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, "imod");
  EXPECT_EQ(read->unit, "nm");
  EXPECT_EQ(read->warnings.size(), 0U) << warnings_of(read->warnings);
  expect_three_objects(*read, "membrane");
}

// The one object that has closed contours is read without being asked for.
TEST(Imod, CoordinatesAreScaled) {
  const auto read = parse_stack(three_objects(), "a.mod");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.about.name, "membrane");
  EXPECT_EQ(read->stack.about.unit, "nm");
  ASSERT_EQ(read->stack.sections.size(), 2U);
  EXPECT_EQ(read->stack.sections[SectionId(1)].z, 0.5 * 2.5 * 4);
  EXPECT_EQ(read->stack.sections[SectionId(1)].contours[ContourId(0)].vertices[2], (Point2{1, 1}));
}

TEST(Imod, UnitsAreNamed) {
  const std::pair<int, const char*> units[] = {{0, "pixel"}, {1, "m"},          {3, "km"},
                                               {-2, "cm"},   {-3, "mm"},        {-6, "um"},
                                               {-9, "nm"},   {-10, "angstrom"}, {-12, "pm"}};
  for (const auto& [code, unit] : units) {
    const auto read = inspected(imod_header({.objects = 0, .unit = code}) + kEnd);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->unit, unit);
  }
  const auto read =
      inspected(imod_header({.objects = 0, .z_scale = 0, .pixel = -2, .unit = 99}) + kEnd);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->unit, "");
  expect_warning(read->warnings, {"unit", "not known"});
  expect_warning(read->warnings, {"pixel size is -2", "1 is taken"});
  expect_warning(read->warnings, {"z scale is 0", "1 is taken"});
}

TEST(Imod, SingleContoursMayBeOpen) {
  const auto read =
      parse_stack(imod_header({}) + imod_object("", 3) + imod_contour(imod_square(0)) +
                      imod_contour(imod_square(1), kOpen) + imod_contour(imod_square(2)) + kEnd,
                  "a.file");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.contour_count(), 2U);
  expect_warning(read->warnings, {"left out", "open"});
}

TEST(Imod, OddFilesAreWarnedOf) {
  const auto read =
      inspected(imod_header({.objects = 2}) + imod_object("a", 3) +
                imod_contour(imod_square(0), 0, 1) + imod_contour(imod_square(1), 0, 2));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->structures[0].contours, 2U);
  expect_warning(read->warnings, {"IEOF"});
  expect_warning(read->warnings, {"2 objects, the file has 1"});
  expect_warning(read->warnings, {"object 1 'a'", "3 contours and has 2"});
  expect_warning(read->warnings, {"several times"});
}

TEST(Imod, ErrorsNameTheByte) {
  const std::string object = imod_header({}) + imod_object("a", 1);
  const std::string at = "byte " + std::to_string(object.size());
  expect_error("IMODV1.1" + std::string(300, '\0'), {"'IMODV1.1'", "version 1.2"});
  expect_error(object.substr(0, 100), {"byte 100", "header"});
  expect_error(object.substr(0, 300), {"byte 240", "object"});
  expect_error(imod_header({}) + imod_contour({{0, 0, 0}}), {"byte 240", "before any object"});
  const std::string contour = imod_contour(imod_square(0));
  expect_error(object + contour.substr(0, 10), {at, "header of a contour"});
  expect_error(object + contour.substr(0, 50), {at, "object 1, contour 1", "4 points"});
  std::string huge = contour;
  huge.replace(4, 4, "\x7F\xFF\xFF\xFF");
  expect_error(object + huge, {at, "2147483647 points"});
  huge.replace(4, 4, "\xFF\xFF\xFF\xFF");
  expect_error(object + huge, {at, "-1 points"});
  expect_error(object + imod_contour({{0, std::numeric_limits<double>::infinity(), 0}}),
               {"contour 1", "point 1 is not finite"});
  expect_error(object + imod_mesh(2, 2).substr(0, 40), {at, "mesh of 2 vertices"});
  expect_error(object + imod_piece("VIEW", "12345678").substr(0, 10), {at, "'VIEW'", "8 bytes"});
  expect_error(object + "VI", {at, "name of a piece"});
  expect_error(object + "VIEW" + imod_integer(-5), {at, "'VIEW'"});
}

TEST(Imod, EveryCutIsAnErrorOrAWarning) {
  const std::string bytes = three_objects();
  for (std::size_t size = 0; size + 1 < bytes.size(); ++size) {
    const auto read = inspected(bytes.substr(0, size), "imod");
    EXPECT_TRUE(!read.ok() || !read->warnings.empty()) << size;
  }
}

}  // namespace
}  // namespace tetloft
