// Tets of files in which nodes and elements have numbers, with gaps and in any order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/model.hpp>

#include "io/warning_list.hpp"

namespace tetloft::internal::io {

/// All nodes first, then index_nodes(), then tets.
class NumberedMesh {
 public:
  /// The point is finite.
  void add_node(std::int64_t number, const Point3& point) { nodes_.push_back({number, point}); }
  [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }
  /// Puts the nodes in the order of their numbers; returns one that stands twice, if any does.
  [[nodiscard]] std::optional<std::int64_t> index_nodes();

  /// Nothing where no node has this number.
  [[nodiscard]] std::optional<VertexId> find(std::int64_t number) const;
  void add_tet(std::int64_t number, const TetVertices& corners, std::int64_t group) {
    tets_.push_back({number, group, corners});
  }
  [[nodiscard]] std::size_t tets() const { return tets_.size(); }

  /// The model, as GroupedSolid makes it, with points and tets in the order of their numbers. Of
  /// tets with the same corners, as a file has them that are in several groups, the first stays,
  /// with a warning.
  [[nodiscard]] Model take(const std::map<std::int64_t, std::string>& names, WarningList& warnings);

 private:
  struct Node {
    std::int64_t number = 0;
    Point3 point;
  };
  struct Tet {
    std::int64_t number = 0;
    std::int64_t group = 0;
    TetVertices corners;
  };

  /// How many.
  std::size_t leave_out_repeated();

  std::vector<Node> nodes_;
  std::vector<Tet> tets_;
};

}  // namespace tetloft::internal::io
