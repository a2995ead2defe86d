// Structure sets of plastimatch.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/formats.hpp>

#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

using namespace test;

const std::string kHeader =
    "CT_SERIES_UID 1.2.3\nPATIENT_NAME A B\nSTUDY_ID\nOFFSET 0 0 0\nDIMENSION 4 4 4\nSPACING 1 1 "
    "1\n"
    "ROI_NAMES\n2|255 0 0|left lung\n5|0\\255\\0|heart | old\n7||nothing\nEND_OF_ROI_NAMES\n";

std::string square(const std::string& structure, const std::string& z) {
  return structure + "||4|0||0\\0\\" + z + "\\2\\0\\" + z + "\\2\\2\\" + z + "\\0\\2\\" + z + "\n";
}

TEST(Cxt, IsRecognisedAndCounted) {
  const auto read = inspected(kHeader + square("2", "0") + square("5", "1.5") + square("2", "3"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, "cxt");
  EXPECT_EQ(read->unit, "mm");
  EXPECT_EQ(read->warnings.size(), 0U) << warnings_of(read->warnings);
  ASSERT_EQ(read->structures.size(), 3U);
  EXPECT_EQ(read->structures[0].number, 2);
  EXPECT_EQ(read->structures[0].name, "left lung");
  EXPECT_EQ(read->structures[0].contours, 2U);
  EXPECT_EQ(read->structures[0].points, 8U);
  EXPECT_EQ(read->structures[0].planes, 2U);
  EXPECT_EQ(read->structures[1].name, "heart | old");
  EXPECT_EQ(read->structures[2].contours, 0U);
}

TEST(Cxt, ReadsAStack) {
  const auto read = parse_stack(kHeader + square("2", "3") + square("2", "0"), "a.cxt",
                                {.structure = "left lung"});
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->stack.sections.size(), 2U);
  EXPECT_EQ(read->stack.sections[SectionId(0)].z, 0);
  EXPECT_EQ(read->stack.sections[SectionId(1)].contours[ContourId(0)].vertices[2], (Point2{2, 2}));
  EXPECT_EQ(read->lines[SectionId(0)][ContourId(0)], 13U);
}

TEST(Cxt, ForgivesWhatIsHarmless) {
  const auto read = inspected(
      "\xEF\xBB\xBF"
      "ROI_NAMES\r\n1 255\\0\\0 old name\r\nEND_OF_ROI_NAMES\r\n"
      "\r\n# a comment\r\n1|||||0\\0\\0\\1\\0\\0\\1\\1\\0\\\r\n" +
      square("1", "0"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, "cxt");
  EXPECT_EQ(read->structures[0].name, "old name");
  EXPECT_EQ(read->structures[0].points, 7U);
  EXPECT_EQ(read->warnings.size(), 0U) << warnings_of(read->warnings);
}

TEST(Cxt, WarnsOfWhatIsOdd) {
  const auto read =
      inspected("ROI_NAMES\n1||a\n1||b\nEND_OF_ROI_NAMES\n1||9|||0\\0\\0\n1||2|||0\\0\\0\n" +
                square("4", "0"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->structures.size(), 3U);
  EXPECT_EQ(read->structures[0].contours, 2U);
  EXPECT_EQ(read->structures[2].number, 4);
  expect_warning(read->warnings, {"ROI 1 'b'", "number of another"});
  expect_warning(read->warnings, {"ROI 4", "not in the list"});
  expect_warning(read->warnings, {"2 contours", "another number of points"});
}

TEST(Cxt, ErrorsNameTheLine) {
  expect_error(kHeader + square("2", "0") + "2||1|||0\\0\n",
               {"a.file:13", "ROI 2, contour 1", "2 values"});
  expect_error(kHeader + "2||1|||0\\0\\q\n", {"a.file:12", "value 2", "'q'"});
  expect_error(kHeader + "2||1|0\\0\\0\n", {"a.file:12", "expected a contour"});
  expect_error(kHeader + "x||1|||0\\0\\0\n", {"a.file:12", "'x'"});
  expect_error("ROI_NAMES\nx|1|a\nEND_OF_ROI_NAMES\n", {"a.file:2", "'x'"});
  expect_error("ROI_NAMES\n1|1|a\n", {"ends before", "END_OF_ROI_NAMES"});
  expect_error("PATIENT_NAME a\n", {"ends before", "ROI_NAMES"}, "cxt");
}

}  // namespace
}  // namespace tetloft
