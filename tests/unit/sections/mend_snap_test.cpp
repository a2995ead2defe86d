// mend() and snap().
#include <gtest/gtest.h>

#include <cmath>

#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

const std::vector<Point2>& vertices(const SectionStack& stack) {
  return stack.sections[SectionId(0)].contours[ContourId(0)].vertices;
}

TEST(Mend, LeavesValidStacksAlone) {
  SectionStack square = one({rectangle(0, 0, 1, 1)});
  EXPECT_TRUE(mend(square).empty());
  EXPECT_EQ(vertices(square), rectangle(0, 0, 1, 1).vertices);
}

TEST(Mend, RemovesTheRepeatedFirstVertex) {
  SectionStack closed = one({contour({{0, 0}, {1, 0}, {1, 1}, {0, 0}})});
  const std::vector<Warning> warnings = mend(closed);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].message, "first vertex repeated at the end removed");
  EXPECT_EQ(warnings[0].where.section, 0U);
  EXPECT_EQ(warnings[0].where.contour, 0U);
  EXPECT_EQ(vertices(closed), contour({{0, 0}, {1, 0}, {1, 1}}).vertices);
}

TEST(Mend, RemovesConsecutiveDuplicates) {
  SectionStack twice = one({contour({{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {1, 1}, {0, 0}})});
  const std::vector<Warning> warnings = mend(twice);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].message,
            "first vertex repeated at the end and 3 consecutive duplicate vertices removed");
  EXPECT_EQ(vertices(twice), contour({{0, 0}, {1, 0}, {1, 1}}).vertices);
}

TEST(Mend, LeavesWhatIsTooSmallForValidateToName) {
  SectionStack tiny = one({contour({{1, 1}, {1, 1}, {1, 1}}), contour({})});
  EXPECT_EQ(mend(tiny).size(), 1U);
  EXPECT_EQ(vertices(tiny).size(), 1U);
  EXPECT_EQ(tiny.contour_count(), 2U);
  EXPECT_FALSE(validate(tiny).ok());
}

TEST(Snap, RoundsToTheLatticeAsked) {
  const SectionStack stack = one({contour({{0.1, 0.2}, {9.7, 0.3}, {5.5, 8.1}})});
  const Result<Snapped> snapped = snap(stack, 8);
  ASSERT_TRUE(snapped.ok());
  EXPECT_EQ(snapped->bits, 8);
  EXPECT_EQ(snapped->lattice, 16.0 / 256);
  EXPECT_EQ(vertices(snapped->stack),
            contour({{0.125, 0.1875}, {9.6875, 0.3125}, {5.5, 8.125}}).vertices);
  ASSERT_EQ(snapped->moved.size(), 3U);
  EXPECT_EQ(snapped->moved[2].from, (Point2{5.5, 8.1}));
  EXPECT_EQ(snapped->moved[2].to, (Point2{5.5, 8.125}));
}

TEST(Snap, LeavesWhatIsOnTheLattice) {
  const SectionStack stack = one({rectangle(-8, -8, 8, 5)});
  const Result<Snapped> snapped = snap(stack, 4);
  ASSERT_TRUE(snapped.ok());
  EXPECT_EQ(snapped->lattice, 0.5);
  EXPECT_TRUE(snapped->moved.empty());
  EXPECT_EQ(vertices(snapped->stack), vertices(stack));
}

TEST(Snap, TakesAFinerLatticeWhereContoursWouldTouch) {
  const SectionStack stack = one({rectangle(0, 0, 4, 16), rectangle(4.01, 0, 8, 16)});
  const Result<Snapped> snapped = snap(stack, 3);
  ASSERT_TRUE(snapped.ok());
  EXPECT_TRUE(validate(snapped->stack).ok());
  EXPECT_GT(snapped->bits, 3);
  EXPECT_EQ(snapped->bits, 10);  // 0.01 rounds to 1/64 of … 16 / 2^10, not to 16 / 2^9
}

TEST(Snap, TakesAFinerLatticeWhereAContourWouldMoveIntoAnother) {
  // On integers the small triangle becomes a larger one around nothing; nesting must stay.
  const SectionStack stack = one({rectangle(0, 0, 63.4, 64), rectangle(63.45, 1, 63.9, 2)});
  const Result<Snapped> snapped = snap(stack, 6);
  ASSERT_TRUE(snapped.ok());
  EXPECT_EQ(nest(snapped->stack.sections[SectionId(0)]).parent,
            nest(stack.sections[SectionId(0)]).parent);
}

TEST(Snap, RemovesVerticesThatFallOnTheirPredecessor) {
  const SectionStack stack =
      one({contour({{0, 0}, {8, 0}, {8, 0.1}, {8, 8}, {0, 8}, {0, 0.1}, {0.1, 0.05}})});
  ASSERT_TRUE(validate(stack).ok());
  const Result<Snapped> snapped = snap(stack, 3);
  ASSERT_TRUE(snapped.ok());
  EXPECT_EQ(snapped->bits, 3);
  EXPECT_EQ(vertices(snapped->stack), rectangle(0, 0, 8, 8).vertices);
  ASSERT_EQ(snapped->moved.size(), 3U);
  EXPECT_EQ(snapped->moved[0].vertex, 2U);
  EXPECT_EQ(snapped->moved[0].to, (Point2{8, 0}));
  EXPECT_EQ(snapped->moved[1].vertex, 5U);
  EXPECT_EQ(snapped->moved[2].vertex, 6U);
  EXPECT_EQ(snapped->moved[2].to, (Point2{0, 0}));
}

TEST(Snap, RefusesWhatItCannotDo) {
  const SectionStack square = one({rectangle(0, 0, 1, 1)});
  EXPECT_EQ(snap(square, 0).error().code, ErrorCode::usage);
  EXPECT_EQ(snap(square, 51).error().code, ErrorCode::usage);
  const SectionStack invalid = one({contour({{0, 0}, {1, 0}})});
  EXPECT_EQ(snap(invalid, 20).error().code, ErrorCode::invalid_input);
  // A triangle far smaller than any lattice of the large one.
  const SectionStack uneven =
      one({rectangle(0, 0, 1, 1), contour({{2, 0}, {2 + 0x1p-51, 0}, {2, 0x1p-60}})});
  ASSERT_TRUE(validate(uneven).ok());
  EXPECT_EQ(snap(uneven, 20).error().code, ErrorCode::invalid_input);
}

TEST(Snap, TakesEmptySectionsAndExtremeScales) {
  EXPECT_TRUE(snap(stack({section(0, {}), section(1, {rectangle(0, 0, 3, 5)})}), 20).ok());
  for (const double factor : {0x1p-1060, 0x1p-500, 0x1p900}) {
    const SectionStack small = one({moved(rectangle(0, 0, 3, 5), factor, {0, 0})});
    const Result<Snapped> snapped = snap(small, 24);
    ASSERT_TRUE(snapped.ok());
    EXPECT_TRUE(snapped->moved.empty());
    EXPECT_GT(snapped->lattice, 0);
  }
}

TEST(Snap, KeepsGeneratedStacksValidAndNestedAndOnTheLattice) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 7).stack;
    const Result<Snapped> snapped = snap(stack, 12);
    if (!snapped) continue;
    ASSERT_TRUE(validate(snapped->stack).ok()) << name_of(kind);
    for (std::size_t s = 0; s < stack.sections.size(); ++s) {
      const SectionId id(s);
      ASSERT_EQ(nest(snapped->stack.sections[id]).parent, nest(stack.sections[id]).parent);
      for (const Contour& c : snapped->stack.sections[id].contours) {
        for (const Point2& p : c.vertices) {
          ASSERT_EQ(std::fmod(p.x, snapped->lattice), 0);
          ASSERT_EQ(std::fmod(p.y, snapped->lattice), 0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
