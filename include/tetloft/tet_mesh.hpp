// The half-face tetrahedral mesh: pure combinatorics in flat arrays, no coordinates.
//
// Tet t has vertices vertex(t, 0 … 3). Face i of t lies opposite its vertex i; the half-
// face of t at face i is HalfFaceId 4 t + i. opposite(h) is the half-face of the
// neighbouring tet at the same face, or invalid on the boundary. Seen from inside tet
// (a, b, c, d), with (b − a) × (c − a) · (d − a) > 0, the faces are listed so that their
// normals by the right-hand rule point outwards: see kFaceVertex.
//
// Star and link follow Nonato et al. (2000), section 5: a vertex is regular iff its link
// is a disc (boundary) or a sphere (interior); an edge iff its link is one arc or cycle.
// All whole-mesh queries are linear in the mesh, all local ones in the star.
//
// A corner is a tet at one of its vertices. Corner and half-face are in bijection (the
// half-face opposite the vertex), so corners are named by half-faces; the corners of a
// vertex form a list, which reaches every sheet of a singular vertex. The lists are made when
// they are first asked for, in time linear in the mesh, as many meshes are never asked.
//
// Const functions are safe to call from several threads at once. Where memory ends, edits and
// the making of lists throw std::bad_alloc or return the error, and leave the mesh as it was. Ids
// handed to a mesh must be those of its own vertices, live tets and their half-faces: inline
// functions, face_vertices() and index_in() rely on it, all others verify it (result.hpp).
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

/// kFaceVertex[i] are the local vertices of face i, in the order whose right-hand normal
/// points out of a positive tet.
inline constexpr std::array<std::array<int, 3>, 4> kFaceVertex{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// kEdgeVertex[e] are the local vertices of edge e; edges e and 5 − e are disjoint.
inline constexpr std::array<std::array<int, 2>, 6> kEdgeVertex{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The vertices of face `face` of a tet, normal pointing out of a positive one.
template <class V>
[[nodiscard]] constexpr std::array<V, 3> face_of(const std::array<V, 4>& tet, int face) {
  const std::array<int, 3>& f = kFaceVertex[static_cast<std::size_t>(face)];
  return {tet[static_cast<std::size_t>(f[0])], tet[static_cast<std::size_t>(f[1])],
          tet[static_cast<std::size_t>(f[2])]};
}

/// How a link looks, and if singular, why.
enum class LinkKind : std::uint8_t {
  disc,                 ///< vertex on the boundary; for an edge: one arc
  sphere,               ///< vertex in the interior; for an edge: one cycle
  empty,                ///< in no tet
  singular_components,  ///< the link falls into several components
  singular_pinch,       ///< connected, but pinched at a link vertex
  singular_holes,       ///< a connected surface that is neither disc nor sphere
};

[[nodiscard]] constexpr bool is_regular(LinkKind kind) {
  return kind == LinkKind::disc || kind == LinkKind::sphere;
}

/// One violated condition of TetMesh::validate(), numbered as there.
struct MeshViolation {
  int condition = 0;
  std::string message;
};

/// The corners of one vertex, once around their circular list; valid until the mesh changes.
class CornerRange {
 public:
  class Iterator {
   public:
    using value_type = HalfFaceId;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    Iterator(const HalfFaceId* next, HalfFaceId at, bool at_end)
        : next_(next), at_(at), at_end_(at_end) {}
    [[nodiscard]] HalfFaceId operator*() const { return at_; }
    Iterator& operator++() {
      at_ = next_[at_.index()];
      at_end_ = true;  // or the first corner again
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) {
      return a.at_ == b.at_ && a.at_end_ == b.at_end_;
    }

   private:
    const HalfFaceId* next_ = nullptr;
    HalfFaceId at_;
    bool at_end_ = false;  // the list was left at its first corner once at least
  };

  CornerRange(const HalfFaceId* next, HalfFaceId first) : next_(next), first_(first) {}
  [[nodiscard]] Iterator begin() const { return {next_, first_, !first_.valid()}; }
  [[nodiscard]] Iterator end() const { return {next_, first_, true}; }
  [[nodiscard]] bool empty() const { return !first_.valid(); }

 private:
  const HalfFaceId* next_;
  HalfFaceId first_;
};

/// The corners of each vertex in a circular doubly linked list; unspecified in dead slots.
struct CornerLists {
  std::vector<HalfFaceId> first;     ///< first[v] = 4 t + i with vertex(t, i) = v; or invalid
  std::vector<HalfFaceId> next;      ///< by corner
  std::vector<HalfFaceId> previous;  ///< by corner
};

/// Holds corner lists once they are made: by the first who asks, while others wait; who asks later
/// reads them without a lock.
class CornerListsOnDemand {
 public:
  CornerListsOnDemand() = default;
  CornerListsOnDemand(const CornerListsOnDemand& other) { *this = other; }
  CornerListsOnDemand(CornerListsOnDemand&& other) noexcept { *this = std::move(other); }
  CornerListsOnDemand& operator=(const CornerListsOnDemand& other) {
    const CornerLists* theirs = other.made();
    hold(theirs != nullptr ? std::make_unique<CornerLists>(*theirs) : nullptr);
    return *this;
  }
  CornerListsOnDemand& operator=(CornerListsOnDemand&& other) noexcept {
    hold(std::move(other.lists_));
    other.made_ = nullptr;
    return *this;
  }
  ~CornerListsOnDemand() = default;

  /// Null before they are made.
  [[nodiscard]] const CornerLists* made() const { return made_.load(std::memory_order_acquire); }
  /// make() returns them; where it throws they are not made.
  template <class Make>
  CornerLists& made_by(Make&& make) {
    const std::scoped_lock lock(making_);
    if (lists_ == nullptr) hold(std::make_unique<CornerLists>(make()));
    return *lists_;
  }
  /// They are to be made again.
  void drop() { hold(nullptr); }

 private:
  void hold(std::unique_ptr<CornerLists> lists) {
    lists_ = std::move(lists);
    made_.store(lists_.get(), std::memory_order_release);
  }

  std::mutex making_;
  std::unique_ptr<CornerLists> lists_;
  std::atomic<const CornerLists*> made_ = nullptr;
};

class TETLOFT_API TetMesh {
 public:
  TetMesh() = default;

  /// The mesh of `tets` over vertices 0 … vertex_count − 1. Refused (invalid_input) when a
  /// vertex is out of range or repeated in a tet, when a face belongs to more than two
  /// tets or to two tets on its same side, or at 2^30 tets or more. Singular vertices and
  /// edges are accepted: classify them.
  static Result<TetMesh> from_tets(std::size_t vertex_count, std::span<const TetVertices> tets);

  /// As from_tets, with the adjacency given: opposite[4 t + i] is a half-face or invalid.
  /// The caller vouches for the ids; validate() checks them. Throws std::invalid_argument unless
  /// there are 4 half-faces for each tet, fewer than 2^30 tets and fewer than 2^32 − 1 vertices.
  static TetMesh from_adjacency(std::size_t vertex_count, std::vector<TetVertices> tets,
                                std::vector<HalfFaceId> opposite);

  [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }
  /// Number of tet slots; all are live unless tets were removed since compact().
  [[nodiscard]] std::size_t tet_slots() const { return tets_.size(); }
  [[nodiscard]] std::size_t tet_count() const { return tets_.size() - free_.size(); }
  [[nodiscard]] bool is_live(TetId t) const { return tets_[t.index()][0].valid(); }

  [[nodiscard]] const TetVertices& vertices(TetId t) const { return tets_[t.index()]; }
  [[nodiscard]] VertexId vertex(TetId t, int i) const {
    return tets_[t.index()][static_cast<std::size_t>(i)];
  }
  [[nodiscard]] static HalfFaceId half_face(TetId t, int i) {
    return HalfFaceId(4 * t.value() + static_cast<std::uint32_t>(i));
  }
  [[nodiscard]] static TetId tet_of(HalfFaceId h) { return TetId(h.value() >> 2); }
  [[nodiscard]] static int face_of(HalfFaceId h) { return static_cast<int>(h.value() & 3U); }
  [[nodiscard]] HalfFaceId opposite(HalfFaceId h) const { return opposite_[h.index()]; }
  /// The tet across face i of t, or invalid on the boundary.
  [[nodiscard]] TetId neighbour(TetId t, int i) const {
    const HalfFaceId h = opposite(half_face(t, i));
    return h.valid() ? tet_of(h) : TetId();
  }
  /// All of these by half-face, without a copy; valid until the mesh changes.
  [[nodiscard]] std::span<const HalfFaceId> opposites() const { return opposite_; }
  /// The vertices of all tet slots likewise; of dead ones the first is invalid.
  [[nodiscard]] std::span<const TetVertices> tets() const { return tets_; }
  /// The vertices of a half-face, normal pointing out of its tet.
  [[nodiscard]] TriangleVertices face_vertices(HalfFaceId h) const {
    return tetloft::face_of(vertices(tet_of(h)), face_of(h));
  }
  /// Local index of v in t, or −1.
  [[nodiscard]] int index_in(TetId t, VertexId v) const;
  /// Some tet of v, or invalid if v is in no tet.
  [[nodiscard]] TetId any_tet(VertexId v) const {
    const HalfFaceId c = first_corner(v);
    return c.valid() ? tet_of(c) : TetId();
  }
  /// The corners of v, that is the half-faces opposite it, one in each of its tets: for loops over
  /// a star that must not allocate. By tet id until the first edit, then in no particular order.
  [[nodiscard]] CornerRange corners(VertexId v) const {
    const CornerLists& lists = corner_lists();
    return {lists.next.data(), lists.first[v.index()]};
  }
  /// One of them, invalid if v is in no tet; the others follow in a circular list.
  [[nodiscard]] HalfFaceId first_corner(VertexId v) const {
    return corner_lists().first[v.index()];
  }
  /// The next half-face opposite the same vertex.
  [[nodiscard]] HalfFaceId next_corner(HalfFaceId c) const {
    return corner_lists().next[c.index()];
  }

  /// The tets of v, also where v is singular (several face-connected sheets), by id.
  [[nodiscard]] std::vector<TetId> star(VertexId v) const;
  /// The tets that contain both ends, by id.
  [[nodiscard]] std::vector<TetId> star(VertexId a, VertexId b) const;
  /// The one or two tets of a face, the half-face's own first.
  [[nodiscard]] std::vector<TetId> star(HalfFaceId h) const;
  /// The tets around edge (a, b), counter-clockwise about a → b in a positive mesh: in
  /// cyclic order starting at `start`, or along the path from boundary to boundary that
  /// contains it. Throws std::invalid_argument unless `start` contains a and b.
  [[nodiscard]] std::vector<TetId> ring(VertexId a, VertexId b, TetId start) const;
  /// The same into `ring`, which is overwritten; true iff it is a cycle.
  bool ring(VertexId a, VertexId b, TetId start, std::vector<TetId>& ring) const;

  /// The triangles opposite v in its star, outward normals away from v, by tet id.
  [[nodiscard]] std::vector<TriangleVertices> link(VertexId v) const;
  /// The edges opposite (a, b) in its star, by tet id.
  [[nodiscard]] std::vector<std::array<VertexId, 2>> link(VertexId a, VertexId b) const;
  /// The one or two vertices opposite a face.
  [[nodiscard]] std::vector<VertexId> link(HalfFaceId h) const;

  [[nodiscard]] LinkKind classify_link(VertexId v) const;
  [[nodiscard]] LinkKind classify_link(VertexId a, VertexId b) const;
  /// Every vertex whose link is neither empty nor regular, by id, with its kind.
  [[nodiscard]] std::vector<std::pair<VertexId, LinkKind>> singular_vertices() const;

  /// The half-faces without opposite, by id.
  [[nodiscard]] std::vector<HalfFaceId> boundary() const;
  /// Face-connected components of tets, numbered by their first tet; index = tet slot,
  /// invalid for dead slots.
  [[nodiscard]] IdVector<TetId, ComponentId> components() const;

  /// Adds vertices without tets; returns the first.
  VertexId add_vertices(std::size_t n);
  /// Adds a tet and glues it to existing half-faces with the same vertices that are free
  /// and oriented the other way. Linear in the star of its vertices. Refused as from_tets.
  Result<TetId> add_tet(const TetVertices& tet);
  /// Removes a tet; its neighbours get boundary faces. Its slot may be reused. Constant
  /// time, amortised.
  void remove_tet(TetId t);
  /// Removes dead slots, keeping order. Returns new ids by old slot (invalid for dead).
  IdVector<TetId, TetId> compact();

  /// The violated conditions, in this order, one entry each that names the first offender
  /// and how many there are; empty if all hold.
  /// 1 every live tet has four distinct vertices in range
  /// 2 opposite is an involution between live half-faces
  /// 3 opposite half-faces have the same vertices, oppositely oriented
  /// 4 no face has three half-faces, and two of one face are each other's opposite
  /// 5 the corner list of v holds exactly the corners of v; any_tet(v) is invalid iff none
  /// 6 the free list holds exactly the dead slots
  [[nodiscard]] std::vector<MeshViolation> validate() const;

 private:
  friend struct TetMeshTestAccess;  // lets tests break single conditions

  void require_vertex(VertexId v) const;
  void require_live(TetId t) const;
  [[nodiscard]] VertexId corner_vertex(HalfFaceId c) const { return vertex(tet_of(c), face_of(c)); }
  [[nodiscard]] const CornerLists& corner_lists() const {
    const CornerLists* made = corner_lists_.made();
    return made != nullptr ? *made : editable_corner_lists();
  }
  // Makes them where they are not made. What is const is that they say nothing new.
  CornerLists& editable_corner_lists() const;
  [[nodiscard]] CornerLists make_corner_lists() const;
  // One more in the arrays of tets and corners.
  void add_slot(CornerLists& lists);
  void insert_corner(CornerLists& lists, HalfFaceId c);
  void erase_corner(CornerLists& lists, HalfFaceId c);
  void check_corner_lists(std::vector<MeshViolation>& violations) const;
  void check_free_list(std::vector<MeshViolation>& violations) const;
  // The half-face that face i of a new tet is to be glued to, invalid if there is none.
  [[nodiscard]] Result<HalfFaceId> find_partner(const TetVertices& tet, std::size_t i) const;
  // Of the given vertices one with the fewest tets, found in time linear in that number.
  [[nodiscard]] VertexId smallest_star(std::span<const VertexId> candidates) const;

  // tets_[t][i]; [0] is invalid in a dead slot.
  std::vector<TetVertices> tets_;
  // opposite_[4 t + i]; invalid on the boundary and in dead slots.
  std::vector<HalfFaceId> opposite_;
  std::size_t vertex_count_ = 0;
  // Made by const functions: mutable.
  mutable CornerListsOnDemand corner_lists_;
  // Dead slots, last freed last.
  std::vector<TetId> free_;
};

/// Topology of one closed triangulated surface component.
struct SurfaceTopology {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t triangles = 0;
  [[nodiscard]] long euler() const {
    return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(triangles);
  }
  /// Genus of a closed orientable surface: χ = 2 − 2 g.
  [[nodiscard]] long genus() const { return (2 - euler()) / 2; }
};

/// The components of a surface, triangles connected through shared edges, numbered by
/// their first triangle; component[i] is the component of triangle i. An edge of more than
/// two triangles connects all of them. A vertex of several components counts in each.
struct SurfaceComponents {
  std::vector<std::uint32_t> component;
  std::vector<SurfaceTopology> topology;
};
/// Linear in the triangles and the largest vertex id. Takes fewer than 2^32 / 3 triangles.
[[nodiscard]] TETLOFT_API SurfaceComponents
surface_components(std::span<const TriangleVertices> triangles);

}  // namespace tetloft
