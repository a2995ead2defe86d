// Links and their kinds from sets of vertices, by the definitions: no half-faces, no
// orientation, no Euler formula for what can be counted.
#pragma once

#include <map>
#include <set>
#include <vector>

#include <tetloft/tet_mesh.hpp>

namespace tetloft::mesh_test {

using Simplex = std::set<VertexId>;
using Complex = std::set<Simplex>;

/// For each tet that contains `simplex`, its other vertices.
inline Complex link_of(const std::vector<TetVertices>& soup, const Simplex& simplex) {
  Complex link;
  for (const TetVertices& t : soup) {
    Simplex rest(t.begin(), t.end());
    bool contains = true;
    for (const VertexId v : simplex) contains = rest.erase(v) == 1 && contains;
    if (contains) link.insert(rest);
  }
  return link;
}

/// Components of the simplices, connected through common vertices.
inline std::size_t count_components(const Complex& simplices) {
  std::set<VertexId> all;
  for (const Simplex& s : simplices) all.insert(s.begin(), s.end());
  std::size_t count = 0;
  while (!all.empty()) {
    ++count;
    std::set<VertexId> reached{*all.begin()};
    for (bool grew = true; grew;) {
      grew = false;
      for (const Simplex& s : simplices) {
        bool meets = false;
        for (const VertexId v : s) meets = meets || reached.contains(v);
        if (!meets) continue;
        const std::size_t before = reached.size();
        reached.insert(s.begin(), s.end());
        grew = grew || reached.size() != before;
      }
    }
    for (const VertexId v : reached) all.erase(v);
  }
  return count;
}

/// The simplices of one dimension less, with how many of the given contain each.
inline std::map<Simplex, int> facets(const Complex& simplices) {
  std::map<Simplex, int> count;
  for (const Simplex& s : simplices) {
    for (const VertexId v : s) {
      Simplex f = s;
      f.erase(v);
      ++count[f];
    }
  }
  return count;
}

inline Complex boundary_of(const Complex& simplices) {
  Complex boundary;
  for (const auto& [facet, count] : facets(simplices)) {
    if (count == 1) boundary.insert(facet);
  }
  return boundary;
}

inline LinkKind oracle_kind_of_edge_link(const Complex& link) {
  if (link.empty()) return LinkKind::empty;
  if (count_components(link) > 1) return LinkKind::singular_components;
  return boundary_of(link).empty() ? LinkKind::sphere : LinkKind::disc;
}

inline LinkKind oracle_kind_of_vertex_link(const Complex& link) {
  if (link.empty()) return LinkKind::empty;
  if (count_components(link) > 1) return LinkKind::singular_components;
  std::set<VertexId> vertices;
  for (const Simplex& s : link) vertices.insert(s.begin(), s.end());
  for (const VertexId a : vertices) {
    Complex around;
    for (const Simplex& s : link) {
      if (!s.contains(a)) continue;
      Simplex rest = s;
      rest.erase(a);
      around.insert(rest);
    }
    if (count_components(around) > 1) return LinkKind::singular_pinch;
  }
  const long euler = static_cast<long>(vertices.size()) - static_cast<long>(facets(link).size()) +
                     static_cast<long>(link.size());
  // Close every hole of the surface by a disc; what results is a sphere or not.
  const std::size_t holes = count_components(boundary_of(link));
  if (euler + static_cast<long>(holes) != 2 || holes > 1) return LinkKind::singular_holes;
  return holes == 0 ? LinkKind::sphere : LinkKind::disc;
}

}  // namespace tetloft::mesh_test
