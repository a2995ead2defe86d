#include "io/numbered_mesh.hpp"

#include <algorithm>
#include <utility>

#include "io/groups.hpp"

namespace tetloft::internal::io {

namespace {

template <class Numbered>
void sort_by_number(std::vector<Numbered>& all) {
  const auto less = [](const Numbered& a, const Numbered& b) { return a.number < b.number; };
  if (!std::is_sorted(all.begin(), all.end(), less)) std::stable_sort(all.begin(), all.end(), less);
}

}  // namespace

std::optional<std::int64_t> NumberedMesh::index_nodes() {
  sort_by_number(nodes_);
  const auto twice =
      std::adjacent_find(nodes_.begin(), nodes_.end(),
                         [](const Node& a, const Node& b) { return a.number == b.number; });
  if (twice == nodes_.end()) return std::nullopt;
  return twice->number;
}

std::optional<VertexId> NumberedMesh::find(std::int64_t number) const {
  if (nodes_.empty() || number < nodes_.front().number) return std::nullopt;
  // Most files number their nodes without gaps.
  const std::uint64_t place =
      static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(nodes_.front().number);
  if (place < nodes_.size() && nodes_[place].number == number) return VertexId(place);
  const auto found =
      std::lower_bound(nodes_.begin(), nodes_.end(), number,
                       [](const Node& node, std::int64_t n) { return node.number < n; });
  if (found == nodes_.end() || found->number != number) return std::nullopt;
  return VertexId(found - nodes_.begin());
}

Model NumberedMesh::take(const std::map<std::int64_t, std::string>& names, WarningList& warnings) {
  IdVector<VertexId, Point3> points;
  points.reserve(nodes_.size());
  for (const Node& node : nodes_) points.push_back(node.point);
  nodes_ = {};
  sort_by_number(tets_);
  GroupedSolid solid;
  for (const Tet& tet : tets_) solid.add_tet(tet.corners, tet.group);
  tets_ = {};
  return solid.take(std::move(points), names, warnings);
}

}  // namespace tetloft::internal::io
