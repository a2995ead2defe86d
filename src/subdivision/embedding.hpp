// Embedding: positions for the constructed nodes of a slab under which the solid is
// embedded, proven exactly in output coordinates.
//
// Proof. All pieces are positive by the exact predicate (whole ones are tets of D), and the
// boundary surface of the slab's solid has no contact with itself. The degree of the piecewise
// linear map from the abstract complex to space is locally constant off the image of the boundary;
// an embedded boundary and positive tets make it 0 or 1 everywhere, unless one component lies
// inside another or winds twice; but each component meets a section plane, and there only in its
// regions, which are disjoint and covered once. So no two tets overlap.
//
// Lemma: boundary triangles without a constructed node are not in contact with each other,
// and need no test. Each is a face of D: as a face of a piece cut from a tet of D, since its
// three nodes are corners of that tet; as the base of a prism, since the section's triangles
// are facets of D, which Slab checks one by one. Slab vertices never move. D is a
// triangulation, decided by exact predicates on the same stored points: its perturbation
// chooses among the triangulations of cospherical points and moves none of them, and D has
// no flat tets. Two faces of a triangulation meet in the simplex of their common vertices.
// What is left are the pairs with a constructed node in one triangle at least.
//
// Where a test fails, the constructed nodes it involves come closer to where they came
// from: cuts to their kept corner, lifted vertices to their plane, prisms get lower and
// are replaced by truncated caps at last. Where a piece is not positive, its cuts
// are squeezed first (cut_squeezing.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/result.hpp>

#include "contact/contact.hpp"
#include "subdivision/lifting.hpp"
#include "subdivision/prism.hpp"

namespace tetloft::internal {

/// A lone class and how it ends.
struct LoneEnd {
  ClassId id;
  SlabRegionId region;
  int level = 0;                        ///< prism of height gap / 2^(level + 1)
  static constexpr int kTruncated = 3;  ///< from this level on: a truncated cap
  [[nodiscard]] bool is_prism() const { return level < kTruncated; }
};

class Embedding {
 public:
  enum class Outcome {
    embedded,
    more_truncated,  ///< a lone class gave up its prism: complete it and start again
    failed,          ///< at() is the place
  };

  /// Keeps references to its arguments; `lifting` and `truncation` give way, `lone` has its
  /// levels raised.
  Embedding(const Slab& slab, const SlabClasses& classes, const Complex& complex,
            const Subdivision& subdivision, Lifting& lifting, Truncation& truncation,
            std::vector<LoneEnd>& lone, RuleCounts& rules);

  [[nodiscard]] Outcome settle();

  [[nodiscard]] const Point3& at() const { return at_; }
  [[nodiscard]] double smallest_lift() const { return lifting_.smallest_fraction(); }

  /// The result, once embedded: positions of all nodes, and all pieces but whole tets: by parent,
  /// then prisms.
  [[nodiscard]] const IdVector<NodeId, Point3>& points() const { return points_; }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  /// With whole tets, by parent; then prisms.
  [[nodiscard]] std::vector<Piece> all_pieces() const;
  /// The boundary of the solid, section planes included: triangles over nodes, oriented outwards.
  [[nodiscard]] const std::vector<TriangleVertices>& boundary() const { return boundary_; }
  /// Of a constructed node.
  [[nodiscard]] PointOrigin origin(NodeId node) const;
  /// Seconds spent in contact tests.
  [[nodiscard]] double contact_seconds() const { return contact_seconds_; }
  /// Pieces and pairs of triangles tested.
  [[nodiscard]] std::uint64_t work() const { return work_; }

 private:
  // What a test found fault with.
  struct Blame {
    std::vector<LiftedId> lifted;
    std::vector<CutId> cuts;
    std::vector<std::size_t> prisms;  // by index into lone_
    [[nodiscard]] bool empty() const { return lifted.empty() && cuts.empty() && prisms.empty(); }
  };

  void add_prisms();
  void collect_boundary();
  void add_to_boundary(const std::array<NodeId, 4>& tet, int face);
  [[nodiscard]] bool may_meet_pieces(TetId t, int face) const;
  void place();
  void squeeze_bad_cuts();
  [[nodiscard]] Blame find_fault();
  [[nodiscard]] std::vector<Contact> boundary_contacts();
  void place_of(const std::vector<Contact>& contacts);
  [[nodiscard]] bool is_positive(const Piece& piece) const;
  // The boundary is handed to the contact tests with node k as vertex k.
  [[nodiscard]] static NodeId node_of(VertexId v) { return NodeId(v.value()); }
  void blame_node(NodeId node, Blame& blame) const;
  [[nodiscard]] Outcome give_way(Blame blame);

  const Slab& slab_;
  const SlabClasses& classes_;
  const Complex& complex_;
  const Subdivision& subdivision_;
  Truncation& truncation_;
  std::vector<LoneEnd>& lone_;
  RuleCounts& rules_;
  Lifting& lifting_;

  const Nodes nodes_;
  // Copies of region vertices on the far side of prisms.
  struct Cap {
    SlabVertexId of;
    std::size_t lone;  // index into lone_
  };
  IdVector<CapId, Cap> caps_;
  std::vector<Piece> pieces_;
  std::vector<TriangleVertices> boundary_;
  IdVector<NodeId, Point3> points_;
  // Where the points were when contacts were last looked for, none before; and, by boundary
  // triangle, whether it had a contact then.
  IdVector<NodeId, Point3> tested_;
  std::vector<std::uint8_t> in_contact_;
  Point3 at_;
  double contact_seconds_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace tetloft::internal
