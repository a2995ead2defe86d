// A network of arcs with integer capacities, and its least cut (Ford and Fulkerson 1956; Dinitz
// 1970).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tetloft::internal {

class FlowNetwork {
 public:
  using Node = std::uint32_t;
  using Amount = std::int64_t;
  /// Of an arc that no cut may contain. Other capacities must sum up to less.
  static constexpr Amount kUncuttable = std::numeric_limits<Amount>::max() / 4;

  explicit FlowNetwork(std::size_t nodes) : first_(nodes, kNone), level_(nodes), next_(nodes) {}

  /// Arcs are numbered in the order in which they are added.
  void add_arc(Node from, Node to, Amount capacity);

  /// The nodes that uncuttable arcs alone lead to from `source`.
  [[nodiscard]] std::vector<bool> uncuttably_reached(Node source) const;

  /// Of all cuts of least capacity the one nearest to the source, which is unique: its arcs, by
  /// number. Requires that there is one. Once only.
  [[nodiscard]] std::vector<std::size_t> least_cut(Node source, Node sink);

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  // Arc 2 k is the k-th added, 2 k + 1 its reverse.
  struct Arc {
    Node to;
    std::uint32_t next;  // of its node
    Amount left;
  };
  bool find_levels(Node source, Node sink);
  void saturate(Node source, Node sink);

  std::vector<Arc> arcs_;
  std::vector<Amount> capacity_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> level_;
  std::vector<std::uint32_t> next_;  // the arc to look at next
  std::vector<Node> order_;
};

}  // namespace tetloft::internal
