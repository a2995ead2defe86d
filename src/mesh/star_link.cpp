// Star and link of vertices, edges and faces (Nonato et al. 2000, section 5).
#include <tetloft/tet_mesh.hpp>

#include <algorithm>

#include "core/entry.hpp"
#include "mesh/local_index.hpp"

namespace tetloft {

using namespace internal;

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
  for (const HalfFaceId c : corners(v)) result.push_back(tet_of(c));
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
  std::vector<TetId> result;
  ring(a, b, start, result);
  return result;
}

bool TetMesh::ring(VertexId a, VertexId b, TetId start, std::vector<TetId>& ring) const {
  require_live(start);
  // Leaves `start` across face `out`; of the face's vertices off the edge, the `hinge`, stays
  // behind in the next one. Appends all tets up to the boundary, or up to `start`: then true.
  const auto walk = [&](int out, VertexId hinge) {
    TetId t = start;
    for (;;) {
      const HalfFaceId h = opposite(half_face(t, out));
      if (!h.valid()) return false;
      t = tet_of(h);
      if (t == start) return true;
      ring.push_back(t);
      out = index_in(t, hinge);
      hinge = corner_vertex(h);
    }
  };
  const int i = index_in(start, a);
  const int j = index_in(start, b);
  require_fit(i >= 0 && j >= 0 && i != j, "the tet to start from has not this edge");
  const int forward = turn(i, j);
  const int backward = turn(j, i);
  ring.assign(1, start);
  if (walk(forward, vertex(start, backward))) return true;
  // A path: the tets before `start` come first.
  const auto after = static_cast<std::ptrdiff_t>(ring.size());
  walk(backward, vertex(start, forward));
  std::rotate(ring.begin(), ring.begin() + after, ring.end());
  std::reverse(ring.begin(), ring.end() - after);
  return false;
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
