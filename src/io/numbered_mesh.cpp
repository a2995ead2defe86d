#include "io/numbered_mesh.hpp"

#include <algorithm>
#include <tuple>
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

std::size_t NumberedMesh::leave_out_repeated() {
  struct Corners {
    TetVertices sorted;
    std::size_t position;
  };
  std::vector<Corners> all;
  all.reserve(tets_.size());
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    all.push_back({tets_[t].corners, t});
    std::sort(all.back().sorted.begin(), all.back().sorted.end());
  }
  std::sort(all.begin(), all.end(), [](const Corners& a, const Corners& b) {
    return std::tie(a.sorted, a.position) < std::tie(b.sorted, b.position);
  });
  std::vector<bool> repeated(tets_.size());
  for (std::size_t i = 1; i < all.size(); ++i) {
    repeated[all[i].position] = all[i].sorted == all[i - 1].sorted;
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    if (!repeated[t]) tets_[kept++] = tets_[t];
  }
  const std::size_t left_out = tets_.size() - kept;
  tets_.resize(kept);
  return left_out;
}

Model NumberedMesh::take(const std::map<std::int64_t, std::string>& names, WarningList& warnings) {
  IdVector<VertexId, Point3> points;
  points.reserve(nodes_.size());
  for (const Node& node : nodes_) points.push_back(node.point);
  nodes_ = {};
  sort_by_number(tets_);
  if (const std::size_t repeated = leave_out_repeated(); repeated != 0) {
    warnings.add("left out: " + std::to_string(repeated) +
                 (repeated == 1 ? " tet that stands" : " tets that stand") +
                 " again, as of several groups");
  }
  GroupedSolid solid;
  for (const Tet& tet : tets_) solid.add_tet(tet.corners, tet.group);
  tets_ = {};
  return solid.take(std::move(points), names, warnings);
}

}  // namespace tetloft::internal::io
