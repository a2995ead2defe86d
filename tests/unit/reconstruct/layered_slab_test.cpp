// Slabs with sections between made by hand: taken where they change nothing of what hangs together.
#include "reconstruct/layered_slab.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using between::InnerSection;
using between::InnerSections;
using between::LayerLink;

ClassId class_at(std::size_t c) { return ClassId(c); }

// A section halfway; the regions, in canonical order, are of these classes.
InnerSection halfway(std::vector<Contour> contours, std::vector<ClassId> classes) {
  InnerSection mid;
  mid.section = stack_of_boxes({std::move(contours)}).sections[SectionId(0)];
  mid.section.z = 0.5;
  mid.nesting = nest(mid.section);
  mid.class_of = IdVector<RegionId, ClassId>(std::move(classes));
  return mid;
}

LayerLink linked(std::size_t below, std::size_t above) {
  return {RegionId(below), RegionId(above)};
}

// The slab of two sections, all regions of the lower linked with region 0 of the upper, and the
// exteriors.
struct Layered {
  ConformingSection lower, upper;
  std::vector<Link> regions, voids;

  explicit Layered(const SectionStack& stack)
      : lower(conform(stack.sections[SectionId(0)], SectionId(0)).value()),
        upper(conform(stack.sections[SectionId(1)], SectionId(1)).value()) {
    for (const RegionId r : lower.nesting.outer.ids()) {
      regions.push_back({SlabId(0), r, RegionId(0)});
    }
    voids.push_back({SlabId(0), RegionId(0), RegionId(0)});
  }

  [[nodiscard]] SlabSolid solid(const InnerSections& inner) const {
    const SlabOutcome outcome =
        build_slab_between(SlabId(0), lower, upper, {regions, &voids}, inner,
                           {DelaunayEngine::automatic, kDefaultWorkLimit})
            .value();
    return std::get<SlabSolid>(outcome);
  }
};

SectionStack columns() { return stack_of_boxes({{box(0, 0, 4, 4)}, {box(1, 1, 5, 5)}}); }

TEST(LayeredSlab, HasTheSectionBetweenInItsSolid) {
  const Layered slab(columns());
  const SlabSolid solid = slab.solid(
      {{halfway({box(0.5, 0.5, 4.5, 4.5)}, {class_at(0)})}, {{linked(0, 0)}, {linked(0, 0)}}});
  EXPECT_EQ(solid.sections_between, 1U);
  EXPECT_EQ(solid.sections_given_up, 0U);
  EXPECT_TRUE(solid.deviations.empty());
  EXPECT_EQ(solid.chi.raw(), std::vector<std::int32_t>{1});
  std::vector<Point2> inserted;
  for (const ConstructedId k : solid.constructed.ids()) {
    if (solid.origin[k] != PointOrigin::inserted) continue;
    EXPECT_EQ(solid.constructed[k].z, 0.5);
    inserted.push_back({solid.constructed[k].x, solid.constructed[k].y});
  }
  EXPECT_EQ(inserted, (std::vector<Point2>{{0.5, 0.5}, {0.5, 4.5}, {4.5, 0.5}, {4.5, 4.5}}));
  for (const Piece& piece : solid.pieces) {
    for (const NodeId n : piece.node) {
      EXPECT_LT(n.index(), solid.vertices.size() + solid.constructed.size());
    }
  }
}

TEST(LayeredSlab, GivesUpSectionsThatChangeWhatHangsTogether) {
  const Layered slab(columns());
  const ClassId c = class_at(0);
  const auto whole = [] { return box(0.5, 0.5, 4.5, 4.5); };
  const auto given_up = [&](const char* why, const InnerSections& inner) {
    const SlabSolid solid = slab.solid(inner);
    EXPECT_EQ(solid.sections_between, 0U) << why;
    EXPECT_EQ(solid.sections_given_up, 1U) << why;
    EXPECT_TRUE(solid.deviations.empty()) << why;
    EXPECT_EQ(std::count(solid.origin.begin(), solid.origin.end(), PointOrigin::inserted), 0)
        << why;
  };
  given_up("a cavity",
           {{halfway({whole(), box(2, 2, 3, 3)}, {c})}, {{linked(0, 0)}, {linked(0, 0)}}});
  given_up("a floating part",
           {{halfway({whole(), box(8, 8, 9, 9)}, {c, c})}, {{linked(0, 0)}, {linked(0, 0)}}});
  given_up("a handle", {{halfway({box(1, 1, 2, 4), box(3, 1, 4, 4)}, {c, c})},
                        {{linked(0, 0), linked(0, 1)}, {linked(0, 0), linked(1, 0)}}});
  given_up("a link that is missing", {{halfway({whole()}, {c})}, {{linked(0, 0)}, {}}});
  given_up("a class that there is not",
           {{halfway({whole()}, {class_at(7)})}, {{linked(0, 0)}, {linked(0, 0)}}});
}

TEST(LayeredSlab, KeepsClassesApart) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 4), box(6, 0, 10, 4)}, {box(0, 0, 4, 4), box(6, 0, 10, 4)}});
  Layered slab(stack);
  slab.regions = {{SlabId(0), RegionId(0), RegionId(0)}, {SlabId(0), RegionId(1), RegionId(1)}};
  const InnerSection mid = halfway({box(0, 0, 4, 4), box(6, 0, 10, 4)}, {class_at(0), class_at(1)});
  const SlabSolid apart =
      slab.solid({{mid}, {{linked(0, 0), linked(1, 1)}, {linked(0, 0), linked(1, 1)}}});
  EXPECT_EQ(apart.sections_between, 1U);
  EXPECT_EQ(apart.chi.raw(), (std::vector<std::int32_t>{1, 1}));
  const SlabSolid joined = slab.solid(
      {{mid}, {{linked(0, 0), linked(1, 1)}, {linked(0, 0), linked(0, 1), linked(1, 1)}}});
  EXPECT_EQ(joined.sections_between, 0U);
}

// Two holes below that are one above: the links say so, and the section between has either.
TEST(LayeredSlab, FollowsTheLinksOfVoids) {
  const SectionStack stack = stack_of_boxes(
      {{box(0, 0, 10, 6), box(1, 1, 4, 5), box(6, 1, 9, 5)}, {box(0, 0, 10, 6), box(1, 1, 9, 5)}});
  Layered slab(stack);
  slab.voids.push_back({SlabId(0), RegionId(1), RegionId(1)});
  slab.voids.push_back({SlabId(0), RegionId(2), RegionId(1)});
  for (const bool parted : {false, true}) {
    std::vector<Contour> contours{box(0, 0, 10, 6)};
    if (parted) {
      contours.push_back(box(1, 1, 4.5, 5));
      contours.push_back(box(5.5, 1, 9, 5));
    } else {
      contours.push_back(box(1, 1, 9, 5));
    }
    const SlabSolid solid =
        slab.solid({{halfway(contours, {class_at(0)})}, {{linked(0, 0)}, {linked(0, 0)}}});
    EXPECT_EQ(solid.sections_between, 1U) << parted;
    EXPECT_TRUE(solid.unrealised.empty()) << parted;
    EXPECT_EQ(solid.chi.raw(), std::vector<std::int32_t>{-1}) << parted;
  }
  // Closed between, they would be two pits and one.
  const SlabSolid closed =
      slab.solid({{halfway({box(0, 0, 10, 6)}, {class_at(0)})}, {{linked(0, 0)}, {linked(0, 0)}}});
  EXPECT_EQ(closed.sections_between, 0U);
}

}  // namespace
}  // namespace tetloft::testing
