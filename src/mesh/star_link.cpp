// Star and link of vertices, edges and faces (Nonato et al. 2000, section 5).
#include <tetloft/tet_mesh.hpp>

#include <algorithm>

#include "core/entry.hpp"
#include "mesh/local_index.hpp"

namespace tetloft {

using namespace mesh_detail;

VertexId TetMesh::smallest_star(std::span<const VertexId> candidates) const {
  std::array<HalfFaceId, 4> at;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    at[k] = first_corner(candidates[k]);
    if (!at[k].valid()) return candidates[k];
  }
  // All lists advance together; the first to come round is the shortest.
  for (;;) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      at[k] = next_corner(at[k]);
      if (at[k] == first_corner(candidates[k])) return candidates[k];
    }
  }
}

void TetMesh::require_vertex(VertexId v) const {
  require_named(v.index() < vertex_count(), "no vertex of the mesh");
}

void TetMesh::require_live(TetId t) const {
  require_named(t.index() < tet_slots() && is_live(t), "no tet of the mesh");
}

std::vector<TetId> TetMesh::star(VertexId v) const {
  require_vertex(v);
  std::vector<TetId> result;
  const HalfFaceId first = first_corner(v);
  if (!first.valid()) return result;
  HalfFaceId c = first;
  do {
    result.push_back(tet_of(c));
    c = next_corner(c);
  } while (c != first);
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<TetId> TetMesh::star(VertexId a, VertexId b) const {
  require_vertex(a);
  require_vertex(b);
  require_fit(a != b, "an edge has two ends");
  const std::array<VertexId, 2> ends{a, b};
  const VertexId from = smallest_star(ends);
  const VertexId to = from == a ? b : a;
  std::vector<TetId> result = star(from);
  std::erase_if(result, [&](TetId t) { return index_in(t, to) < 0; });
  return result;
}

std::vector<TetId> TetMesh::star(HalfFaceId h) const {
  require_live(tet_of(h));
  const HalfFaceId o = opposite(h);
  if (!o.valid()) return {tet_of(h)};
  return {tet_of(h), tet_of(o)};
}

std::vector<TetId> TetMesh::ring(VertexId a, VertexId b, TetId start) const {
  require_live(start);
  const bool has_edge = a != b && index_in(start, a) >= 0 && index_in(start, b) >= 0;
  require_fit(has_edge, "the tet to start from has not this edge");
  const auto next = [&](TetId t) { return neighbour(t, turn(index_in(t, a), index_in(t, b))); };
  const auto previous = [&](TetId t) { return neighbour(t, turn(index_in(t, b), index_in(t, a))); };
  // On a path, the tets before `start` come first.
  std::vector<TetId> result;
  TetId t = previous(start);
  while (t.valid() && t != start) {
    result.push_back(t);
    t = previous(t);
  }
  const bool cycle = t.valid();
  if (cycle) result.push_back(start);
  std::reverse(result.begin(), result.end());
  if (cycle) return result;
  for (t = start; t.valid(); t = next(t)) result.push_back(t);
  return result;
}

std::vector<TriangleVertices> TetMesh::link(VertexId v) const {
  std::vector<TriangleVertices> result;
  for (const TetId t : star(v)) result.push_back(face_vertices(half_face(t, index_in(t, v))));
  return result;
}

std::vector<std::array<VertexId, 2>> TetMesh::link(VertexId a, VertexId b) const {
  std::vector<std::array<VertexId, 2>> result;
  for (const TetId t : star(a, b)) {
    const int i = index_in(t, a);
    const int j = index_in(t, b);
    result.push_back({vertex(t, turn(i, j)), vertex(t, turn(j, i))});
  }
  return result;
}

std::vector<VertexId> TetMesh::link(HalfFaceId h) const {
  require_live(tet_of(h));
  const HalfFaceId o = opposite(h);
  if (!o.valid()) return {corner_vertex(h)};
  return {corner_vertex(h), corner_vertex(o)};
}

}  // namespace tetloft
