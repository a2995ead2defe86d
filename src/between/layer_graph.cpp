#include "between/layer_graph.hpp"

#include <algorithm>
#include <tuple>

#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::between {

namespace {

struct Shared {
  LayerEdge nodes;
  std::size_t samples = 0;
};

// Two neighbouring layers of one class.
struct LayerPair {
  NodeKind kind;
  const LayerLabels& below;
  const LayerLabels& above;
  const ClassShape& shape;
  // By place; empty where nothing moves.
  const std::vector<std::uint32_t>& node_below;
  const std::vector<std::uint32_t>& node_above;

  /// The node beyond the window.
  [[nodiscard]] std::uint32_t outside() const {
    return kind == NodeKind::solid ? kNoNode : kExterior;
  }
  [[nodiscard]] bool is_lone() const { return below.size.size() == 1 && above.size.size() == 1; }
  /// Is it enough to be connected?
  [[nodiscard]] bool is_edge(const Shared& shared) const {
    const std::size_t smaller =
        std::min(below.size[shared.nodes.first], above.size[shared.nodes.second]);
    if (smaller == kUnbounded) return true;
    return kind == NodeKind::solid ? 50 * shared.samples >= smaller : 10 * shared.samples > smaller;
  }
};

// Samples that nodes share, as they are found.
class SharedSamples {
 public:
  void add(const LayerEdge& nodes, std::size_t samples) {
    if (runs_.empty() || runs_.back().nodes != nodes) runs_.push_back({nodes});
    runs_.back().samples += samples;
  }
  /// Of two nodes only, with enough of them: how many more there are does not matter.
  [[nodiscard]] bool suffice(const LayerPair& pair) const {
    return pair.is_lone() && !runs_.empty() && pair.is_edge(runs_.back());
  }
  /// Of each two nodes; sorted.
  [[nodiscard]] std::vector<Shared> summed() && {
    std::sort(runs_.begin(), runs_.end(),
              [](const Shared& a, const Shared& b) { return a.nodes < b.nodes; });
    std::vector<Shared> result;
    for (const Shared& run : runs_) {
      if (result.empty() || result.back().nodes != run.nodes) result.push_back({run.nodes});
      result.back().samples += run.samples;
    }
    return result;
  }

 private:
  std::vector<Shared> runs_;
};

void share_at_rest(const LayerPair& pair, SharedSamples& shared) {
  auto low = pair.below.runs.begin();
  auto high = pair.above.runs.begin();
  while (low != pair.below.runs.end() && high != pair.above.runs.end()) {
    const std::uint32_t first = std::max(low->first, high->first);
    const std::uint32_t end = std::min(low->end, high->end);
    if (first < end) {
      shared.add({low->node, high->node}, end - first);
      if (shared.suffice(pair)) return;
    }
    if (low->end == end) ++low;
    if (high->end == end) ++high;
  }
}

void share_row(const LayerPair& pair, std::size_t j, double share, SharedSamples& shared) {
  const std::size_t nx = pair.shape.window.nx();
  const auto width = static_cast<double>(nx);
  const auto height = static_cast<double>(pair.shape.window.ny());
  const auto stride = static_cast<std::int64_t>(nx);
  const std::uint32_t outside = pair.outside();
  // The node at (x, y) of the window, to the nearest sample: halves go up.
  const auto node_at = [=](const std::vector<std::uint32_t>& node, double x, double y) {
    const double i = x + 0.5;
    const double k = y + 0.5;
    if (!(i >= 0 && k >= 0 && i < width && k < height)) return outside;
    const std::int64_t at = static_cast<std::int64_t>(k) * stride + static_cast<std::int64_t>(i);
    return node[static_cast<std::size_t>(at)];
  };
  const Point2* const motion = pair.shape.motion.data() + j * nx;
  const auto y = static_cast<double>(j);
  for (std::size_t i = 0; i < nx; ++i) {
    const double by_x = share * motion[i].x;
    const double by_y = share * motion[i].y;
    const auto x = static_cast<double>(i);
    const LayerEdge nodes{node_at(pair.node_below, x - by_x, y - by_y),
                          node_at(pair.node_above, x + by_x, y + by_y)};
    if (nodes.first != kNoNode && nodes.second != kNoNode) shared.add(nodes, 1);
  }
}

// How many samples each two nodes share with both layers moved by this share of the motion towards
// each other, those without any left out; sorted. No more than it takes to be connected of two
// nodes that are the only ones.
std::vector<Shared> shared_samples(const LayerPair& pair, double share) {
  SharedSamples shared;
  if (share == 0 || pair.shape.motion.empty()) {
    share_at_rest(pair, shared);
  } else {
    for (std::size_t j = 0; j < pair.shape.window.ny() && !shared.suffice(pair); ++j) {
      share_row(pair, j, share, shared);
    }
  }
  return std::move(shared).summed();
}

std::vector<LayerEdge> edges_between(const LayerPair& pair, double share) {
  std::vector<LayerEdge> edges;
  std::vector<std::uint8_t> has_below(pair.below.size.size(), 0);
  std::vector<std::uint8_t> has_above(pair.above.size.size(), 0);
  for (const Shared& shared : shared_samples(pair, share)) {
    if (!pair.is_edge(shared)) continue;
    edges.push_back(shared.nodes);
    has_below[shared.nodes.first] = has_above[shared.nodes.second] = 1;
  }
  const auto all = [](const std::vector<std::uint8_t>& has) {
    return std::find(has.begin(), has.end(), 0) == has.end();
  };
  if (all(has_below) && all(has_above)) return edges;
  for (const Shared& shared : shared_samples(pair, 0)) {
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
  const auto nodes_of = [&](std::size_t k) {
    const std::size_t places = shape.motion.empty() ? 0 : shape.window.size();
    return places == 0 ? std::vector<std::uint32_t>() : graph.layers[k].nodes(places);
  };
  std::vector<std::uint32_t> node_below = nodes_of(0);
  for (std::size_t k = 0; k + 1 < graph.layers.size(); ++k) {
    const double low = k == 0 ? 0 : at[k - 1];
    const double high = k == at.size() ? 1 : at[k];
    std::vector<std::uint32_t> node_above = nodes_of(k + 1);
    graph.edges.push_back(
        edges_between({kind, graph.layers[k], graph.layers[k + 1], shape, node_below, node_above},
                      (high - low) / 2));
    node_below = std::move(node_above);
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
