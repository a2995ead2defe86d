// IMOD models as text.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/formats.hpp>

#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

using namespace test;

std::string square(const std::string& z, const std::string& behind = "") {
  const std::string end = ' ' + z + behind + '\n';
  return "contour 0 0 4\n0 0" + end + "2 0" + end + "2 2" + end + "0 2" + end;
}

const std::string kModel =
    "# imod ascii file version 2.0\n\nimod 3\nmax 100 100 50\noffsets 0 0 0\nangles 0 0 0\n"
    "scale 1 1 2.5\npixsize 0.5\nunits um\n\nobject 0 2 1\nname outer membrane #2\n"
    "color 0 1 0 0\nlinewidth 1\n" +
    square("0") + square("4", " 3 1") +
    "contflags 0\nmesh 0 2 3\n0 0 0\n1 1 1\n-25\n0\n-22\nMeshflags 65536\nobject 1 1 "
    "0\nname\nopen\n" +
    square("1") + "object 2 1 0\nopen\nscattered\ncontour 0 0 1\n1 2 3\n# end of IMOD model\n";

TEST(ImodText, IsRecognisedAndCounted) {
  const auto read = inspected(kModel);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, "imod");
  EXPECT_EQ(read->unit, "um");
  EXPECT_EQ(read->warnings.size(), 0U) << warnings_of(read->warnings);
  expect_three_objects(*read, "outer membrane #2");
  EXPECT_EQ(read->structures[1].name, "");
}

TEST(ImodText, CoordinatesAreScaled) {
  const auto read = parse_stack(kModel, "a.mod");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.sections[SectionId(1)].z, 0.5 * 2.5 * 4);
  EXPECT_EQ(read->stack.sections[SectionId(1)].contours[ContourId(0)].vertices[2], (Point2{1, 1}));
  // The words may stand behind, too.
  const auto again =
      parse_stack("imod 1\nobject 0 2 0\n" + square("0") + square("1") + "pixsize 4\n", "a.mod");
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(again->stack.sections[SectionId(1)].z, 4);
}

TEST(ImodText, SingleContoursMayBeOpen) {
  const auto read = inspected("\xEF\xBB\xBFimod 1\r\nobject 0 2 0\r\n" + square("0") +
                              "contflags 8\r\nconttime 2\r\n" + square("1"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->lines->open, 1U);
  EXPECT_EQ(read->lines->closed, 1U);
  EXPECT_EQ(read->unit, "pixel");
}

TEST(ImodText, ErrorsNameTheLine) {
  expect_error("imod 1\ncontour 0 0 1\n", {"a.file:2", "before any object"});
  expect_error("imod 1\nobject 0 1 0\ncontour 0 0\n", {"a.file:3", "number of points"});
  expect_error("imod 1\nobject 0 1 0\ncontour 0 0 -1\n", {"a.file:3", "'-1'"});
  expect_error("imod 1\nobject 0 1 0\ncontour 0 0 2\n0 0 0\n",
               {"ends", "1 more points", "object 1"});
  expect_error("imod 1\nobject 0 1 0\ncontour 0 0 2\n0 0 0\nobject 1 0 0\n",
               {"a.file:5", "'object'", "1 more points"});
  expect_error("imod 1\nobject 0 1 0\ncontour 0 0 1\n0 0\n", {"a.file:4", "''"});
  expect_error("imod 1\nobject 0 1 0\ncontour 0 0 1\n0 0 1e999\n", {"a.file:4", "finite"});
  expect_error("imod 1\nobject 0 1 0\n1 2 3\n", {"a.file:3", "belong to nothing"});
  expect_error("imod 1\npixsize x\n", {"a.file:2", "'x'"});
  expect_error("imod 1\nobject 0 1 0\ncontour 0 0 0\ncontflags x\n", {"a.file:4", "'x'"});
  expect_error("imod 1\npixsize 1e300\nobject 0 1 0\ncontour 0 0 1\n1e300 0 0\n",
               {"a.file:4", "not finite"});
  const auto read = inspected("imod 1\npixsize -1\n");
  ASSERT_TRUE(read.ok());
  expect_warning(read->warnings, {"pixsize", "1 is taken"});
}

}  // namespace
}  // namespace tetloft
