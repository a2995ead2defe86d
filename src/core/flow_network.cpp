#include "core/flow_network.hpp"

#include <algorithm>

namespace tetloft::internal {

void FlowNetwork::add_arc(Node from, Node to, Amount capacity) {
  arcs_.push_back({to, first_[from], capacity});
  first_[from] = static_cast<std::uint32_t>(arcs_.size() - 1);
  arcs_.push_back({from, first_[to], 0});
  first_[to] = static_cast<std::uint32_t>(arcs_.size() - 1);
  capacity_.push_back(capacity);
}

std::vector<bool> FlowNetwork::uncuttably_reached(Node source) const {
  std::vector<bool> reached(first_.size(), false);
  std::vector<Node> stack{source};
  reached[source] = true;
  while (!stack.empty()) {
    const Node u = stack.back();
    stack.pop_back();
    for (std::uint32_t a = first_[u]; a != kNone; a = arcs_[a].next) {
      if (a % 2 != 0 || capacity_[a / 2] != kUncuttable || reached[arcs_[a].to]) continue;
      reached[arcs_[a].to] = true;
      stack.push_back(arcs_[a].to);
    }
  }
  return reached;
}

// Breadth-first over arcs with something left, until the sink is reached.
bool FlowNetwork::find_levels(Node source, Node sink) {
  std::fill(level_.begin(), level_.end(), kNone);
  level_[source] = 0;
  order_.assign(1, source);
  for (std::size_t at = 0; at < order_.size(); ++at) {
    const Node u = order_[at];
    if (level_[sink] != kNone && level_[u] >= level_[sink]) break;
    for (std::uint32_t a = first_[u]; a != kNone; a = arcs_[a].next) {
      if (arcs_[a].left == 0 || level_[arcs_[a].to] != kNone) continue;
      level_[arcs_[a].to] = level_[u] + 1;
      order_.push_back(arcs_[a].to);
    }
  }
  return level_[sink] != kNone;
}

// Sends as much as goes along arcs that lead one level on.
void FlowNetwork::saturate(Node source, Node sink) {
  next_ = first_;
  std::vector<std::uint32_t> path;
  for (;;) {
    const Node at = path.empty() ? source : arcs_[path.back()].to;
    if (at == sink) {
      const auto least = std::min_element(
          path.begin(), path.end(),
          [&](std::uint32_t a, std::uint32_t b) { return arcs_[a].left < arcs_[b].left; });
      const Amount amount = arcs_[*least].left;
      std::size_t first_full = path.size();
      for (std::size_t k = path.size(); k-- > 0;) {
        arcs_[path[k]].left -= amount;
        arcs_[path[k] ^ 1U].left += amount;
        if (arcs_[path[k]].left == 0) first_full = k;
      }
      path.resize(first_full);
      continue;
    }
    std::uint32_t& a = next_[at];
    while (a != kNone && (arcs_[a].left == 0 || level_[arcs_[a].to] != level_[at] + 1)) {
      a = arcs_[a].next;
    }
    if (a != kNone) {
      path.push_back(a);
    } else if (path.empty()) {
      return;
    } else {
      // A dead end: its arc is passed over.
      const Node before = arcs_[path.back() ^ 1U].to;
      next_[before] = arcs_[path.back()].next;
      path.pop_back();
    }
  }
}

std::vector<std::size_t> FlowNetwork::least_cut(Node source, Node sink) {
  while (find_levels(source, sink)) saturate(source, sink);
  std::vector<std::size_t> cut;
  for (std::size_t k = 0; k < capacity_.size(); ++k) {
    const Node from = arcs_[2 * k + 1].to;
    const Node to = arcs_[2 * k].to;
    if (level_[from] != kNone && level_[to] == kNone) cut.push_back(k);
  }
  return cut;
}

}  // namespace tetloft::internal
