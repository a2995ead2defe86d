// The faces of two sections laid over each other, on cases small enough to count by eye; and
// complements of sections.
#include "sections/face_overlay.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/sections.hpp>

#include "sections/complement.hpp"
#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

using namespace internal::sections;

FaceOverlay overlay_of(const Section& lower, const Section& upper) {
  return FaceOverlay(lower, nest(lower), upper, nest(upper));
}

FaceOverlay overlay(const std::vector<Contour>& lower, const std::vector<Contour>& upper) {
  return overlay_of(section(0, lower), section(1, upper));
}

std::string text(const FaceSide& side) {
  return (side.solid ? "S" : "V") + std::to_string(side.id.value());
}

// "V0 S0 chi 1 by 0.0 1.0": sides, Euler characteristic, section and region of the border.
std::vector<std::string> texts(const FaceOverlay& overlay) {
  std::vector<std::string> result;
  for (const OverlayFace& face : overlay.faces()) {
    std::string line =
        text(face.lower) + " " + text(face.upper) + " chi " + std::to_string(face.chi) + " by";
    for (const BorderRegion& region : face.border) {
      line += std::string(region.upper ? " 1." : " 0.") + std::to_string(region.region.value());
    }
    result.push_back(line);
  }
  return result;
}

using Lines = std::vector<std::string>;

TEST(FaceOverlay, OfEmptySectionsIsThePlane) {
  EXPECT_EQ(texts(overlay({}, {})), (Lines{"V0 V0 chi 1 by"}));
}

TEST(FaceOverlay, OfOneEmptySectionHasTheOthersFaces) {
  const Contour outer = rectangle(0, 0, 9, 9);
  const Contour hole = rectangle(1, 1, 8, 8);
  const Contour island = rectangle(2, 2, 3, 3);
  EXPECT_EQ(texts(overlay({outer, hole, island}, {})),
            (Lines{"V0 V0 chi 0 by 0.0", "V1 V0 chi 0 by 0.0 0.1", "S0 V0 chi 0 by 0.0",
                   "S1 V0 chi 1 by 0.1"}));
  EXPECT_EQ(texts(overlay({}, {outer, hole, island})),
            (Lines{"V0 V0 chi 0 by 1.0", "V0 V1 chi 0 by 1.0 1.1", "V0 S0 chi 0 by 1.0",
                   "V0 S1 chi 1 by 1.1"}));
}

TEST(FaceOverlay, OfDisjointSquaresLeavesTwoHolesOutside) {
  EXPECT_EQ(texts(overlay({rectangle(0, 0, 1, 1)}, {rectangle(2, 0, 3, 1)})),
            (Lines{"V0 V0 chi -1 by 0.0 1.0", "V0 S0 chi 1 by 1.0", "S0 V0 chi 1 by 0.0"}));
}

TEST(FaceOverlay, OfEqualSquaresHasTwoFacesOnBothContours) {
  const Contour square = rectangle(0, 0, 1, 1);
  EXPECT_EQ(texts(overlay({square}, {reversed(rotated(square, 1))})),
            (Lines{"V0 V0 chi 0 by 0.0 1.0", "S0 S0 chi 1 by 0.0 1.0"}));
}

TEST(FaceOverlay, OfNestedSquaresHasARing) {
  EXPECT_EQ(texts(overlay({rectangle(0, 0, 9, 9)}, {rectangle(3, 3, 6, 6)})),
            (Lines{"V0 V0 chi 0 by 0.0", "S0 V0 chi 0 by 0.0 1.0", "S0 S0 chi 1 by 1.0"}));
}

TEST(FaceOverlay, OfCrossingBarsHasFourArms) {
  EXPECT_EQ(texts(overlay({rectangle(0, 3, 9, 6)}, {rectangle(3, 0, 6, 9)})),
            (Lines{"V0 V0 chi 0 by 0.0 1.0", "V0 S0 chi 1 by 0.0 1.0", "V0 S0 chi 1 by 0.0 1.0",
                   "S0 V0 chi 1 by 0.0 1.0", "S0 V0 chi 1 by 0.0 1.0", "S0 S0 chi 1 by 0.0 1.0"}));
}

TEST(FaceOverlay, OfBarsAskewHasAFaceWithoutVertex) {
  // The face in the middle has crossings for corners only.
  const Contour up = contour({{0, 1}, {1, 0}, {9, 8}, {8, 9}});
  const Contour down = contour({{0, 8}, {8, 0}, {9, 1}, {1, 9}});
  EXPECT_EQ(texts(overlay({up}, {down})),
            (Lines{"V0 V0 chi 0 by 0.0 1.0", "V0 S0 chi 1 by 0.0 1.0", "V0 S0 chi 1 by 0.0 1.0",
                   "S0 V0 chi 1 by 0.0 1.0", "S0 V0 chi 1 by 0.0 1.0", "S0 S0 chi 1 by 0.0 1.0"}));
}

TEST(FaceOverlay, OfSquaresWithPartOfAnEdgeInCommon) {
  EXPECT_EQ(texts(overlay({rectangle(0, 0, 2, 2)}, {rectangle(2, 1, 4, 3)})),
            (Lines{"V0 V0 chi 0 by 0.0 1.0", "V0 S0 chi 1 by 0.0 1.0", "S0 V0 chi 1 by 0.0 1.0"}));
  EXPECT_EQ(texts(overlay({rectangle(0, 0, 4, 4)}, {rectangle(1, 0, 2, 2)})),
            (Lines{"V0 V0 chi 0 by 0.0 1.0", "S0 V0 chi 1 by 0.0 1.0", "S0 S0 chi 1 by 0.0 1.0"}));
}

TEST(FaceOverlay, OfSquaresWithACommonVertexHasOneHoleOutside) {
  EXPECT_EQ(texts(overlay({rectangle(0, 0, 2, 2)}, {rectangle(2, 2, 4, 4)})),
            (Lines{"V0 V0 chi 0 by 0.0 1.0", "V0 S0 chi 1 by 1.0", "S0 V0 chi 1 by 0.0"}));
}

TEST(FaceOverlay, OfAHoleThatTouchesTheBorderIsNone) {
  // From inside, at a vertex of the one on an edge of the other, and at vertices of both.
  const Contour square = rectangle(0, 0, 4, 4);
  for (const Contour& inner :
       {contour({{0, 2}, {2, 1}, {2, 3}}), contour({{0, 0}, {3, 1}, {1, 3}})}) {
    EXPECT_EQ(texts(overlay({square}, {inner})),
              (Lines{"V0 V0 chi 0 by 0.0", "S0 V0 chi 1 by 0.0 1.0", "S0 S0 chi 1 by 1.0"}));
  }
}

TEST(FaceOverlay, OfTwoHolesThatTouchEachOtherIsOneCycle) {
  const std::vector<Contour> plate = {rectangle(0, 0, 9, 9), rectangle(2, 2, 4, 4)};
  EXPECT_EQ(texts(overlay(plate, {rectangle(4, 4, 6, 6)})),
            (Lines{"V0 V0 chi 0 by 0.0", "V1 V0 chi 1 by 0.0", "S0 V0 chi 0 by 0.0 1.0",
                   "S0 S0 chi 1 by 1.0"}));
}

TEST(FaceOverlay, OfAFacePinchedAtBothEndsIsTwo) {
  // A lozenge that touches the left and the right side of a square parts it.
  const Contour lozenge = contour({{0, 2}, {2, 1}, {4, 2}, {2, 3}});
  EXPECT_EQ(texts(overlay({rectangle(0, 0, 4, 4)}, {lozenge})),
            (Lines{"V0 V0 chi 0 by 0.0", "S0 V0 chi 1 by 0.0 1.0", "S0 V0 chi 1 by 0.0 1.0",
                   "S0 S0 chi 1 by 1.0"}));
  // Both faces have their least node in common: ways out of it tell which is first.
  for (int k = 0; k < 4; ++k) {
    const Contour square = rectangle(0, 0, 4, 4);
    const FaceOverlay turned = overlay({k % 2 == 0 ? square : reversed(square)},
                                       {k / 2 == 0 ? lozenge : reversed(lozenge)});
    EXPECT_EQ(turned.locate({2, 3.5}), FaceId(1U)) << k;
    EXPECT_EQ(turned.locate({2, 0.5}), FaceId(2U)) << k;
  }
}

TEST(FaceOverlay, OfARingOverADiscWithIsland) {
  const std::vector<Contour> ring = {rectangle(0, 0, 9, 9), rectangle(2, 2, 7, 7),
                                     rectangle(4, 4, 5, 5)};
  EXPECT_EQ(texts(overlay(ring, {rectangle(1, 1, 8, 8)})),
            (Lines{"V0 V0 chi 0 by 0.0", "V1 S0 chi 0 by 0.0 0.1", "S0 V0 chi 0 by 0.0 1.0",
                   "S0 S0 chi 0 by 0.0 1.0", "S1 S0 chi 1 by 0.1"}));
}

TEST(FaceOverlay, LocatesPointsOffContours) {
  const FaceOverlay bars = overlay({contour({{0, 1}, {1, 0}, {9, 8}, {8, 9}})},
                                   {contour({{0, 8}, {8, 0}, {9, 1}, {1, 9}})});
  EXPECT_EQ(bars.locate({4.5, 4.5}), FaceId(5U));
  EXPECT_EQ(bars.locate({-5, 4}), kUnboundedFace);
  EXPECT_EQ(bars.locate({4.5, 1}), kUnboundedFace);
  EXPECT_EQ(bars.locate({4.5, 100}), kUnboundedFace);
  EXPECT_FALSE(bars.locate({1, 0}).valid());
  EXPECT_FALSE(bars.locate({4.5, 3.5}).valid());
  EXPECT_EQ(bars.faces()[bars.locate({1, 1})].lower.solid, true);
  EXPECT_EQ(bars.faces()[bars.locate({1, 8})].upper.solid, true);
}

TEST(FaceOverlay, LooksDownOnCrossingsExactly) {
  // The edges cross at (1/3, 1/3) and at (1, 1/2), below the point or beside it by an ulp.
  const FaceOverlay thirds = overlay({contour({{0, 0}, {1, 1}, {1, -9}, {0, -9}})},
                                     {contour({{0, 0.5}, {1, 0}, {1, -8}, {0, -8}})});
  const FaceId left = thirds.locate({1.0 / 3, 0.34});  // 1/3 rounds down
  const FaceId right = thirds.locate({std::nextafter(1.0 / 3, 1), 0.34});
  EXPECT_EQ(left, kUnboundedFace);
  EXPECT_EQ(right, kUnboundedFace);
  EXPECT_EQ(text(thirds.faces()[thirds.locate({0.25, 0.3})].upper), "S0");
  EXPECT_EQ(text(thirds.faces()[thirds.locate({0.25, 0.3})].lower), "V0");
  EXPECT_EQ(text(thirds.faces()[thirds.locate({0.5, 0.3})].lower), "S0");
  EXPECT_EQ(text(thirds.faces()[thirds.locate({0.5, 0.3})].upper), "V0");

  // An island straight above, just left and just right of a crossing whose four faces differ.
  for (const double dx : {-0x1p-40, 0.0, 0x1p-40}) {
    const Contour island = contour({{1 + dx, 3}, {2, 3}, {1.5, 4}});
    const FaceOverlay frame =
        overlay({rectangle(-9, -9, 9, 9), contour({{0, 0}, {2, 1}, {1, -5}}), island},
                {contour({{0, 1}, {2, 0}, {1, -6}})});
    const FaceId around = frame.locate({1.5, 2});
    EXPECT_EQ(frame.faces()[around].chi, -1) << dx;
    EXPECT_EQ(frame.locate({1 + dx, 2}), around);
  }
}

void expect_complement(const Section& section, const Complement& complement) {
  const Nesting nested = nest(complement.section);
  ASSERT_EQ(complement.section.contours.size(), section.contours.size() + 1);
  ASSERT_EQ(complement.nesting.parent, nested.parent);
  ASSERT_EQ(complement.nesting.depth, nested.depth);
  ASSERT_EQ(complement.nesting.region, nested.region);
  ASSERT_EQ(complement.nesting.outer, nested.outer);
}

TEST(Complement, IsNestedAsAnySection) {
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const SectionStack stack = generate(kind, seed).stack;
      const double side = far_outside(stack);
      for (const Section& section : stack.sections) {
        const Nesting nesting = nest(section);
        const Complement complement = complement_of(section, nesting, side);
        expect_complement(section, complement);
        if (HasFatalFailure()) FAIL() << name_of(kind) << " seed " << seed;
        const auto voids = voids_of_contours(section, nesting);
        for (const ContourId c : section.contours.ids()) {
          ASSERT_EQ(voids[c], complement.nesting.region[c]);
          ASSERT_EQ(complement.hole(voids[c]) == c, nesting.depth[c] % 2 == 1);
        }
        ASSERT_FALSE(complement.hole(kExterior).valid());
      }
    }
  }
}

TEST(Complement, IsCutOffAtAPowerOfTwoFarOutside) {
  EXPECT_EQ(far_outside(one({rectangle(-3, 0, 1, 1)})), 16);
  EXPECT_EQ(far_outside(one({rectangle(-4, 0, 1, 1)})), 16);
  EXPECT_EQ(far_outside(one({rectangle(0, -4.5, 1, 1)})), 32);
  EXPECT_EQ(far_outside(one({rectangle(0, 0, 0x1p-1074, 0x1p-1074)})), 0x1p-1072);
  EXPECT_EQ(far_outside(one({rectangle(0, 0, 0x1p999, 1)})), 0x1p1001);
  EXPECT_GT(far_outside(SectionStack()), 0);
}

}  // namespace
}  // namespace tetloft::testing
