#include "between/void_repair.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "between/cheapest_paths.hpp"

namespace tetloft::internal::between {

namespace {

constexpr double kFilled = -0.5;
constexpr double kOpened = 0.5;

// Beside the numbers of groups that are connected below and above:
constexpr std::uint32_t kNoGroup = 0xFFFFFFFFU;
constexpr std::uint32_t kClosed = 0xFFFFFFFEU;  // with neither the exterior nor a given hole

class VoidRepair {
 public:
  VoidRepair(const VoidGraph& voids, ForeignSamples& foreign, std::size_t layer, ClassShape& shape)
      : voids_(voids),
        foreign_(foreign),
        layer_(layer),
        shape_(shape),
        value_(shape.value[layer]),
        group_(node_count(), kNoGroup) {}

  bool repair() {
    const std::vector<std::uint32_t> open = find_wrong_voids();
    if (open.empty()) return false;
    node_ = voids_.graph.layers[layer_].nodes(shape_.window.size());
    samples_ = samples_by_node(voids_.graph.layers[layer_]);
    PathSearch search(shape_.window.size(), steps_with_diagonals(shape_.window));
    bool changed = false;
    for (const std::uint32_t n : to_be_closed(open)) changed |= close(n, search);
    return changed;
  }

 private:
  [[nodiscard]] std::size_t node_count() const { return voids_.graph.layers[layer_].size.size(); }

  // Groups the voids that are not to stay as they are, and returns them.
  std::vector<std::uint32_t> find_wrong_voids() {
    std::vector<std::uint32_t> wrong;
    std::vector<std::size_t> given = voids_.all.front();
    given.insert(given.end(), voids_.all.back().begin(), voids_.all.back().end());
    std::sort(given.begin(), given.end());
    for (std::uint32_t n = 1; n < node_count(); ++n) {
      if (std::binary_search(given.begin(), given.end(), voids_.all[layer_][n])) continue;
      group_[n] = kClosed;
      wrong.push_back(n);
    }
    const auto groups = doubly_connected(voids_.graph, voids_.below, voids_.above, layer_);
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
      if (groups[g].with_exterior) group_[kExterior] = g;
      for (const std::uint32_t n : groups[g].nodes) {
        if (group_[n] == kClosed) continue;
        group_[n] = g;
        wrong.push_back(n);
      }
    }
    return wrong;
  }

  // From the shallowest on, without the deepest of each group that has no exterior.
  [[nodiscard]] std::vector<std::uint32_t> to_be_closed(const std::vector<std::uint32_t>& wrong) {
    depth_.assign(node_count(), 0);
    depth_[kExterior] = kNever;
    for (const std::uint32_t n : wrong) {
      for (const std::uint32_t place : samples_[n]) depth_[n] = std::max(depth_[n], value_[place]);
    }
    std::vector<std::uint32_t> order = wrong;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return depth_[a] != depth_[b] ? depth_[a] < depth_[b] : a > b;
    });
    std::vector<std::uint32_t> result;
    std::vector<std::uint32_t> with_deepest{kClosed, group_[kExterior]};
    for (std::size_t k = order.size(); k-- > 0;) {
      const std::uint32_t g = group_[order[k]];
      if (std::find(with_deepest.begin(), with_deepest.end(), g) == with_deepest.end()) {
        with_deepest.push_back(g);
      } else {
        result.push_back(order[k]);
      }
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  // May void n be opened to this one?
  [[nodiscard]] bool is_neighbour(std::uint32_t n, std::uint32_t other) const {
    if (other == kNoNode || other == n) return false;
    return group_[n] == kClosed ? group_[other] != kClosed : group_[other] == group_[n];
  }

  bool close(std::uint32_t n, PathSearch& search) {
    const auto path = search.reach(
        samples_[n], [&](std::uint32_t place) { return is_neighbour(n, node_[place]); },
        [&](std::uint32_t place) {
          const std::uint32_t other = node_[place];
          if (other != kNoNode) return is_neighbour(n, other) ? 0.0 : kNever;
          return kStepCost + value_[place] * value_[place];
        });
    if (path && wall(*path) < depth_[n]) {
      open(n, *path);
      return true;
    }
    const std::vector<std::uint8_t>& foreign = foreign_.in(layer_);
    const bool holds_foreign =
        std::any_of(samples_[n].begin(), samples_[n].end(),
                    [&](std::uint32_t place) { return foreign[place] != 0; });
    if (holds_foreign) return false;
    for (const std::uint32_t place : samples_[n]) {
      value_[place] = kFilled;
      node_[place] = kNoNode;
    }
    group_[n] = kNoGroup;
    return true;
  }

  [[nodiscard]] double wall(const SamplePath& path) const {
    double thickest = 0;
    for (const std::uint32_t place : path) thickest = std::max(thickest, -value_[place]);
    return thickest;
  }

  // Void n and the path from its neighbour to it become a part of that.
  void open(std::uint32_t n, const SamplePath& path) {
    const std::uint32_t to = node_[path.front()];
    std::vector<std::uint32_t> more = samples_[n];
    for (const std::uint32_t place : path) {
      if (node_[place] != kNoNode) continue;  // an end
      value_[place] = kOpened;
      more.push_back(place);
    }
    for (const std::uint32_t place : more) node_[place] = to;
    if (to != kExterior) samples_[to].insert(samples_[to].end(), more.begin(), more.end());
    group_[n] = kNoGroup;
  }

  const VoidGraph& voids_;
  ForeignSamples& foreign_;
  std::size_t layer_;
  ClassShape& shape_;
  std::vector<double>& value_;
  std::vector<std::uint32_t> group_;                 // by void
  std::vector<double> depth_;                        // by void
  std::vector<std::uint32_t> node_;                  // by place, as it is by now
  std::vector<std::vector<std::uint32_t>> samples_;  // by void
};

}  // namespace

VoidGraph graph_of_voids(const ClassShape& shape, const std::vector<double>& at,
                         std::vector<LayerLabels> layers) {
  VoidGraph voids;
  voids.graph = connect_layers(NodeKind::empty, shape, at, std::move(layers));
  voids.all = connected(voids.graph);
  voids.below = connected_below(voids.graph);
  voids.above = connected_above(voids.graph);
  return voids;
}

bool repair_voids(const VoidGraph& voids, ForeignSamples& foreign, std::size_t layer,
                  ClassShape& shape) {
  return VoidRepair(voids, foreign, layer, shape).repair();
}

}  // namespace tetloft::internal::between
