// The numbering of nodes against a list of them.
#include "subdivision/nodes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace tetloft::testing {

using namespace internal;
namespace {

TEST(Nodes, AreSlabVerticesLiftedOnesCutsAndCapsInOneSequence) {
  for (const auto& [vertices, lifted, cuts, caps] :
       {std::array<std::size_t, 4>{3, 2, 4, 1}, {1, 0, 0, 2}, {2, 0, 3, 0}, {4, 1, 0, 1}}) {
    const Nodes nodes(vertices, lifted, cuts);
    EXPECT_EQ(nodes.slab_vertices(), vertices);
    EXPECT_EQ(nodes.size_without_caps(), vertices + lifted + cuts);
    const std::string kinds = std::string(vertices, 'v') + std::string(lifted, 'l') +
                              std::string(cuts, 'c') + std::string(caps, 'p');
    std::array<std::size_t, 128> count{};  // of each kind so far
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const NodeId n(k);
      const char kind = kinds[k];
      const std::size_t number = count.at(static_cast<std::size_t>(kind))++;
      EXPECT_EQ(nodes.is_slab_vertex(n), kind == 'v');
      EXPECT_EQ(nodes.is_constructed(n), kind != 'v');
      EXPECT_EQ(nodes.is_lifted(n), kind == 'l');
      EXPECT_EQ(nodes.is_cut(n), kind == 'c');
      EXPECT_EQ(nodes.is_cap(n), kind == 'p');
      if (kind == 'v') {
        EXPECT_EQ(Nodes::slab_vertex(n), SlabVertexId(number));
        EXPECT_EQ(Nodes::of(SlabVertexId(number)), n);
      } else {
        EXPECT_EQ(nodes.constructed(n), ConstructedId(k - vertices));
        EXPECT_EQ(nodes.of(ConstructedId(k - vertices)), n);
      }
      if (kind == 'l') {
        EXPECT_EQ(nodes.lifted(n), LiftedId(number));
        EXPECT_EQ(nodes.of(LiftedId(number)), n);
      }
      if (kind == 'c') {
        EXPECT_EQ(nodes.cut(n), CutId(number));
        EXPECT_EQ(nodes.of(CutId(number)), n);
      }
      if (kind == 'p') {
        EXPECT_EQ(nodes.cap(n), CapId(number));
        EXPECT_EQ(nodes.of(CapId(number)), n);
      }
    }
  }
}

TEST(Nodes, OfAKindAreNumberedBeforeTheNextKindIsCounted) {
  const Nodes without_cuts(5, 3);
  const Nodes with_cuts(5, 3, 7);
  EXPECT_EQ(without_cuts.of(LiftedId(2)), with_cuts.of(LiftedId(2)));
  EXPECT_EQ(without_cuts.of(CutId(0)), with_cuts.of(CutId(0)));
  EXPECT_EQ(Nodes(5).of(ConstructedId(4)), with_cuts.of(CutId(1)));
}

}  // namespace
}  // namespace tetloft::testing
