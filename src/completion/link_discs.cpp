#include "completion/link_discs.hpp"

#include <array>
#include <bit>
#include <limits>
#include <vector>

namespace tetloft::internal {

namespace {

// The edge that face i of a tet is in the link of corner c, by c and i: corners of the tet, in the
// order of a boundary around the triangle opposite c.
struct EdgeInLink {
  std::uint8_t from = 0;
  std::uint8_t to = 0;
};

constexpr std::array<std::array<EdgeInLink, 4>, 4> edges_in_links() {
  std::array<std::array<EdgeInLink, 4>, 4> edges{};
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<int, 3>& link = kFaceVertex[c];
      edges[c][static_cast<std::size_t>(link[k])] = {static_cast<std::uint8_t>(link[(k + 1) % 3]),
                                                     static_cast<std::uint8_t>(link[(k + 2) % 3])};
    }
  }
  return edges;
}

// The boundary of the kept tets in the link of each vertex, as a list of edges. A vertex of a slab
// is on the hull of D, and its link a disc; what has one simple cycle as its boundary in a disc is
// all that is inside it, hence a disc.
class LinkBoundaries {
 public:
  LinkBoundaries(const Slab& slab, const IdVector<TetId, std::uint8_t>& kept)
      : slab_(slab),
        kept_(kept),
        first_(slab.vertex_count(), kNone),
        step_from_(slab.vertex_count()) {
    edges_.reserve(kLikelyEdges * slab.vertex_count());
    for (const TetId t : slab.tets()) {
      if (kept[t] != 0) add_boundary(t);
    }
  }

  [[nodiscard]] bool is_one_cycle(SlabVertexId p) {
    std::size_t edges = 0;
    SlabVertexId start;
    for (std::uint32_t k = first_[p]; k != kNone; k = edges_[k].next) {
      start = edges_[k].from;
      Step& step = step_from_[start];
      if (step.around == p) return false;  // a pinch
      step = {p, edges_[k].to};
      ++edges;
    }
    if (edges == 0) return false;
    // As many edges of a boundary lead to a vertex as from it: cycles, if there is no pinch.
    std::size_t steps = 1;
    for (SlabVertexId v = step_from_[start].to; v != start; v = step_from_[v].to) ++steps;
    return steps == edges;
  }

 private:
  struct Edge {
    std::uint32_t next;  // of the same vertex
    SlabVertexId from;
    SlabVertexId to;
  };
  struct Step {
    SlabVertexId around;  // of whose link
    SlabVertexId to;
  };
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  // The link of a vertex of a smooth solid has about six.
  static constexpr std::size_t kLikelyEdges = 7;

  void add_boundary(TetId t) {
    static constexpr auto kEdges = edges_in_links();
    for (int i = 0; i < 4; ++i) {
      for (unsigned open = kept_here_only(t, i); open != 0; open &= open - 1) {
        const int c = std::countr_zero(open);
        const EdgeInLink& edge = kEdges[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)];
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
      if (has_corner(kept_[across], slab_.index_in(across, slab_.vertex(t, c)))) {
        here_only &= ~(1U << c);
      }
    }
    return here_only;
  }

  const Slab& slab_;
  const IdVector<TetId, std::uint8_t>& kept_;
  std::vector<Edge> edges_;
  IdVector<SlabVertexId, std::uint32_t> first_;  // of its edges
  IdVector<SlabVertexId, Step> step_from_;       // in the link looked at last that has the vertex
};

}  // namespace

IdVector<SlabVertexId, std::uint8_t> link_discs(const Slab& slab,
                                                const IdVector<TetId, std::uint8_t>& kept) {
  LinkBoundaries boundaries(slab, kept);
  IdVector<SlabVertexId, std::uint8_t> disc;
  disc.reserve(slab.vertex_count());
  for (const SlabVertexId v : slab.vertices()) disc.push_back(boundaries.is_one_cycle(v) ? 1 : 0);
  return disc;
}

}  // namespace tetloft::internal
