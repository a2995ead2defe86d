// Building the half-face mesh, and its whole-mesh traversals.
#include <tetloft/tet_mesh.hpp>

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

std::string tet_text(HalfFaceId h) { return std::to_string(TetMesh::tet_of(h).value()); }

// Why the half-faces of one face cannot all be in a mesh; nothing if they can.
std::optional<Error> refuse_face(std::size_t lowest, std::span<const FaceMember> members) {
  if (members.size() == 1) return std::nullopt;
  const std::uint64_t upper = members[0].upper;
  const std::string face =
      face_text({static_cast<std::uint32_t>(lowest), static_cast<std::uint32_t>(upper >> 32),
                 static_cast<std::uint32_t>(upper)});
  if (members.size() > 2) {
    return refusal(face + " belongs to tets " + tet_text(members[0].half_face) + ", " +
                   tet_text(members[1].half_face) + " and " + tet_text(members[2].half_face));
  }
  if (members[0].even == members[1].even) {
    return refusal("tets " + tet_text(members[0].half_face) + " and " +
                   tet_text(members[1].half_face) + " lie on the same side of " + face);
  }
  return std::nullopt;
}

}  // namespace

Result<TetMesh> TetMesh::from_tets(std::size_t vertex_count, std::span<const TetVertices> tets) {
  return guard_internal([&]() -> Result<TetMesh> {
    if (tets.size() > kMostTetSlots) return refusal("a mesh holds fewer than 2^30 tets");
    if (vertex_count > kMostVertices) return refusal("a mesh holds fewer than 2^32 - 1 vertices");
    for (std::size_t t = 0; t < tets.size(); ++t) {
      if (auto error = refuse_tet(tets[t], vertex_count, TetId(t))) return *std::move(error);
    }

    std::vector<HalfFaceId> opposite(4 * tets.size());
    std::optional<Error> refused;
    const auto corners = [&](std::size_t t) -> const TetVertices& { return tets[t]; };
    for_each_face_group(vertex_count, tets.size(), corners, kAllSound,
                        [&](std::size_t lowest, std::span<const FaceMember> members) {
                          if (members.size() == 1 || refused) return;
                          refused = refuse_face(lowest, members);
                          if (refused) return;
                          opposite[members[0].half_face.index()] = members[1].half_face;
                          opposite[members[1].half_face.index()] = members[0].half_face;
                        });
    if (refused) return *std::move(refused);
    return from_adjacency(vertex_count, std::vector<TetVertices>(tets.begin(), tets.end()),
                          std::move(opposite));
  });
}

TetMesh TetMesh::from_adjacency(std::size_t vertex_count, std::vector<TetVertices> tets,
                                std::vector<HalfFaceId> opposite) {
  require_fit(tets.size() <= kMostTetSlots, "a mesh holds fewer than 2^30 tets");
  require_fit(vertex_count <= kMostVertices, "a mesh holds fewer than 2^32 - 1 vertices");
  require_fit(opposite.size() == 4 * tets.size(), "four half-faces for each tet");
  TetMesh mesh;
  mesh.tets_ = std::move(tets);
  mesh.opposite_ = std::move(opposite);
  mesh.vertex_count_ = vertex_count;
  for (std::size_t t = 0; t < mesh.tets_.size(); ++t) {
    if (!mesh.is_live(TetId(t))) mesh.free_.push_back(TetId(t));
  }
  return mesh;
}

CornerLists& TetMesh::editable_corner_lists() const {
  return corner_lists_.made_by([this] { return make_corner_lists(); });
}

CornerLists TetMesh::make_corner_lists() const {
  CornerLists lists{.first = std::vector<HalfFaceId>(vertex_count_),
                    .next = std::vector<HalfFaceId>(4 * tets_.size()),
                    .previous = std::vector<HalfFaceId>(4 * tets_.size())};
  std::vector<HalfFaceId> last(vertex_count_);
  // By id, as insert_corner() would, but the circles are closed at the end: each corner then
  // touches one other.
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    if (!is_live(TetId(t))) continue;
    for (int i = 0; i < 4; ++i) {
      const std::size_t v = tets_[t][static_cast<std::size_t>(i)].index();
      // Only an unvalidated from_adjacency() has vertices out of range; validate() says so.
      if (v >= vertex_count_) continue;
      const HalfFaceId c = half_face(TetId(t), i);
      if (last[v].valid()) {
        lists.next[last[v].index()] = c;
        lists.previous[c.index()] = last[v];
      } else {
        lists.first[v] = c;
      }
      last[v] = c;
    }
  }
  for (std::size_t v = 0; v < last.size(); ++v) {
    if (!last[v].valid()) continue;
    lists.next[last[v].index()] = lists.first[v];
    lists.previous[lists.first[v].index()] = last[v];
  }
  return lists;
}

void TetMesh::insert_corner(CornerLists& lists, HalfFaceId c) {
  HalfFaceId& first = lists.first[corner_vertex(c).index()];
  if (!first.valid()) first = lists.next[c.index()] = lists.previous[c.index()] = c;
  const HalfFaceId last = lists.previous[first.index()];
  lists.next[last.index()] = c;
  lists.previous[c.index()] = last;
  lists.next[c.index()] = first;
  lists.previous[first.index()] = c;
}

void TetMesh::erase_corner(CornerLists& lists, HalfFaceId c) {
  HalfFaceId& first = lists.first[corner_vertex(c).index()];
  const HalfFaceId next = lists.next[c.index()];
  const HalfFaceId previous = lists.previous[c.index()];
  lists.next[previous.index()] = next;
  lists.previous[next.index()] = previous;
  if (first == c) first = next == c ? HalfFaceId() : next;
}

int TetMesh::index_in(TetId t, VertexId v) const {
  const TetVertices& tet = vertices(t);
  for (std::size_t i = 0; i < 4; ++i) {
    if (tet[i] == v) return static_cast<int>(i);
  }
  return -1;
}

std::vector<HalfFaceId> TetMesh::boundary() const {
  std::vector<HalfFaceId> result;
  for (std::size_t h = 0; h < opposite_.size(); ++h) {
    if (!opposite_[h].valid() && is_live(TetId(h / 4))) result.push_back(HalfFaceId(h));
  }
  return result;
}

IdVector<TetId, ComponentId> TetMesh::components() const {
  IdVector<TetId, ComponentId> component(tet_slots());
  std::vector<TetId> stack;
  std::size_t count = 0;
  for (std::size_t s = 0; s < tet_slots(); ++s) {
    const TetId seed(s);
    if (!is_live(seed) || component[seed].valid()) continue;
    const ComponentId id(count++);
    component[seed] = id;
    stack.push_back(seed);
    while (!stack.empty()) {
      const TetId t = stack.back();
      stack.pop_back();
      for (int i = 0; i < 4; ++i) {
        const TetId n = neighbour(t, i);
        if (!n.valid() || component[n].valid()) continue;
        component[n] = id;
        stack.push_back(n);
      }
    }
  }
  return component;
}

}  // namespace tetloft
