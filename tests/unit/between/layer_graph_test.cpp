#include "between/layer_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/nesting.hpp>

#include "between/given_labels.hpp"
#include "between/layer_labels.hpp"
#include "core/prng.hpp"
#include "unit/between/field_slab.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

// Layers as pictures: '#' is inside.
ClassShape shape_of(const std::vector<std::vector<std::string>>& layers, const Point2& motion) {
  ClassShape shape;
  const std::vector<std::string>& first = layers.front();
  shape.window = {0, 0, static_cast<std::int64_t>(first[0].size()),
                  static_cast<std::int64_t>(first.size())};
  shape.motion.assign(shape.window.size(), motion);
  for (const std::vector<std::string>& layer : layers) {
    std::vector<double>& value = shape.value.emplace_back();
    for (const std::string& row : layer) {
      for (const char c : row) value.push_back(c == '#' ? -1 : 1);
    }
  }
  return shape;
}

LayerGraph graph_of(NodeKind kind, const ClassShape& shape) {
  std::vector<LayerLabels> labels;
  std::vector<double> at;
  for (std::size_t k = 0; k < shape.value.size(); ++k) {
    labels.push_back(kind == NodeKind::solid ? label_solids(shape.window, shape.value[k])
                                             : label_voids(shape.window, shape.value[k]));
    if (k > 1)
      at.push_back(static_cast<double>(k - 1) / static_cast<double>(shape.value.size() - 1));
  }
  return connect_layers(kind, shape, at, labels);
}

TEST(LayerLabels, SolidsAreConnectedStraightAndVoidsAcrossToo) {
  const ClassShape shape = shape_of({{"......", ".##...", ".#.#..", ".##...", "......"}}, {0, 0});
  const LayerLabels solids = label_solids(shape.window, shape.value[0]);
  EXPECT_EQ(solids.size, (std::vector<std::size_t>{5, 1}));
  EXPECT_EQ(label_voids(shape.window, shape.value[0]).size.size(), 1U);
  const ClassShape closed = shape_of({{".....", ".###.", ".#.#.", ".###.", "....."}}, {0, 0});
  const LayerLabels voids = label_voids(closed.window, closed.value[0]);
  EXPECT_EQ(voids.size, (std::vector<std::size_t>{kUnbounded, 1}));
  EXPECT_EQ(samples_by_node(voids)[1], std::vector<std::uint32_t>{12});
  EXPECT_TRUE(samples_by_node(voids)[kExterior].empty());
}

// Numbers of parts by flooding from one sample after the other; kNoNode elsewhere.
std::vector<std::uint32_t> flooded(const motion::LatticeWindow& window,
                                   const std::vector<double>& value, bool solid) {
  const auto nx = static_cast<std::int64_t>(window.nx());
  const auto size = static_cast<std::int64_t>(window.size());
  std::vector<std::uint32_t> node(window.size(), kNoNode);
  std::uint32_t parts = 0;
  const auto is_in = [&](std::int64_t at) {
    return (value[static_cast<std::size_t>(at)] < 0) == solid;
  };
  for (std::int64_t start = 0; start < size; ++start) {
    if (!is_in(start) || node[static_cast<std::size_t>(start)] != kNoNode) continue;
    std::vector<std::int64_t> waiting{start};
    while (!waiting.empty()) {
      const std::int64_t at = waiting.back();
      waiting.pop_back();
      if (at < 0 || at >= size || !is_in(at)) continue;
      std::uint32_t& number = node[static_cast<std::size_t>(at)];
      if (number != kNoNode) continue;
      number = parts;
      for (std::int64_t dj = -1; dj <= 1; ++dj) {
        for (std::int64_t di = -1; di <= 1; ++di) {
          if (solid && di != 0 && dj != 0) continue;
          const std::int64_t i = at % nx + di;
          if (i >= 0 && i < nx) waiting.push_back(at + dj * nx + di);
        }
      }
    }
    ++parts;
  }
  return node;
}

TEST(LayerLabels, AreThoseOfAFlood) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Prng prng(seed);
    const motion::LatticeWindow window{0, 0, 3 + static_cast<std::int64_t>(prng.below(25)),
                                       3 + static_cast<std::int64_t>(prng.below(25))};
    const double density = prng.between(0.2, 0.8);
    std::vector<double> value(window.size(), 1);
    for (std::int64_t j = 1; j + 1 < window.j1; ++j) {
      for (std::int64_t i = 1; i + 1 < window.i1; ++i) {
        if (prng.chance(density)) value[window.place(i, j)] = -1;
      }
    }
    const LayerLabels solids = label_solids(window, value);
    const LayerLabels voids = label_voids(window, value);
    const std::vector<std::uint32_t> node = solids.nodes(window.size());
    EXPECT_EQ(node, flooded(window, value, true)) << seed;
    EXPECT_EQ(voids.nodes(window.size()), flooded(window, value, false)) << seed;
    for (std::uint32_t at = 0; at < node.size(); ++at) EXPECT_EQ(solids.node_at(at), node[at]);
    EXPECT_EQ(solids.enclosed, voids.size.size() - 1) << seed;
    for (std::uint32_t n = 0; n < solids.size.size(); ++n) {
      const auto samples = std::count(node.begin(), node.end(), n);
      EXPECT_EQ(solids.size[n], static_cast<std::size_t>(samples)) << seed;
    }
  }
}

TEST(LayerGraph, SolidsNeedAFiftiethOfTheSmaller) {
  // Bars of 51 samples that share one, and of 50.
  for (const std::size_t n : {50U, 51U}) {
    const std::string bar = std::string(1, '.') + std::string(n, '#') + std::string(n, '.');
    const std::string other = std::string(n, '.') + std::string(n, '#') + std::string(1, '.');
    const std::string none(2 * n + 1, '.');
    const LayerGraph graph =
        graph_of(NodeKind::solid, shape_of({{none, bar, none}, {none, other, none}}, {0, 0}));
    EXPECT_EQ(graph.edges[0].size(), n == 50 ? 1U : 0U);
  }
}

TEST(LayerGraph, VoidsNeedMoreThanATenth) {
  for (const std::size_t n : {9U, 10U}) {
    const auto layer = [&](std::size_t before) {
      const std::size_t all = 2 * n + 3;
      return std::vector<std::string>{std::string(all, '.'), "." + std::string(all - 2, '#') + ".",
                                      "." + std::string(before, '#') + std::string(n, '.') +
                                          std::string(all - 2 - before - n, '#') + ".",
                                      "." + std::string(all - 2, '#') + ".", std::string(all, '.')};
    };
    const LayerGraph graph = graph_of(NodeKind::empty, shape_of({layer(1), layer(n)}, {0, 0}));
    EXPECT_EQ(graph.edges[0].size(), n == 9 ? 2U : 1U);
  }
}

TEST(LayerGraph, BothLayersAreMovedToTheMiddle) {
  const std::vector<std::string> left{"............", ".##.......##", "............"};
  const std::vector<std::string> right{"............", ".....##.....", "............"};
  const auto moved = graph_of(NodeKind::solid, shape_of({left, right}, {4, 0}));
  EXPECT_EQ(moved.edges[0], (std::vector<LayerEdge>{{0, 0}}));
  // Samples beyond the window are outside.
  EXPECT_TRUE(graph_of(NodeKind::solid, shape_of({left, right}, {100, 0})).edges[0].empty());
}

TEST(LayerGraph, WhatWouldHaveNoEdgeIsComparedAsItLies) {
  // The long bar moves on; the short one, moved as well, finds nothing.
  const std::vector<std::string> below{"..............", ".####.....##..", ".............."};
  const std::vector<std::string> above{"..............", "...####...##..", ".............."};
  EXPECT_EQ(graph_of(NodeKind::solid, shape_of({below, above}, {2, 0})).edges[0],
            (std::vector<LayerEdge>{{0, 0}, {1, 1}}));
  EXPECT_EQ(graph_of(NodeKind::solid, shape_of({below, above}, {-8, 0})).edges[0],
            (std::vector<LayerEdge>{{0, 0}, {1, 0}, {1, 1}}));
}

// Layers of random blots.
ClassShape blots(Prng& prng, double longest) {
  ClassShape shape;
  shape.window = {0, 0, 12 + static_cast<std::int64_t>(prng.below(12)),
                  12 + static_cast<std::int64_t>(prng.below(12))};
  shape.value.assign(3, std::vector<double>(shape.window.size(), 1));
  for (std::vector<double>& value : shape.value) {
    for (int blot = 0; blot < 9; ++blot) {
      const auto i0 = 1 + static_cast<std::int64_t>(prng.below(shape.window.nx() - 4));
      const auto j0 = 1 + static_cast<std::int64_t>(prng.below(shape.window.ny() - 4));
      const double v = prng.chance(0.6) ? -1 : 1;
      for (std::int64_t j = j0; j < std::min(j0 + 6, shape.window.j1 - 1); ++j) {
        for (std::int64_t i = i0; i < std::min(i0 + 5, shape.window.i1 - 1); ++i) {
          value[shape.window.place(i, j)] = v;
        }
      }
    }
  }
  for (std::size_t k = 0; k < shape.window.size(); ++k) {
    shape.motion.push_back({prng.between(-longest, longest), prng.between(-longest, longest)});
  }
  return shape;
}

// The edges between two layers, from all samples; `by`: the share of the motion.
std::set<LayerEdge> plain_edges(NodeKind kind, const ClassShape& shape, const LayerLabels& low,
                                const LayerLabels& high, double by) {
  const auto node = std::pair(low.nodes(shape.window.size()), high.nodes(shape.window.size()));
  const auto at = [&](const std::vector<std::uint32_t>& nodes, double x, double y) {
    const auto i = static_cast<std::int64_t>(std::floor(x + 0.5));
    const auto j = static_cast<std::int64_t>(std::floor(y + 0.5));
    const bool in = i >= 0 && j >= 0 && i < shape.window.i1 && j < shape.window.j1;
    return in ? nodes[shape.window.place(i, j)] : kind == NodeKind::solid ? kNoNode : kExterior;
  };
  std::set<LayerEdge> edges;
  std::set<std::uint32_t> has_low, has_high;
  for (const double share : {by, 0.0}) {
    std::map<LayerEdge, std::size_t> samples;
    for (std::int64_t j = 0; j < shape.window.j1; ++j) {
      for (std::int64_t i = 0; i < shape.window.i1; ++i) {
        const Point2& u = shape.motion[shape.window.place(i, j)];
        const auto x = static_cast<double>(i);
        const auto y = static_cast<double>(j);
        ++samples[{at(node.first, x - share * u.x, y - share * u.y),
                   at(node.second, x + share * u.x, y + share * u.y)}];
      }
    }
    std::set<LayerEdge> found;
    for (const auto& [nodes, count] : samples) {
      if (nodes.first == kNoNode || nodes.second == kNoNode) continue;
      if (share == 0 && has_low.count(nodes.first) != 0 && has_high.count(nodes.second) != 0) {
        continue;
      }
      const std::size_t smaller = std::min(low.size[nodes.first], high.size[nodes.second]);
      const bool enough = kind == NodeKind::solid ? 50 * count >= smaller : 10 * count > smaller;
      if (smaller == kUnbounded || enough) found.insert(nodes);
    }
    for (const LayerEdge& edge : found) {
      edges.insert(edge);
      has_low.insert(edge.first);
      has_high.insert(edge.second);
    }
  }
  return edges;
}

TEST(LayerGraph, EdgesAreThoseOfAllSamples) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Prng prng(seed);
    const ClassShape shape = blots(prng, seed % 3 == 0 ? 40 : 6);
    for (const NodeKind kind : {NodeKind::solid, NodeKind::empty}) {
      const LayerGraph graph = graph_of(kind, shape);
      const double by = 0.25;  // each of two layers half a gap apart moves as far
      for (std::size_t k = 0; k < 2; ++k) {
        const std::set<LayerEdge> want =
            plain_edges(kind, shape, graph.layers[k], graph.layers[k + 1], by);
        EXPECT_EQ(graph.edges[k], std::vector<LayerEdge>(want.begin(), want.end())) << seed;
      }
    }
  }
}

TEST(LayerGraph, ConnectionsBelowAndAbove) {
  const std::vector<std::string> one{".......", ".#####.", "......."};
  const std::vector<std::string> two{".......", ".##.##.", "......."};
  const LayerGraph graph = graph_of(NodeKind::solid, shape_of({one, two, two, one}, {0, 0}));
  const NodeNumbers below = connected_below(graph);
  const NodeNumbers above = connected_above(graph);
  for (const std::size_t k : {1U, 2U}) {
    const auto groups = doubly_connected(graph, below, above, k);
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_EQ(groups[0].nodes, (std::vector<std::uint32_t>{0, 1}));
  }
  const LayerGraph legs = graph_of(NodeKind::solid, shape_of({two, two, one}, {0, 0}));
  EXPECT_TRUE(doubly_connected(legs, connected_below(legs), connected_above(legs), 1).empty());
  EXPECT_EQ(connected(legs)[0][0], connected(legs)[0][1]);
}

struct Given {
  Section section;
  Nesting nesting;
  std::vector<RegionId> regions;

  explicit Given(std::vector<Contour> contours) {
    for (Contour& c : contours) section.contours.push_back(std::move(c));
    nesting = nest(section);
    for (const RegionId r : nesting.outer.ids()) regions.push_back(r);
  }
  [[nodiscard]] GivenLabels labels(const motion::LatticeWindow& window) const {
    return {{section, nesting, regions, 1}, window};
  }
};

TEST(GivenLabels, SamplesAreThoseOfTheInnermostContour) {
  // A ring, in its hole another one; the hole of that is a void of its own.
  const Given given({rectangle(0.5, 0.5, 20.5, 20.5), rectangle(4.5, 4.5, 16.5, 16.5),
                     rectangle(6.5, 6.5, 14.5, 14.5), rectangle(8.5, 8.5, 12.5, 12.5)});
  const motion::LatticeWindow window{-2, -2, 24, 24};
  const GivenLabels labels = given.labels(window);
  EXPECT_EQ(labels.voids().size, (std::vector<std::size_t>{kUnbounded, 144 - 64, 16}));
  const auto void_at = [&](std::int64_t i) {
    return labels.voids().nodes(window.size())[window.place(i, 10)];
  };
  const auto solid_at = [&](std::int64_t i) {
    return labels.solids().nodes(window.size())[window.place(i, 10)];
  };
  EXPECT_EQ(void_at(0), kExterior);
  EXPECT_EQ(void_at(2), kNoNode);
  EXPECT_EQ(void_at(5), 1U);
  EXPECT_EQ(void_at(7), kNoNode);
  EXPECT_EQ(void_at(9), 2U);
  EXPECT_EQ(solid_at(2), 0U);
  EXPECT_EQ(solid_at(7), 1U);
  // Half a step outside is near enough, one and a half are not.
  EXPECT_EQ(solid_at(0), 0U);
  EXPECT_EQ(solid_at(-1), kNoNode);
  EXPECT_EQ(solid_at(6), 1U);
  EXPECT_EQ(solid_at(10), kNoNode);
}

TEST(GivenLabels, ASubsetOfTheRegionsHasTheVoidsOfItsOwnContours) {
  Given given({rectangle(0.5, 0.5, 20.5, 20.5), rectangle(4.5, 4.5, 16.5, 16.5),
               rectangle(6.5, 6.5, 14.5, 14.5), rectangle(8.5, 8.5, 12.5, 12.5)});
  given.regions = {RegionId(0)};
  const motion::LatticeWindow window{-2, -2, 24, 24};
  EXPECT_EQ(given.labels(window).voids().size, (std::vector<std::size_t>{kUnbounded, 144}));
  given.regions = {RegionId(1)};
  EXPECT_EQ(given.labels(window).voids().size, (std::vector<std::size_t>{kUnbounded, 16}));
}

TEST(GivenLabels, EveryRegionHasASampleHoweverSmall) {
  // The second lies in a hole of the first, and all samples around it in the first itself.
  const Given given({rectangle(0.9, 0.9, 8.4, 8.4), rectangle(5.3, 5.3, 5.6, 5.6),
                     rectangle(5.44, 5.44, 5.46, 5.46), rectangle(12.4, 7.4, 12.41, 7.41)});
  const motion::LatticeWindow window{-2, -2, 16, 12};
  const GivenLabels labels = given.labels(window);
  const std::vector<std::uint32_t> node = labels.solids().nodes(window.size());
  ASSERT_EQ(labels.solids().size.size(), 3U);
  for (const std::size_t size : labels.solids().size) EXPECT_GE(size, 1U);
  for (std::uint32_t n = 0; n < 3; ++n) {
    EXPECT_EQ(static_cast<std::size_t>(std::count(node.begin(), node.end(), n)),
              labels.solids().size[n]);
  }
}

TEST(GivenLabels, AShellThinnerThanTheLatticeIsClosed) {
  const Given given({octagon(10.3, 10.3, 7.05), octagon(10.3, 10.3, 7)});
  const motion::LatticeWindow window{0, 0, 22, 22};
  const GivenLabels labels = given.labels(window);
  EXPECT_EQ(labels.voids().nodes(window.size())[window.place(10, 10)], 1U);
  EXPECT_EQ(labels.voids().nodes(window.size())[window.place(1, 1)], kExterior);
  EXPECT_GT(labels.solids().size[0], 40U);
}

}  // namespace
}  // namespace tetloft::testing
