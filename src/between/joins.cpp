#include "between/joins.hpp"

#include <algorithm>

#include "between/cheapest_paths.hpp"

namespace tetloft::internal::between {

namespace {

// What paths between the parts of a group cost.
class JoinCost {
 public:
  JoinCost(const DoublyConnected& group, const std::vector<std::uint8_t>& foreign,
           const motion::LatticeWindow& window, const std::vector<double>& value,
           const std::vector<std::uint32_t>& node, std::size_t nodes)
      : foreign_(foreign),
        nx_(static_cast<std::uint32_t>(window.nx())),
        ny_(static_cast<std::uint32_t>(window.ny())),
        value_(value),
        node_(node),
        in_group_(nodes, 0) {
    for (const std::uint32_t n : group.nodes) in_group_[n] = 1;
  }

  double operator()(std::uint32_t place) const {
    const std::uint32_t i = place % nx_;
    const std::uint32_t j = place / nx_;
    if (i == 0 || j == 0 || i + 1 == nx_ || j + 1 == ny_) return kNever;
    if (foreign_[place] != 0) return kNever;
    for (const std::uint32_t p : {place, place - 1, place + 1, place - nx_, place + nx_}) {
      const std::uint32_t node = node_[p];
      if (node != kNoNode && in_group_[node] == 0) return kNever;
    }
    const double out = std::max(value_[place], 0.0);
    return kStepCost + out * out;
  }

 private:
  const std::vector<std::uint8_t>& foreign_;
  std::uint32_t nx_, ny_;
  const std::vector<double>& value_;
  const std::vector<std::uint32_t>& node_;  // by place, with the paths so far
  std::vector<std::uint8_t> in_group_;
};

}  // namespace

bool join_parts(const std::vector<DoublyConnected>& groups, ForeignSamples& foreign,
                std::size_t layer, ClassShape& shape, const LayerLabels& labels) {
  if (groups.empty()) return false;
  PathSearch search(shape.window.size(), straight_steps(shape.window));
  const std::vector<std::vector<std::uint32_t>> samples = samples_by_node(labels);
  std::vector<std::uint32_t> node = labels.nodes(shape.window.size());
  bool changed = false;
  for (const DoublyConnected& group : groups) {
    std::vector<std::vector<std::uint32_t>> sources;
    for (const std::uint32_t n : group.nodes) sources.push_back(samples[n]);
    const std::vector<SamplePath> paths = search.join(
        sources,
        JoinCost(group, foreign.in(layer), shape.window, shape.value[layer], node, samples.size()));
    for (const SamplePath& path : paths) {
      changed = true;
      for (const std::uint32_t place : path) {
        if (shape.value[layer][place] < 0) continue;  // an end
        shape.value[layer][place] = kPathValue;
        node[place] = group.nodes.front();
      }
    }
  }
  return changed;
}

}  // namespace tetloft::internal::between
