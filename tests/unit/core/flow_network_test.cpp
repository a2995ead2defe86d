// Least cuts, against all cuts of small networks.
#include "core/flow_network.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "core/prng.hpp"

namespace tetloft::internal {
namespace {

using Amount = FlowNetwork::Amount;

struct Arc {
  FlowNetwork::Node from, to;
  Amount capacity;
};

struct Network {
  std::size_t nodes = 0;
  std::vector<Arc> arcs;

  // The arcs from a set of nodes, as a mask, to others.
  [[nodiscard]] std::vector<std::size_t> leaving(unsigned set) const {
    std::vector<std::size_t> cut;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      if (((set >> arcs[k].from) & 1U) != 0 && ((set >> arcs[k].to) & 1U) == 0) cut.push_back(k);
    }
    return cut;
  }
  [[nodiscard]] Amount capacity(const std::vector<std::size_t>& cut) const {
    Amount sum = 0;
    for (const std::size_t k : cut) sum += arcs[k].capacity;
    return sum;
  }
};

// Of all cuts of least capacity that of the fewest nodes at the source, node 0; the sink is 1.
std::vector<std::size_t> nearest_least_cut(const Network& network) {
  unsigned best = 1;
  for (unsigned set = 1; set < (1U << network.nodes); set += 2) {
    if ((set & 2U) != 0) continue;
    const Amount capacity = network.capacity(network.leaving(set));
    const Amount least = network.capacity(network.leaving(best));
    if (capacity < least || (capacity == least && std::popcount(set) < std::popcount(best))) {
      best = set;
    }
  }
  return network.leaving(best);
}

FlowNetwork made(const Network& network) {
  FlowNetwork flow(network.nodes);
  for (const Arc& arc : network.arcs) flow.add_arc(arc.from, arc.to, arc.capacity);
  return flow;
}

TEST(FlowNetwork, CutsLeastAndNearestToTheSource) {
  Prng prng(20);
  for (int round = 0; round < 400; ++round) {
    Network network;
    network.nodes = 2 + prng.below(7);
    const std::size_t arcs = prng.below(20);
    for (std::size_t k = 0; k < arcs; ++k) {
      network.arcs.push_back({static_cast<FlowNetwork::Node>(prng.below(network.nodes)),
                              static_cast<FlowNetwork::Node>(prng.below(network.nodes)),
                              static_cast<Amount>(prng.below(4))});
    }
    FlowNetwork flow = made(network);
    std::vector<std::size_t> expected = nearest_least_cut(network);
    // Arcs without capacity are in the cut or not: nothing passes them.
    const auto no_capacity = [&](std::size_t k) { return network.arcs[k].capacity == 0; };
    std::vector<std::size_t> cut = flow.least_cut(0, 1);
    std::erase_if(cut, no_capacity);
    std::erase_if(expected, no_capacity);
    EXPECT_EQ(cut, expected) << round;
  }
}

TEST(FlowNetwork, GoesAroundArcsThatNoCutMayContain) {
  const Amount never = FlowNetwork::kUncuttable;
  // Source 0, sink 1; two ways, one uncuttable but for its last arc.
  const Network network{4, {{0, 2, never}, {2, 1, 7}, {0, 3, 2}, {3, 1, never}}};
  FlowNetwork flow = made(network);
  EXPECT_EQ(flow.uncuttably_reached(0), (std::vector<bool>{true, false, true, false}));
  EXPECT_EQ(flow.least_cut(0, 1), (std::vector<std::size_t>{1, 2}));
}

TEST(FlowNetwork, KnowsWhereThereIsNoCut) {
  const Amount never = FlowNetwork::kUncuttable;
  const FlowNetwork flow = made({4, {{0, 2, never}, {2, 3, never}, {3, 1, never}, {0, 1, 1}}});
  EXPECT_TRUE(flow.uncuttably_reached(0)[1]);
}

}  // namespace
}  // namespace tetloft::internal
