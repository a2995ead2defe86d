// Crossings of Voronoi skeletons and well positioned contours (Nonato et al. 2000, Definition 1):
// by hand, and in rationals on generated sections.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "support/stacks/generate.hpp"
#include "support/voronoi_crossings.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

ConformingSection conformed(std::vector<Contour> contours) {
  Result<ConformingSection> s = conform(section(0, std::move(contours)), SectionId(0));
  EXPECT_TRUE(s.ok());
  return std::move(s).value();
}

// A rhombus whose internal skeleton runs from (x − 15/8, y) to (x + 15/8, y).
Contour flat(double x, double y) {
  return contour({{x - 4, y}, {x, y - 1}, {x + 4, y}, {x, y + 1}});
}

// And one whose skeleton runs from (x, y − 15/8) to (x, y + 15/8).
Contour tall(double x, double y) {
  return contour({{x, y - 4}, {x + 1, y}, {x, y + 4}, {x - 1, y}});
}

// "below-above" of each pair, with a ? where skeletons only touch.
std::string positions(const ConformingSection& below, const ConformingSection& above) {
  std::string text;
  for (const WellPositioned& pair : well_positioned(below, above)) {
    if (!text.empty()) text += ' ';
    text += std::to_string(pair.below.index()) + '-' + std::to_string(pair.above.index()) +
            (pair.proper ? "" : "?");
  }
  return text;
}

std::string positions(std::vector<Contour> below, std::vector<Contour> above) {
  return positions(conformed(std::move(below)), conformed(std::move(above)));
}

TEST(WellPositioned, AreContoursWhoseInternalSkeletonsCross) {
  EXPECT_EQ(positions({flat(0, 0)}, {tall(0, 0)}), "0-0");
  EXPECT_EQ(positions({flat(0, 0)}, {tall(1.75, 1.75)}), "0-0");
  EXPECT_EQ(positions({flat(0, 0)}, {tall(2, 0)}), "");
  EXPECT_EQ(positions({flat(0, 0)}, {tall(0, -2)}), "");
}

TEST(WellPositioned, OnlyTouchAtTheEndOfASkeleton) {
  EXPECT_EQ(positions({flat(0, 0)}, {tall(15. / 8, 0)}), "0-0?");
  EXPECT_EQ(positions({flat(0, 0)}, {tall(0, 15. / 8)}), "0-0?");
  EXPECT_EQ(positions({flat(0, 0)}, {tall(15. / 8, -15. / 8)}), "0-0?");
  // An ulp decides.
  EXPECT_EQ(positions({flat(0, 0)}, {tall(15. / 8 - 0x1p-50, 0)}), "0-0");
  EXPECT_EQ(positions({flat(0, 0)}, {tall(15. / 8 + 0x1p-50, 0)}), "");
}

TEST(WellPositioned, OnlyTouchWhereSkeletonsLieOnOneLine) {
  EXPECT_EQ(positions({flat(0, 0)}, {flat(0, 0)}), "0-0?");
  EXPECT_EQ(positions({flat(0, 0)}, {flat(1, 0)}), "0-0?");
  EXPECT_EQ(positions({flat(0, 0)}, {flat(15. / 4, 0)}), "0-0?");
  EXPECT_EQ(positions({flat(0, 0)}, {flat(4, 0)}), "");
  EXPECT_EQ(positions({flat(0, 0)}, {flat(0, 0.5)}), "");
  // One inside the other.
  const Contour longer = contour({{-40, 0}, {0, -10}, {40, 0}, {0, 10}});
  EXPECT_EQ(positions({longer}, {flat(3, 0)}), "0-0?");
  EXPECT_EQ(positions({flat(3, 0)}, {longer}), "0-0?");
}

TEST(WellPositioned, ShiftedSquaresAreNot) {
  // The skeleton of a square is a point, its centre.
  const Contour square = rectangle(0, 0, 4, 4);
  EXPECT_EQ(positions({square}, {square}), "0-0?");
  EXPECT_EQ(positions({square}, {rectangle(-2, -1, 6, 5)}), "0-0?");
  EXPECT_EQ(positions({square}, {rectangle(1, 0, 5, 4)}), "");
  EXPECT_EQ(positions({square}, {flat(3, 2)}), "0-0?");
  EXPECT_EQ(positions({square}, {flat(3, 2.5)}), "");
}

TEST(WellPositioned, TrianglesHaveNoInternalSkeleton) {
  const Contour triangle = contour({{0, 0}, {6, 0}, {0, 6}});
  EXPECT_EQ(positions({triangle}, {triangle}), "");
  EXPECT_EQ(positions({triangle}, {flat(2, 2)}), "");
  EXPECT_EQ(positions({triangle}, {}), "");
}

// Left and right of the line x = 0, which is their external skeleton but for rays far away.
std::vector<Contour> side_by_side(double y) {
  return {contour({{-3, y}, {-1, y - 1}, {-1, y + 1}}), contour({{3, y}, {1, y + 1}, {1, y - 1}})};
}

TEST(WellPositioned, AreInternalOverExternalSkeletonsWithBothContoursOfThese) {
  EXPECT_EQ(positions({flat(0, 0)}, side_by_side(0.5)), "0-0 0-1");
  EXPECT_EQ(positions(side_by_side(0.5), {flat(0, 0)}), "0-0 1-0");
  // The external skeleton has a vertex at (0, 0) then.
  EXPECT_EQ(positions({flat(0, 0)}, side_by_side(0)), "0-0? 0-1?");
  // Far below, the ray still crosses.
  EXPECT_EQ(positions({flat(0, -1000)}, side_by_side(0.5)), "0-0 0-1");
  EXPECT_EQ(positions({flat(2, -1000)}, side_by_side(0.5)), "");
}

TEST(WellPositioned, ExternalSkeletonsOfBothDoNotCount) {
  const std::vector<Contour> above{contour({{0, -3}, {1, -1}, {-1, -1}}),
                                   contour({{0, 3}, {-1, 1}, {1, 1}})};
  EXPECT_EQ(positions(side_by_side(0.25), above), "");
}

TEST(WellPositioned, AreHoleAndOuterContourWhereEdgesJoinThem) {
  // The skeleton of the corner of the ring runs from (8, 0) to (0, 8), dual to (2, 2)–(6, 6).
  const std::vector<Contour> ring{rectangle(-6, -6, 6, 6), rectangle(-2, -2, 2, 2)};
  EXPECT_EQ(positions(ring, {tall(4, 4)}), "0-0 1-0");
  EXPECT_EQ(positions({tall(4, 4)}, ring), "0-0 0-1");
  EXPECT_EQ(positions(ring, {tall(4, 1)}), "");
}

TEST(WellPositioned, AreContoursInsideAnotherOnlyAtItsSkeleton) {
  const Contour large = contour({{-40, 0}, {0, -10}, {40, 0}, {0, 10}});
  EXPECT_EQ(positions({large}, {tall(5, 0)}), "0-0");
  EXPECT_EQ(positions({large}, {tall(5, 3)}), "");
}

TEST(WellPositioned, DoNotDependOnHeights) {
  ConformingSection below = conformed({flat(0, 0)});
  ConformingSection above = conformed({tall(1, 0)});
  for (const auto& [low, high] : {std::pair(0.0, 1e-300), std::pair(-1e300, 1e300)}) {
    below.z = low;
    above.z = high;
    EXPECT_EQ(positions(below, above), "0-0");
  }
}

std::vector<SkeletonCrossing> crossings_in_rationals(const ConformingSection& below,
                                                     const ConformingSection& above) {
  std::vector<SkeletonCrossing> result;
  std::vector<oracle::VoronoiEdge> upper;
  for (std::size_t f = 0; f < above.edges.size(); ++f) {
    upper.push_back(oracle::voronoi_edge(above, EdgeId(f)));
  }
  for (std::size_t e = 0; e < below.edges.size(); ++e) {
    const oracle::VoronoiEdge lower = oracle::voronoi_edge(below, EdgeId(e));
    for (std::size_t f = 0; f < above.edges.size(); ++f) {
      if (!oracle::are_reverse(below.edges[EdgeId(e)].kind, above.edges[EdgeId(f)].kind)) continue;
      if (lower.is_far_from(upper[f])) continue;
      const oracle::Meeting meeting = oracle::meeting_of(lower, upper[f]);
      if (meeting == oracle::Meeting::apart) continue;
      result.push_back({EdgeId(e), EdgeId(f), meeting == oracle::Meeting::cross});
    }
  }
  return result;
}

struct Tally {
  std::size_t crossings = 0;
  std::size_t touches = 0;
};

void expect_agreement(const ConformingSection& below, const ConformingSection& above,
                      Tally& tally) {
  const std::vector<SkeletonCrossing> found = skeleton_crossings(below, above);
  ASSERT_EQ(found, crossings_in_rationals(below, above));
  for (const SkeletonCrossing& c : found) ++(c.proper ? tally.crossings : tally.touches);

  std::vector<SkeletonCrossing> mirrored = skeleton_crossings(above, below);
  for (SkeletonCrossing& crossing : mirrored) std::swap(crossing.below, crossing.above);
  std::sort(mirrored.begin(), mirrored.end());
  ASSERT_EQ(found, mirrored);
}

TEST(SkeletonCrossings, OfGeneratedSectionsAgreeWithRationals) {
  Tally tally;
  for (const StackKind kind : all_kinds()) {
    if (kind == StackKind::large_contours) continue;
    for (std::uint64_t seed = 70; seed < 74; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const SectionStack stack = generate(kind, seed).stack;
      const SectionId last(std::min<std::size_t>(1, stack.sections.size() - 1));
      const Result<ConformingSection> below = conform(stack.sections[SectionId(0)], SectionId(0));
      const Result<ConformingSection> above = conform(stack.sections[last], last);
      // Rationals are slow; near-coincident contours may not be conformable.
      if (!below || !above || below->vertex_count() * above->vertex_count() > 250) continue;
      expect_agreement(*below, *above, tally);
    }
  }
  EXPECT_GT(tally.crossings, 30U);
  EXPECT_GT(tally.touches, 100U);
}

TEST(SkeletonCrossings, OfRandomStarsAgreeWithRationals) {
  // On a small lattice much is parallel or cocircular, on a large one nothing.
  for (const int radius : {3, 6, 1000}) {
    SCOPED_TRACE(radius);
    Prng prng(static_cast<std::uint64_t>(radius));
    Tally tally;
    for (int k = 0; k < 30; ++k) {
      const auto draw = [&] {
        std::vector<Contour> contours{random_star(prng, 0, 0, radius, 8)};
        if (k % 2 == 1) contours.push_back(random_star(prng, 2 * radius + 1, 0, radius, 4));
        return conformed(std::move(contours));
      };
      const ConformingSection below = draw();
      expect_agreement(below, draw(), tally);
    }
    EXPECT_GT(tally.crossings, 40U);
    EXPECT_EQ(tally.touches == 0, radius == 1000) << tally.touches;
  }
}

}  // namespace
}  // namespace tetloft::testing
