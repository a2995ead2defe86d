// Completion (CUT): adds external and redundant tets to the seed until every own vertex is
// regular, and every class is connected.
//
// At each own vertex the *primary sheet* is the face-connected part of its kept star that
// holds its internal triangles; only there the class is attached. Other sheets are detached:
// truncation parts them from the vertex instead of bridging them. Rules, within the primary
// sheet, to a fixpoint, lowest vertex first, edges before links:
//   run   around an in-plane edge, or a cross edge on the hull: the attached tets form one
//         run (at a contour edge it starts at the internal triangle by itself)
//   gap   around an interior cross edge: at most one gap; the longest stays open (tie: the
//         one with the larger smallest tet id)
//   hole  the link of the sheet is a disc: complements that touch no hull facet are filled
// The sheet's link is then connected, without pinch, with connected complement in the
// sphere: a disc. Tets are only added, and keeping every tet with an own corner satisfies
// all rules; so it ends. At an edge with two own ends the attached sets of both ends are
// equal or disjoint.
//
// While a class is not connected through attached corners: *merge* a detached sheet with
// its vertex's primary sheet by a shortest path of tets; where there is none, *connect*:
// keep a tet at the shortest own–own edge of D between two parts.
//
// At last *convex filling*: stacked copies of a convex contour would lose their corners,
// which are redundant tets (CC). Such a tet is added if it lies on the region's side of both
// its contour edges and adding it is an elementary expansion: topology stays as it is.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "completion/complex.hpp"
#include "completion/link_boundary.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal {

/// A tet to be kept by a class, and the corners at which it has to be attached.
struct Wall {
  TetId tet;
  std::uint8_t corners = 0;
  ClassId id;
};

/// A class that stays in several parts, for D offers no edge to connect them.
struct LeftApart {
  ClassId id;
  std::vector<SlabRegionId> regions;  ///< of the class
};

class Completion {
 public:
  Completion(const Slab& slab, const SlabClasses& classes,
             const IdVector<ClassId, std::uint8_t>& active, Complex complex, RuleCounts& rules);

  /// Completes all active classes; returns those left in several parts.
  std::vector<LeftApart> run();

  /// Keeps further tets, attached as asked, and what the rules want besides. After run().
  void build(const std::vector<Wall>& walls);

  [[nodiscard]] const Slab& slab() const { return slab_; }
  [[nodiscard]] const SlabClasses& classes() const { return classes_; }

  /// Goes on from where a copy of this got to.
  void adopt(Completion&& trial);

  [[nodiscard]] Complex& complex() { return complex_; }
  [[nodiscard]] const Complex& complex() const { return complex_; }
  /// Tets looked at, as often as that was.
  [[nodiscard]] std::uint64_t work() const { return work_; }

 private:
  // A tet of the current vertex's star.
  struct Spoke {
    TetId tet;
    int corner;                        // of the current vertex
    std::array<std::int32_t, 4> next;  // spoke across face i; kHull; unused at `corner`
  };
  static constexpr std::int32_t kHull = -1;

  // The primary sheet as it appears in the link of its vertex.
  enum class LinkShape : std::uint8_t { disc, pinched, holed };

  // A detached sheet and the shortest way to its vertex's primary one.
  struct Merge {
    bool attached = false;  // the sheet reaches an attached corner of another part
    std::size_t length = 0;
    SlabVertexId vertex;
    TetId sheet;  // its lowest tet
    std::vector<TetId> path;
    [[nodiscard]] bool better_than(const Merge& other) const;
  };

  // The shortest ways from the primary sheet, by spoke: how long, and over which spoke before it.
  struct Ways {
    std::vector<std::uint32_t> distance;
    std::vector<std::uint32_t> from;
  };
  static constexpr std::uint32_t kUnreached = 0xFFFFFFFFU;

  // An own–own edge of D between two parts, in a tet that is not kept.
  struct Bridge {
    std::array<double, 3> extent{};
    double length = 0;  // squared, in a unit of its own
    TetId tet;
    std::array<SlabRegionId, 2> between;
  };

  // What the connecting of one class remembers from step to step: an offer gets better only
  // where the complex changes, and a bridge is never needed again once it is not.
  struct Connecting {
    ClassId id;
    std::span<const SlabVertexId> vertices;  // of the class, by id
    std::vector<Merge> offers;               // heap, best first, without paths; some outdated
    std::vector<Bridge> bridges;             // shortest first
    std::size_t next_bridge = 0;
    bool knows_bridges = false;
  };

  void enqueue(SlabVertexId v);
  void keep(TetId t, ClassId c);
  // The type-1 tet on an internal triangle at a region's vertex.
  [[nodiscard]] TetId tet_on_internal_triangle(SlabVertexId p) const;
  void settle_all();
  void attach_discs();
  void settle_queue();
  void settle_lowest();
  [[nodiscard]] LinkShape flood_sheet(SlabVertexId p);

  void find_star(SlabVertexId p);  // of a region
  void gather_star(SlabVertexId p);
  void find_primary_sheet(SlabVertexId p);  // of the star gathered
  bool fill_rings(SlabVertexId p);
  void fill_run(SlabVertexId p, SlabVertexId q);
  void fill_gaps();
  bool fill_holes(SlabVertexId p);
  void settle(SlabVertexId p);
  [[nodiscard]] bool in_sheet(TetId t) const { return seen_[t] == epoch_; }
  [[nodiscard]] bool spoke_kept(std::size_t k) const {
    return complex_.keeps(spokes_[k].tet, spokes_[k].corner);
  }

  void fill_convex();
  // Is it a CC tet not kept yet, all whose corners belong to one class, which is active?
  [[nodiscard]] bool may_be_redundant(TetId t) const;
  // Does a CC tet lie on the region's side of both its contour edges?
  [[nodiscard]] bool is_inside_contours(TetId t) const;
  [[nodiscard]] bool is_expansion(TetId t);
  [[nodiscard]] std::vector<TetId> convex_candidates();
  bool fill_where_convex(TetId t);
  void look_again_around(TetId t, std::vector<TetId>& higher, std::vector<TetId>& lower);

  // Unites the regions that attached corners of one tet are of. Is each class one part then?
  [[nodiscard]] bool unite_parts();
  [[nodiscard]] std::vector<LeftApart> connect_classes();
  bool connect_once(Connecting& connecting);
  [[nodiscard]] std::optional<Merge> best_merge(Connecting& connecting);
  [[nodiscard]] std::optional<Merge> offered_merge(SlabVertexId p);
  [[nodiscard]] Ways ways_from_primary() const;
  [[nodiscard]] std::optional<Merge> merge_of_sheet(SlabVertexId p, std::size_t start,
                                                    const Ways& ways,
                                                    std::vector<std::uint8_t>& visited);
  [[nodiscard]] std::optional<TetId> connecting_tet(Connecting& connecting) const;
  [[nodiscard]] std::vector<Bridge> bridges_of(const Connecting& connecting) const;
  void attach(TetId t, int corner);
  void unite_attached(TetId t, int corner);
  [[nodiscard]] std::vector<TetId> way_to_primary(TetId t, SlabVertexId p);
  void note_change(SlabVertexId v);

  const Slab& slab_;
  const SlabClasses& classes_;
  const IdVector<ClassId, std::uint8_t>& active_;
  Complex complex_;
  RuleCounts& rules_;

  // Regions united through attached corners: all tets attached at a vertex hang together, and
  // so do the attached corners of one tet for one class. Known while classes are connected.
  UnionFind parts_;
  // While classes are connected, the vertices of whose stars something changed; changed_[v]
  // while v is among them.
  bool note_changes_ = false;
  std::vector<SlabVertexId> changes_;
  IdVector<SlabVertexId, std::uint8_t> changed_;

  // Vertices to settle, lowest first; queued_[v] while v is among them.
  std::vector<SlabVertexId> heap_;
  IdVector<SlabVertexId, std::uint8_t> queued_;

  // While all are settled, where the kept tets are a disc in the link, and were so from the start.
  IdVector<SlabVertexId, std::uint8_t> disc_;
  // The primary sheet of the vertex that is settled: its corners in the order of the flood, by tet
  // the epoch, and its boundary in the link.
  std::vector<HalfFaceId> sheet_;
  std::vector<HalfFaceId> star_;
  IdVector<TetId, std::uint32_t> seen_;
  LinkBoundary boundary_;

  // The star of the current vertex, and its spokes by tet (meaningful for its tets only).
  std::vector<Spoke> spokes_;
  IdVector<TetId, std::int32_t> spoke_of_;
  std::vector<std::uint8_t> primary_;  // by spoke
  std::vector<std::uint32_t> stack_;
  std::vector<TetId> ring_;
  std::vector<TetId> to_keep_;
  std::uint32_t epoch_ = 0;
  // What convex filling knows of a tet, while it lasts: at first the number of its faces that are
  // in the complex. Rejected ones were no expansion when last looked at.
  enum : std::uint8_t { kNoFace, kFace, kFaces, kRejected = 8, kWaiting, kNoCandidate };
  IdVector<TetId, std::uint8_t> candidate_;
  std::uint64_t work_ = 0;
};

}  // namespace tetloft::internal
