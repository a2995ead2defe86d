#include "support/slabs/disc_oracle.hpp"

#include <algorithm>
#include <map>

namespace tetloft::testing {

std::vector<LinkTriangle> link_of(const Slab& slab, const IdVector<TetId, std::uint8_t>& marked,
                                  SlabVertexId v) {
  std::vector<LinkTriangle> link;
  for (const TetId t : slab.tets()) {
    const auto corner = slab.vertices(t);
    const auto at = std::find(corner.begin(), corner.end(), v);
    if (at == corner.end() || !has_corner(marked[t], static_cast<int>(at - corner.begin()))) {
      continue;
    }
    LinkTriangle opposite(corner.begin(), corner.end());
    opposite.erase(v);
    link.push_back(opposite);
  }
  return link;
}

std::string not_a_disc(const std::vector<LinkTriangle>& triangles) {
  if (triangles.empty()) return "no triangle";
  using Edge = std::set<SlabVertexId>;
  std::map<Edge, std::vector<std::size_t>> on_edge;
  std::set<SlabVertexId> vertices;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    vertices.insert(triangles[i].begin(), triangles[i].end());
    for (const SlabVertexId v : triangles[i]) {
      Edge edge = triangles[i];
      edge.erase(v);
      on_edge[edge].push_back(i);
    }
  }
  std::vector<std::size_t> sheet(triangles.size());
  for (std::size_t i = 0; i < sheet.size(); ++i) sheet[i] = i;
  std::map<SlabVertexId, std::vector<SlabVertexId>> along_boundary;
  for (const auto& [edge, at] : on_edge) {
    if (at.size() > 2) return "an edge of three triangles";
    const SlabVertexId u = *edge.begin();
    const SlabVertexId v = *edge.rbegin();
    if (at.size() == 1) {
      along_boundary[u].push_back(v);
      along_boundary[v].push_back(u);
    } else {
      const std::size_t from = sheet[at[0]];
      for (std::size_t& s : sheet) s = s == from ? sheet[at[1]] : s;
    }
  }
  if (std::set<std::size_t>(sheet.begin(), sheet.end()).size() != 1) return "several sheets";
  if (vertices.size() + triangles.size() != on_edge.size() + 1) return "Euler characteristic not 1";
  if (along_boundary.empty()) return "no boundary";
  for (const auto& [v, next] : along_boundary) {
    if (next.size() != 2) return "a pinched boundary";
  }
  std::set<SlabVertexId> walked;
  std::vector<SlabVertexId> todo{along_boundary.begin()->first};
  while (!todo.empty()) {
    const SlabVertexId v = todo.back();
    todo.pop_back();
    if (!walked.insert(v).second) continue;
    for (const SlabVertexId w : along_boundary[v]) todo.push_back(w);
  }
  return walked.size() == along_boundary.size() ? "" : "several boundary cycles";
}

}  // namespace tetloft::testing
