#include "between/layer_graph.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "between/shared_samples.hpp"
#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::between {

namespace {

std::vector<LayerEdge> edges_between(const LayerPair& pair, double share) {
  std::vector<LayerEdge> edges;
  std::vector<std::uint8_t> has_below(pair.below.size.size(), 0);
  std::vector<std::uint8_t> has_above(pair.above.size.size(), 0);
  for (const SharedSamples& shared : shared_samples(pair, share)) {
    if (!pair.is_edge(shared)) continue;
    edges.push_back(shared.nodes);
    has_below[shared.nodes.first] = has_above[shared.nodes.second] = 1;
  }
  const auto all = [](const std::vector<std::uint8_t>& has) {
    return std::find(has.begin(), has.end(), 0) == has.end();
  };
  if (all(has_below) && all(has_above)) return edges;
  for (const SharedSamples& shared : shared_samples(pair, 0)) {
    const auto& [low, high] = shared.nodes;
    if ((has_below[low] == 0 || has_above[high] == 0) && pair.is_edge(shared)) {
      edges.push_back(shared.nodes);
    }
  }
  sort_distinct(edges);
  return edges;
}

// All nodes in one numbering.
class Numbering {
 public:
  explicit Numbering(const LayerGraph& graph) : one_exterior_(graph.kind == NodeKind::empty) {
    for (const LayerLabels& layer : graph.layers) {
      first_.push_back(count_);
      count_ += layer.size.size();
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::size_t of(std::size_t layer, std::uint32_t node) const {
    return one_exterior_ && node == kExterior ? 0 : first_[layer] + node;
  }

 private:
  std::vector<std::size_t> first_;
  std::size_t count_ = 0;
  bool one_exterior_;
};

// Adds the edges between layers k and k + 1.
void unite(const LayerGraph& graph, const Numbering& numbering, std::size_t k, UnionFind& sets) {
  for (const auto& [low, high] : graph.edges[k]) {
    sets.unite(numbering.of(k, low), numbering.of(k + 1, high));
  }
}

std::vector<std::size_t> numbers_of(const LayerGraph& graph, const Numbering& numbering,
                                    std::size_t layer, const UnionFind& sets) {
  std::vector<std::size_t> numbers(graph.layers[layer].size.size());
  for (std::uint32_t n = 0; n < numbers.size(); ++n) {
    numbers[n] = sets.find(numbering.of(layer, n));
  }
  return numbers;
}

}  // namespace

LayerGraph connect_layers(NodeKind kind, const ClassShape& shape, const std::vector<double>& at,
                          std::vector<LayerLabels> layers) {
  LayerGraph graph{kind, std::move(layers), {}};
  double longest = 0;
  for (const Point2& u : shape.motion) longest = std::max({longest, std::abs(u.x), std::abs(u.y)});
  for (std::size_t k = 0; k + 1 < graph.layers.size(); ++k) {
    const double low = k == 0 ? 0 : at[k - 1];
    const double high = k == at.size() ? 1 : at[k];
    graph.edges.push_back(edges_between(
        {kind, graph.layers[k], graph.layers[k + 1], shape, longest}, (high - low) / 2));
  }
  return graph;
}

NodeNumbers connected(const LayerGraph& graph) {
  const Numbering numbering(graph);
  UnionFind sets(numbering.count());
  for (std::size_t k = 0; k < graph.edges.size(); ++k) unite(graph, numbering, k, sets);
  NodeNumbers numbers;
  for (std::size_t k = 0; k < graph.layers.size(); ++k) {
    numbers.push_back(numbers_of(graph, numbering, k, sets));
  }
  return numbers;
}

NodeNumbers connected_below(const LayerGraph& graph) {
  const Numbering numbering(graph);
  UnionFind sets(numbering.count());
  NodeNumbers numbers;
  for (std::size_t k = 0; k < graph.layers.size(); ++k) {
    if (k > 0) unite(graph, numbering, k - 1, sets);
    numbers.push_back(numbers_of(graph, numbering, k, sets));
  }
  return numbers;
}

NodeNumbers connected_above(const LayerGraph& graph) {
  const Numbering numbering(graph);
  UnionFind sets(numbering.count());
  NodeNumbers numbers(graph.layers.size());
  for (std::size_t k = graph.layers.size(); k-- > 0;) {
    if (k + 1 < graph.layers.size()) unite(graph, numbering, k, sets);
    numbers[k] = numbers_of(graph, numbering, k, sets);
  }
  return numbers;
}

std::vector<DoublyConnected> doubly_connected(const LayerGraph& graph, const NodeNumbers& below,
                                              const NodeNumbers& above, std::size_t layer) {
  using Key = std::tuple<std::size_t, std::size_t, std::uint32_t>;
  std::vector<Key> keys;
  for (std::uint32_t n = 0; n < graph.layers[layer].size.size(); ++n) {
    keys.emplace_back(below[layer][n], above[layer][n], n);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<DoublyConnected> groups;
  for (std::size_t first = 0, last = 0; first < keys.size(); first = last) {
    DoublyConnected group;
    for (; last < keys.size() && std::get<0>(keys[last]) == std::get<0>(keys[first]) &&
           std::get<1>(keys[last]) == std::get<1>(keys[first]);
         ++last) {
      const std::uint32_t n = std::get<2>(keys[last]);
      if (graph.kind == NodeKind::empty && n == kExterior) {
        group.with_exterior = true;
      } else {
        group.nodes.push_back(n);
      }
    }
    if (group.nodes.size() > (group.with_exterior ? 0U : 1U)) groups.push_back(group);
  }
  return groups;
}

}  // namespace tetloft::internal::between
