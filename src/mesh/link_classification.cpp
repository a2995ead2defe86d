// Which vertices and edges are singular (Nonato et al. 2000, section 5).
//
// The link of v is a set of triangles. Faces have at most two tets, hence link edges at
// most two triangles, and the triangles around a link vertex a (the tets around edge va)
// form arcs and cycles, its umbrellas. If a has one umbrella everywhere, a connected link
// is a surface, orientable as its half-faces are glued oppositely: χ = 2 − 2 g − b for
// genus g and b boundary loops, so χ = 2 is a sphere, χ = 1 a disc, and nothing else is.
#include <tetloft/tet_mesh.hpp>

#include <bit>

#include "mesh/local_index.hpp"

namespace tetloft {

using namespace internal;

using namespace mesh_detail;

namespace {

/// Number of tets in the umbrella of edge (a, b) that contains `start`, and its shape.
struct Umbrella {
  std::size_t tets = 0;
  bool closed = false;
};

Umbrella walk_umbrella(const TetMesh& mesh, VertexId a, VertexId b, TetId start) {
  Umbrella u{1, false};
  // (a, b) turns one way, (b, a) the other.
  for (int direction = 0; direction < 2; ++direction) {
    TetId t = start;
    for (;;) {
      t = mesh.neighbour(t, turn(mesh.index_in(t, a), mesh.index_in(t, b)));
      if (!t.valid()) break;
      if (t == start) return {u.tets, true};
      ++u.tets;
    }
    std::swap(a, b);
  }
  return u;
}

/// Classifies vertex links one after the other, in the same scratch memory.
class VertexLinks {
 public:
  explicit VertexLinks(const TetMesh& mesh) : mesh_(mesh) {}

  LinkKind classify(VertexId v) {
    collect(v);
    if (corners_.empty()) return LinkKind::empty;
    if (components_ > 1) return LinkKind::singular_components;
    for (const LinkVertex& a : vertices_) {
      if (walk_umbrella(mesh_, v, a.id, a.tet).tets != a.tets) return LinkKind::singular_pinch;
    }
    const auto f = static_cast<long>(corners_.size());
    const long edges = (3 * f + boundary_edges_) / 2;
    const long euler = static_cast<long>(vertices_.size()) - edges + f;
    if (euler == 2) return LinkKind::sphere;
    return euler == 1 ? LinkKind::disc : LinkKind::singular_holes;
  }

 private:
  struct LinkVertex {
    VertexId id;
    TetId tet;                 // the first tet seen with it
    std::uint32_t tets = 0;    // how many tets of v contain it
    std::uint32_t parent = 0;  // union-find over link vertices
  };

  // Finds the link's vertices, its components and the number of its boundary edges.
  void collect(VertexId v) {
    corners_.clear();
    vertices_.clear();
    boundary_edges_ = 0;
    components_ = 0;
    for (const HalfFaceId c : mesh_.corners(v)) corners_.push_back(c);
    if (corners_.empty()) return;

    // At most three link vertices for each triangle, and half the table stays empty.
    table_.assign(std::bit_ceil(6 * corners_.size()), kEmpty);
    for (const HalfFaceId h : corners_) {
      const TetId t = TetMesh::tet_of(h);
      std::uint32_t root = kEmpty;
      for (int i = 0; i < 4; ++i) {
        if (i == TetMesh::face_of(h)) continue;
        // Face i contains v; it is the link edge opposite link vertex i.
        if (!mesh_.opposite(TetMesh::half_face(t, i)).valid()) ++boundary_edges_;
        const std::uint32_t r = find(enter(mesh_.vertex(t, i), t));
        if (root == kEmpty) {
          root = r;
        } else if (r != root) {
          vertices_[r].parent = root;
          --components_;
        }
      }
    }
  }

  // The local number of link vertex `id`, a new one if it is new.
  std::uint32_t enter(VertexId id, TetId tet) {
    const std::size_t mask = table_.size() - 1;
    // Fibonacci hashing (Knuth, TAOCP 3, section 6.4): 2^32 divided by the golden ratio.
    std::size_t slot = (id.value() * 2654435769U >> 7) & mask;
    while (table_[slot] != kEmpty && vertices_[table_[slot]].id != id) slot = (slot + 1) & mask;
    if (table_[slot] == kEmpty) {
      table_[slot] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back({id, tet, 0, table_[slot]});
      ++components_;
    }
    ++vertices_[table_[slot]].tets;
    return table_[slot];
  }

  std::uint32_t find(std::uint32_t i) {
    while (vertices_[i].parent != i) {
      vertices_[i].parent = vertices_[vertices_[i].parent].parent;
      i = vertices_[i].parent;
    }
    return i;
  }

  static constexpr std::uint32_t kEmpty = 0xFFFFFFFFU;

  const TetMesh& mesh_;
  std::vector<HalfFaceId> corners_;   // the link's triangles
  std::vector<LinkVertex> vertices_;  // the link's vertices by local number
  std::vector<std::uint32_t> table_;  // open addressing: local number or kEmpty
  long boundary_edges_ = 0;
  long components_ = 0;
};

}  // namespace

LinkKind TetMesh::classify_link(VertexId v) const {
  require_vertex(v);
  return VertexLinks(*this).classify(v);
}

LinkKind TetMesh::classify_link(VertexId a, VertexId b) const {
  const std::vector<TetId> tets = star(a, b);
  if (tets.empty()) return LinkKind::empty;
  const Umbrella u = walk_umbrella(*this, a, b, tets.front());
  if (u.tets != tets.size()) return LinkKind::singular_components;
  return u.closed ? LinkKind::sphere : LinkKind::disc;
}

std::vector<std::pair<VertexId, LinkKind>> TetMesh::singular_vertices() const {
  std::vector<std::pair<VertexId, LinkKind>> result;
  VertexLinks links(*this);
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    const LinkKind kind = links.classify(VertexId(v));
    if (kind != LinkKind::empty && !is_regular(kind)) result.emplace_back(VertexId(v), kind);
  }
  return result;
}

}  // namespace tetloft
