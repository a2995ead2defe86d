// Local edits: each keeps every condition of validate().
#include <tetloft/tet_mesh.hpp>

#include <algorithm>
#include <optional>
#include <string>

#include "core/entry.hpp"
#include "core/guard.hpp"
#include "mesh/face_groups.hpp"
#include "mesh/tet_soup.hpp"

namespace tetloft {

using namespace internal;

using namespace mesh_detail;

namespace {

// The local vertex of `tet` opposite the given face, −1 if that is no face of it.
int apex_over(const TriangleVertices& face, const TetVertices& tet) {
  int apex = -1;
  for (int i = 0; i < 4; ++i) {
    const VertexId v = tet[static_cast<std::size_t>(i)];
    if (v == face[0] || v == face[1] || v == face[2]) continue;
    if (apex >= 0) return -1;
    apex = i;
  }
  return apex;
}

}  // namespace

VertexId TetMesh::add_vertices(std::size_t n) {
  require_fit(n <= kMostVertices - vertex_count(), "a mesh holds fewer than 2^32 - 1 vertices");
  const VertexId first(vertex_count_);
  if (corner_lists_.made() != nullptr) editable_corner_lists().first.resize(vertex_count_ + n);
  vertex_count_ += n;
  return first;
}

void TetMesh::add_slot(CornerLists& lists) {
  // Room is made in all arrays before one of them grows: should memory end, the mesh is as it was.
  if (tets_.size() == tets_.capacity()) {
    const std::size_t room = std::max<std::size_t>(4, 2 * tets_.size());
    tets_.reserve(room);
    opposite_.reserve(4 * room);
    lists.next.reserve(4 * room);
    lists.previous.reserve(4 * room);
  }
  const std::size_t corners = 4 * (tets_.size() + 1);
  // Arrays may have been made with room of their own.
  opposite_.reserve(corners);
  lists.next.reserve(corners);
  lists.previous.reserve(corners);
  tets_.emplace_back();
  opposite_.resize(corners);
  lists.next.resize(corners);
  lists.previous.resize(corners);
}

Result<HalfFaceId> TetMesh::find_partner(const TetVertices& tet, std::size_t i) const {
  const SortedFace face = sorted_face(tet, i);
  const TriangleVertices corners{VertexId(face.vertex[0]), VertexId(face.vertex[1]),
                                 VertexId(face.vertex[2])};
  for (const HalfFaceId c : this->corners(smallest_star(corners))) {
    const TetId t = tet_of(c);
    const int j = apex_over(corners, vertices(t));
    if (j < 0) continue;
    const HalfFaceId h = half_face(t, j);
    if (opposite(h).valid()) return refusal(face_text(face.vertex) + " has two tets already");
    if (sorted_face(vertices(t), static_cast<std::size_t>(j)).even == face.even) {
      return refusal("tet " + std::to_string(t.value()) + " lies on the same side of " +
                     face_text(face.vertex));
    }
    return h;
  }
  return HalfFaceId();
}

Result<TetId> TetMesh::add_tet(const TetVertices& tet) {
  return guard_internal([&]() -> Result<TetId> {
    const TetId t = free_.empty() ? TetId(tets_.size()) : free_.back();
    if (t.index() >= kMostTetSlots) return refusal("a mesh holds fewer than 2^30 tets");
    if (auto error = refuse_tet(tet, vertex_count(), t)) return *std::move(error);
    CornerLists& lists = editable_corner_lists();
    // Nothing changes before all four faces are accepted.
    std::array<HalfFaceId, 4> partner;
    for (std::size_t i = 0; i < 4; ++i) {
      const Result<HalfFaceId> found = find_partner(tet, i);
      if (!found) return found.error();
      partner[i] = *found;
    }

    if (free_.empty()) {
      add_slot(lists);
    } else {
      free_.pop_back();
    }
    tets_[t.index()] = tet;
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfFaceId h = half_face(t, static_cast<int>(i));
      opposite_[h.index()] = partner[i];
      if (partner[i].valid()) opposite_[partner[i].index()] = h;
      insert_corner(lists, h);
    }
    return t;
  });
}

void TetMesh::remove_tet(TetId t) {
  require_live(t);
  CornerLists& lists = editable_corner_lists();
  free_.push_back(t);  // the last that takes memory: the mesh is as it was where that ends
  for (int i = 0; i < 4; ++i) {
    const HalfFaceId h = half_face(t, i);
    const HalfFaceId o = opposite(h);
    if (o.valid()) opposite_[o.index()] = HalfFaceId();
    opposite_[h.index()] = HalfFaceId();
    erase_corner(lists, h);
  }
  tets_[t.index()] = TetVertices{};
}

IdVector<TetId, TetId> TetMesh::compact() {
  // All that takes memory: the mesh is as it was where that ends.
  IdVector<TetId, TetId> new_id(tet_slots());
  std::size_t count = 0;
  for (std::size_t t = 0; t < tet_slots(); ++t) {
    if (is_live(TetId(t))) new_id[TetId(t)] = TetId(count++);
  }
  for (std::size_t t = 0; t < tet_slots(); ++t) {
    const TetId to = new_id[TetId(t)];
    if (!to.valid()) continue;
    tets_[to.index()] = tets_[t];
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfFaceId o = opposite_[4 * t + i];
      opposite_[4 * to.index() + i] =
          o.valid() ? half_face(new_id[tet_of(o)], face_of(o)) : HalfFaceId();
    }
  }
  tets_.resize(count);
  opposite_.resize(4 * count);
  free_.clear();
  corner_lists_.drop();
  return new_id;
}

}  // namespace tetloft
