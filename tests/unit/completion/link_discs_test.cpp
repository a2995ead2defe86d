// Which vertices have a disc as their link, against sets of triangles.
#include "completion/link_discs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/prng.hpp"
#include "support/slabs/disc_oracle.hpp"
#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

TEST(DiscOracle, TellsDiscsFromWhatIsNone) {
  const auto t = [](int a, int b, int c) {
    return LinkTriangle{SlabVertexId(a), SlabVertexId(b), SlabVertexId(c)};
  };
  EXPECT_EQ(not_a_disc({t(0, 1, 2), t(1, 2, 3)}), "");
  EXPECT_NE(not_a_disc({}), "");
  EXPECT_NE(not_a_disc({t(0, 1, 2), t(3, 4, 5)}), "");
  EXPECT_NE(not_a_disc({t(0, 1, 2), t(2, 3, 4)}), "");
  EXPECT_NE(not_a_disc({t(0, 1, 2), t(0, 1, 3), t(0, 2, 3), t(1, 2, 3)}), "");
  EXPECT_NE(not_a_disc({t(0, 1, 3), t(1, 3, 4), t(1, 2, 4), t(2, 4, 5), t(0, 2, 5), t(0, 3, 5)}),
            "")
      << "an annulus";
}

// Some tets for some of their classes: each for those that a coin chooses.
IdVector<TetId, std::uint8_t> some_kept(const SlabCase& c, Prng& prng, std::uint32_t in_ten) {
  IdVector<TetId, std::uint8_t> kept;
  for (const TetId t : c.slab->tets()) {
    std::uint8_t mask = 0;
    for (int i = 0; i < 4; ++i) {
      if (prng.below(10) >= in_ten) continue;
      const ClassId id = c.classes->of(c.slab->vertex(t, i));
      mask = static_cast<std::uint8_t>(mask | own_corners(*c.slab, *c.classes, t, id));
    }
    kept.push_back(mask);
  }
  return kept;
}

struct Seen {
  std::size_t discs = 0;
  std::size_t others = 0;
};

void compare(const SlabCase& c, const IdVector<TetId, std::uint8_t>& kept, Seen& seen) {
  const IdVector<SlabVertexId, std::uint8_t> disc = link_discs(*c.slab, kept);
  ASSERT_EQ(disc.size(), c.slab->vertex_count());
  for (const SlabVertexId v : c.slab->vertices()) {
    const std::string wrong = not_a_disc(link_of(*c.slab, kept, v));
    EXPECT_EQ(disc[v] != 0, wrong.empty()) << "at vertex " << v.index() << ": " << wrong;
    ++(wrong.empty() ? seen.discs : seen.others);
  }
}

TEST(LinkDiscs, AreWhereTheTrianglesInTheLinkFormADisc) {
  Prng prng(215);
  std::array<Seen, 2> seen;  // of seeds and completions, of sets by chance
  for (const NamedSlab& s : generated_slabs(215, 1)) {
    if (s.built->slab->vertex_count() > 150) continue;
    SCOPED_TRACE(s.name);
    const Completed completed = complete(*s.built, true);
    compare(*s.built, completed.seed.kept, seen[0]);
    compare(*s.built, completed.complex.attached, seen[0]);
    for (const std::uint32_t in_ten : {1U, 4U, 8U}) {
      compare(*s.built, some_kept(*s.built, prng, in_ten), seen[1]);
    }
  }
  for (const Seen& of : seen) {
    EXPECT_GT(of.discs, 100U);
    EXPECT_GT(of.others, 100U);
  }
}

}  // namespace
}  // namespace tetloft::testing
