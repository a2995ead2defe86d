#include "completion/link_discs.hpp"

#include <bit>
#include <limits>
#include <vector>

#include "completion/link_boundary.hpp"

namespace tetloft::internal {

namespace {

// The boundary of what is kept, in the links of all vertices at once.
class LinkBoundaries {
 public:
  LinkBoundaries(const Slab& slab, const IdVector<TetId, std::uint8_t>& kept)
      : slab_(slab), kept_(kept), first_(slab.vertex_count(), kNone) {
    edges_.reserve(kLikelyEdges * slab.vertex_count());
    for (const TetId t : slab.tets()) {
      if (kept[t] != 0) add_boundary(t);
    }
  }

  void copy_to(LinkBoundary& boundary, SlabVertexId v) const {
    boundary.clear();
    for (std::uint32_t k = first_[v]; k != kNone; k = edges_[k].next) {
      boundary.add(edges_[k].from, edges_[k].to);
    }
  }

 private:
  struct Edge {
    std::uint32_t next;  // in the link of the same vertex
    SlabVertexId from;
    SlabVertexId to;
  };
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  // A vertex of a smooth solid has about six.
  static constexpr std::size_t kLikelyEdges = 7;

  void add_boundary(TetId t) {
    for (int i = 0; i < 4; ++i) {
      for (unsigned open = kept_here_only(t, i); open != 0; open &= open - 1) {
        const int c = std::countr_zero(open);
        const LinkEdge& edge = link_edge(c, i);
        std::uint32_t& first = first_[slab_.vertex(t, c)];
        edges_.push_back({first, slab_.vertex(t, edge.from), slab_.vertex(t, edge.to)});
        first = static_cast<std::uint32_t>(edges_.size() - 1);
      }
    }
  }

  // The corners of face i at which t is kept, and the tet across is not.
  [[nodiscard]] unsigned kept_here_only(TetId t, int i) const {
    const unsigned here = kept_[t] & ~(1U << i);
    const TetId across = slab_.mesh().neighbour(t, i);
    if (!across.valid() || kept_[across] == 0) return here;
    if (kept_[across] == kAllCorners) return 0;
    unsigned here_only = here;
    for (int c = 0; c < 4; ++c) {
      if (!has_corner(here, c)) continue;
      const int there = slab_.index_in(across, slab_.vertex(t, c));
      if (has_corner(kept_[across], there)) here_only &= ~(1U << c);
    }
    return here_only;
  }

  const Slab& slab_;
  const IdVector<TetId, std::uint8_t>& kept_;
  std::vector<Edge> edges_;
  IdVector<SlabVertexId, std::uint32_t> first_;  // edge in the link of a vertex; kNone
};

}  // namespace

IdVector<SlabVertexId, std::uint8_t> link_discs(const Slab& slab,
                                                const IdVector<TetId, std::uint8_t>& kept) {
  const LinkBoundaries boundaries(slab, kept);
  LinkBoundary boundary(slab.vertex_count());
  IdVector<SlabVertexId, std::uint8_t> disc;
  disc.reserve(slab.vertex_count());
  for (const SlabVertexId v : slab.vertices()) {
    boundaries.copy_to(boundary, v);
    disc.push_back(boundary.is_simple_cycle() ? 1 : 0);
  }
  return disc;
}

}  // namespace tetloft::internal
