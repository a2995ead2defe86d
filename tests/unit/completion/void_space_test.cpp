// How what a complex leaves empty hangs together.
#include "completion/void_space.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "unit/completion/void_slab.hpp"

namespace tetloft::testing {
namespace {

TEST(VoidSpace, AllOfDIsOnePartWithoutSolid) {
  const auto s = void_slab(sample("cases/voids/one_two.cnt"), true);
  Complex empty;
  empty.kept.assign(s->slab().tet_count(), 0);
  empty.attached.assign(s->slab().tet_count(), 0);
  const VoidSpace space(s->slab(), s->classes(), s->voids, empty);
  IdVector<TetId, std::uint8_t> seen(s->slab().tet_count(), 0);
  EXPECT_EQ(space.part_of(TetId(0U), seen).size(), s->slab().tet_count());
}

TEST(VoidSpace, TetsHangTogetherBothWays) {
  std::size_t ways = 0, contacts = 0;
  for_each_void_slab(3, true, [&](const VoidSlab& s) {
    const VoidSpace space(s.slab(), s.classes(), s.voids, s.completion.complex());
    for (const TetId t : s.slab().tets()) {
      if (!space.is_void(t)) continue;
      for (int i = 0; i < 4; ++i) {
        const TetId across = space.next(t, i);
        if (!across.valid()) continue;
        EXPECT_TRUE(space.is_void(across));
        bool back = false;
        for (int k = 0; k < 4; ++k) back = back || space.next(across, k) == t;
        EXPECT_TRUE(back);
        ++ways;
      }
      space.for_each_contact(t, [&](const VoidContact& contact) {
        EXPECT_EQ(contact.tet, t);
        EXPECT_FALSE(space.is_closed(t, contact.corners));
        ++contacts;
      });
    }
  });
  EXPECT_GT(ways, 1000U);
  EXPECT_GT(contacts, 200U);
}

}  // namespace
}  // namespace tetloft::testing
