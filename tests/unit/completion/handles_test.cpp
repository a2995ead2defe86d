// Handles are filled where a group has too many, one at a time, and no void is shut by it.
#include "completion/handles.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "unit/completion/void_slab.hpp"

namespace tetloft::testing {
namespace {

std::uint64_t fill(const ChiGroups& groups, VoidSlab& s) {
  ComplexShape shape{groups.sums(s.completion.complex()),
                     joined_voids(s.slab(), s.classes(), s.voids, s.completion.complex())};
  const std::uint64_t count = fill_handles(groups, s.voids, s.completion, shape);
  EXPECT_EQ(shape.sums, groups.sums(s.completion.complex()));
  EXPECT_EQ(shape.joined, joined_voids(s.slab(), s.classes(), s.voids, s.completion.complex()));
  return count;
}

TEST(Handles, AreFilledUntilTheRangeIsMet) {
  std::size_t filled = 0, asked = 0;
  const auto ask = [&](VoidSlab& s) {
    const auto chi = attached_chi(s.slab(), s.classes(), s.active, s.completion.complex());
    std::vector<ChiRange> ranges;
    for (const ClassId c : chi.ids()) {
      if (s.active[c] != 0) ranges.push_back({{c}, chi[c] + 1, chi[c] + 1});
    }
    const ChiGroups groups(s.slab(), s.classes(), s.active, ranges);
    const std::int32_t before = groups.deviation(groups.sums(s.completion.complex()));
    const auto joined = joined_voids(s.slab(), s.classes(), s.voids, s.completion.complex());
    const std::uint64_t count = fill(groups, s);
    const std::int32_t after = groups.deviation(groups.sums(s.completion.complex()));
    EXPECT_EQ(before - after, static_cast<std::int32_t>(count));
    EXPECT_EQ(joined, joined_voids(s.slab(), s.classes(), s.voids, s.completion.complex()));
    filled += count;
    asked += ranges.size();
  };
  for_each_void_slab(4, true, ask);
  // Most handles are those that voids need. Slabs with others:
  for (const auto& [kind, seed] : {std::pair{StackKind::lattice_pores, 19U},
                                   {StackKind::complementary_sections, 17U},
                                   {StackKind::stars_combs, 26U},
                                   {StackKind::nested_ngons, 24U}}) {
    const SectionStack stack = generate(kind, seed).stack;
    for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
      auto built = slab_case(stack, k);
      if (!built) continue;
      std::vector<Link> links = links_by_faces(*built);
      VoidSlab s(std::move(built), std::move(links));
      ask(s);
    }
  }
  EXPECT_GT(filled, 2U);
  EXPECT_LT(filled, asked);
}

TEST(Handles, AreLeftWhereNothingIsTooLow) {
  for_each_void_slab(4, true, [&](VoidSlab& s) {
    const auto chi = attached_chi(s.slab(), s.classes(), s.active, s.completion.complex());
    std::vector<ChiRange> ranges;
    for (const ClassId c : chi.ids()) ranges.push_back({{c}, chi[c] - 2, chi[c]});
    const Complex before = s.completion.complex();
    const ChiGroups groups(s.slab(), s.classes(), s.active, ranges);
    EXPECT_EQ(fill(groups, s), 0U);
    EXPECT_EQ(before.kept, s.completion.complex().kept);
  });
}

// A through hole is one void above and below: filling it would part them.
TEST(Handles, ThatVoidsNeedStay) {
  const std::vector<Contour> holed{box(-10, -10, 10, 10), box(-3, -3, 3, 3)};
  const auto s = void_slab(stack_of_boxes({holed, holed}), true);
  ASSERT_TRUE(s);
  const ChiGroups groups(s->slab(), s->classes(), s->active, {{{ClassId(0U)}, 1, 1}});
  EXPECT_EQ(fill(groups, *s), 0U);
}

TEST(JoinedVoids, AreThoseThatHangTogether) {
  const std::vector<Contour> holed{box(-10, -10, 10, 10), box(-3, -3, 3, 3)};
  const auto through = void_slab(stack_of_boxes({holed, holed}), true);
  EXPECT_EQ(
      joined_voids(through->slab(), through->classes(), through->voids,
                   through->completion.complex()),
      (std::vector<SlabVoidId>{SlabVoidId(0U), SlabVoidId(1U), SlabVoidId(0U), SlabVoidId(1U)}));
  const auto blind = void_slab(stack_of_boxes({holed, {box(-10, -10, 10, 10)}}), true);
  EXPECT_EQ(
      joined_voids(blind->slab(), blind->classes(), blind->voids, blind->completion.complex()),
      (std::vector<SlabVoidId>{SlabVoidId(0U), SlabVoidId(1U), SlabVoidId(0U)}));
}

}  // namespace
}  // namespace tetloft::testing
