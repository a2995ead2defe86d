// Passages between voids are closed, and nothing else.
#include "completion/passages.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "completion/handles.hpp"
#include "unit/completion/void_slab.hpp"

namespace tetloft::testing {
namespace {

std::vector<SlabVoidId> joined(const VoidSlab& s) {
  return joined_voids(s.slab(), s.classes(), s.voids, s.completion.complex());
}

// Pairs of voids that hang together: of one class, and of two.
struct Pairs {
  std::size_t of_one = 0, of_two = 0;
};
Pairs pairs(const VoidSlab& s) {
  const std::vector<SlabVoidId> of = joined(s);
  Pairs result;
  for (std::size_t a = 0; a < of.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (of[a] != of[b]) continue;
      const bool one = s.voids.class_of(SlabVoidId(a)) == s.voids.class_of(SlabVoidId(b));
      ++(one ? result.of_one : result.of_two);
    }
  }
  return result;
}

std::optional<Inseparable> close(VoidSlab& s, std::uint64_t* closed = nullptr) {
  Passages passages(s.slab(), s.classes(), s.active, s.voids, s.completion);
  const auto stuck = passages.close();
  if (closed != nullptr) *closed = passages.closed();
  return stuck;
}

TEST(Passages, OfAWormholeAndOfANotchAreClosed) {
  for (const char* name : {"holes_wm4_20", "holes_leak_30"}) {
    SCOPED_TRACE(name);
    const SectionStack stack = sample("cases/voids/" + std::string(name) + ".cnt");
    std::uint64_t all = 0;
    for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
      auto built = slab_case(stack, k);
      ASSERT_TRUE(built);
      std::vector<Link> links = links_by_faces(*built);
      VoidSlab s(std::move(built), std::move(links));
      const std::size_t before = pairs(s).of_two;
      std::uint64_t closed = 0;
      EXPECT_FALSE(close(s, &closed));
      EXPECT_EQ(pairs(s).of_two, 0U);
      EXPECT_EQ(before > 0, closed > 0);
      all += closed;
    }
    EXPECT_GT(all, 0U);
  }
}

// Whatever is linked: no wall joins classes, and none shuts what was open.
TEST(Passages, AreClosedAndLinkedVoidsStayOpen) {
  std::size_t passages = 0, open = 0, stuck = 0;
  for_each_void_slab(12, true, [&](VoidSlab& s) {
    const Complex before = s.completion.complex();
    const Pairs had = pairs(s);
    if (close(s)) {
      ++stuck;
      return;
    }
    const Pairs has = pairs(s);
    EXPECT_EQ(has.of_two, 0U);
    EXPECT_EQ(has.of_one, had.of_one);
    passages += had.of_two;
    open += had.of_one;
    // Tets are only added, and to classes of corners.
    for (const TetId t : s.slab().tets()) {
      EXPECT_EQ(before.kept[t] & ~s.completion.complex().kept[t], 0);
      EXPECT_EQ(s.completion.complex().attached[t] & ~s.completion.complex().kept[t], 0);
    }
    if (had.of_two == 0) {
      EXPECT_EQ(before.kept, s.completion.complex().kept);
    }
  });
  EXPECT_GT(passages, 20U);
  EXPECT_GT(open, 50U);
  EXPECT_LE(stuck, 3U);
}

// Nothing linked but the exteriors: holes over holes, too, are parted where that can be.
TEST(Passages, OfHolesOverEachOtherAreClosedIfNothingLinksThem) {
  std::size_t passages = 0, stuck = 0;
  for_each_void_slab(6, false, [&](VoidSlab& s) {
    passages += pairs(s).of_two;
    if (close(s)) {
      ++stuck;
    } else {
      EXPECT_EQ(pairs(s).of_two, 0U);
    }
  });
  EXPECT_GT(passages, 40U);
  EXPECT_LT(stuck, passages / 4);
}

TEST(Passages, BetweenRingsOfTwoClassesCannotBeClosed) {
  const SectionStack stack = sample("cases/voids/rings_unlinked.cnt");
  VoidSlab s(slab_case(stack, 0, {}), {{SlabId(0), RegionId(1U), RegionId(1U)}});
  const auto stuck = close(s);
  ASSERT_TRUE(stuck);
  EXPECT_NE(s.voids.class_of((*stuck)[0]), s.voids.class_of((*stuck)[1]));
  EXPECT_TRUE(!s.voids.hole((*stuck)[0]).valid() || !s.voids.hole((*stuck)[1]).valid());
}

// Rings that belong together leave hole and exterior apart.
TEST(Passages, BetweenRingsOfOneClassAreClosed) {
  const SectionStack stack = sample("cases/voids/rings_unlinked.cnt");
  auto built = slab_case(stack, 0, {{SlabId(0), RegionId(0U), RegionId(0U)}});
  std::vector<Link> links{{SlabId(0), RegionId(1U), RegionId(1U)}};
  VoidSlab s(std::move(built), std::move(links));
  ASSERT_TRUE(s.apart.empty());
  EXPECT_FALSE(close(s));
  EXPECT_EQ(pairs(s).of_two, 0U);
}

// Islands of other classes: no tet between them has four corners of the one until edges are
// divided.
TEST(Passages, BetweenForeignIslandsNeedFineContours) {
  const SectionStack coarse = sample("cases/voids/label_island_4.cnt");
  const auto of_frames = [](const SectionStack& stack) {
    // The frames are linked, their islands belong to nothing.
    return std::vector<Link>{{SlabId(0), nest(stack.sections[SectionId(0)]).region[ContourId(0U)],
                              nest(stack.sections[SectionId(1)]).region[ContourId(0U)]}};
  };
  VoidSlab s(slab_case(coarse, 0, of_frames(coarse)), {});
  EXPECT_TRUE(close(s));
  const SectionStack fine = refine(coarse, 0.5).value().stack;
  VoidSlab divided(slab_case(fine, 0, of_frames(fine)), {});
  EXPECT_FALSE(close(divided));
  EXPECT_EQ(pairs(divided).of_two, 0U);
}

}  // namespace
}  // namespace tetloft::testing
