// Tets kept beyond what the rules ask for.
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "completion/void_space.hpp"
#include "core/prng.hpp"
#include "unit/completion/void_slab.hpp"

namespace tetloft::testing {
namespace {

TEST(Walls, AreKeptAndAttachedAndNothingIsTakenAway) {
  Prng prng(97);
  std::size_t walls = 0;
  for_each_void_slab(3, true, [&](VoidSlab& s) {
    const VoidSpace space(s.slab(), s.classes(), s.voids, s.completion.complex());
    std::vector<TetId> possible;
    for (const TetId t : s.slab().tets()) {
      const ClassId c = s.classes().of(s.slab().vertex(t, 0));
      if (s.active[c] != 0 && space.is_void(t) && space.of_one_class(t, 0xF)) {
        possible.push_back(t);
      }
    }
    for (int k = 0; k < 3 && !possible.empty(); ++k) {
      const Complex before = s.completion.complex();
      const TetId t = possible[prng.below(possible.size())];
      s.completion.build({{t, 0xF, s.classes().of(s.slab().vertex(t, 0))}});
      const Complex& after = s.completion.complex();
      EXPECT_EQ(after.attached[t], 0xF);
      EXPECT_FALSE(space.is_void(t));
      for (const TetId other : s.slab().tets()) {
        EXPECT_EQ(before.kept[other] & ~after.kept[other], 0);
        EXPECT_EQ(after.attached[other] & ~after.kept[other], 0);
      }
      ++walls;
    }
  });
  EXPECT_GT(walls, 40U);
}

// A trial that is not adopted changes nothing; one that is, all.
TEST(Walls, CanBeTriedFirst) {
  std::size_t tried = 0;
  for_each_void_slab(2, true, [&](VoidSlab& s) {
    const VoidSpace space(s.slab(), s.classes(), s.voids, s.completion.complex());
    TetId open;
    for (const TetId t : s.slab().tets()) {
      const ClassId c = s.classes().of(s.slab().vertex(t, 0));
      if (s.active[c] != 0 && space.is_void(t) && space.of_one_class(t, 0xF)) open = t;
    }
    if (!open.valid()) return;
    const Complex before = s.completion.complex();
    Completion trial = s.completion;
    trial.build({{open, 0xF, s.classes().of(s.slab().vertex(open, 0))}});
    EXPECT_EQ(before.kept, s.completion.complex().kept);
    EXPECT_EQ(before.attached, s.completion.complex().attached);
    EXPECT_NE(before.attached, trial.complex().attached);
    const Complex after = trial.complex();
    s.completion.adopt(std::move(trial));
    EXPECT_EQ(after.kept, s.completion.complex().kept);
    EXPECT_EQ(after.attached, s.completion.complex().attached);
    ++tried;
  });
  EXPECT_GT(tried, 5U);
}

}  // namespace
}  // namespace tetloft::testing
