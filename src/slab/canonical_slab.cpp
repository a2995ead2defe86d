#include "slab/canonical_slab.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/guard.hpp"
#include "sections/conforming_section.hpp"

namespace tetloft::internal {

namespace {

using delaunay3_detail::side_number;
using delaunay3_detail::side_of;
using delaunay3_detail::SlabTets;
using delaunay3_detail::TetSlot;
using delaunay3_detail::triangle_of;
using delaunay3_detail::TriangleSideId;

// The canonical places of a slot's four vertices.
using Places = std::array<std::uint8_t, 4>;
// Sorted, the last two exchanged where that was an odd permutation (struct Delaunay3).
enum Arrangement : std::uint32_t { kAsTheyAre, kBehindIsHigher, kSecondIsHigher };
constexpr std::array<Places, 3> kPlaces{{
    {0, 1, 2, 3},
    {1, 0, 3, 2},  // of type 2, {behind, ahead, left, right}
    {0, 3, 1, 2},  // of type 1 below, {s0, s1, s2, apex}
}};

// Where a slot goes: its tet, and how the vertices are arranged there.
class NewName {
 public:
  NewName() = default;
  NewName(std::uint32_t tet, Arrangement arrangement) : packed_(4 * tet + arrangement) {}
  [[nodiscard]] TetId tet() const { return TetId(packed_ / 4); }
  [[nodiscard]] HalfFaceId half_face(std::size_t i) const {
    return HalfFaceId((packed_ & ~3U) + kPlaces[packed_ & 3U][i]);
  }

 private:
  std::uint32_t packed_ = 0;
};

// Visits a section's triangles in the order of their sorted vertices, each with its lowest edge.
template <class Visit>
void for_each_triangle_sorted(const ConformingSection& section, const Visit& visit) {
  const auto third = [&](EdgeId e, TriangleId t) {
    const auto& v = section.triangulation.triangles[t];
    return std::max({v[0], v[1], v[2]}) > section.edges[e].b ? std::max({v[0], v[1], v[2]})
                                                             : PlaneVertexId();
  };
  for (const EdgeId e : section.edges.ids()) {
    std::array<TriangleId, 2> beside{section.edges[e].left, section.edges[e].right};
    for (TriangleId& t : beside) {
      // Of a triangle's edges that with its two lower vertices is its lowest.
      if (t.valid() && !third(e, t).valid()) t = TriangleId();
    }
    if (beside[0].valid() && beside[1].valid() && third(e, beside[1]) < third(e, beside[0])) {
      std::swap(beside[0], beside[1]);
    }
    for (const TriangleId t : beside) {
      if (t.valid()) visit(t, e);
    }
  }
}

class CanonicalSlab {
 public:
  CanonicalSlab(const ConformingSection& lower, const ConformingSection& upper,
                const SlabTets& tets)
      : lower_(lower),
        upper_(upper),
        slots_(tets.slots),
        bases_(tets.bases),
        edges_{sections::edges_of_sides(lower), sections::edges_of_sides(upper)},
        below_(lower.triangulation.triangles.size()),
        type1_(below_ + upper.triangulation.triangles.size()),
        name_(slots_.size()) {}

  SlabDelaunay run() {
    const std::vector<std::uint32_t> order = in_order_of_each_kind();
    number(order);
    SlabDelaunay result;
    result.mesh = renamed();
    result.base.resize(slots_.size());
    for (std::size_t k = 0; k < slots_.size(); ++k) result.base[name_[k].tet()] = bases_[k];
    result.edges = std::move(edges_);
    return result;
  }

 private:
  [[nodiscard]] EdgeId edge(bool upper, TriangleSideId side) const {
    return edges_[upper ? 1 : 0][triangle_of(side)][side_number(side)];
  }

  // The place of slots by their two lowest vertices: an edge of the lower plane, or an apex there,
  // which comes after all edges up from it.
  [[nodiscard]] std::size_t place_of_edge(EdgeId e) const {
    return e.index() + lower_.edges[e].a.index();
  }
  [[nodiscard]] std::size_t place_of_apex(VertexId v) const {
    return lower_.first_edge[v.index() + 1] + v.index();
  }

  // Slots of one kind after those of another, each such that those of one place are in order.
  std::vector<std::uint32_t> in_order_of_each_kind() {
    place_.resize(slots_.size());
    std::vector<std::uint32_t> order;
    order.reserve(slots_.size());
    const auto slot_of = [&](std::size_t first, std::size_t last, bool upper) {
      IdVector<TriangleId, std::uint32_t> slots(last - first);
      for (std::size_t k = first; k < last; ++k) {
        slots[triangle_of(upper ? bases_[k].upper : bases_[k].lower)] =
            static_cast<std::uint32_t>(k);
      }
      return slots;
    };
    const auto slot_below = slot_of(0, below_, false);
    for_each_triangle_sorted(lower_, [&](TriangleId t, EdgeId e) {
      place_[slot_below[t]] = static_cast<std::uint32_t>(place_of_edge(e));
      order.push_back(slot_below[t]);
    });
    append_by_upper_edge(order);
    const auto slot_above = slot_of(below_, type1_, true);
    for_each_triangle_sorted(upper_, [&](TriangleId t, EdgeId) {
      const std::uint32_t k = slot_above[t];
      place_[k] = static_cast<std::uint32_t>(place_of_apex(slots_[k].vertices[0]));
      order.push_back(k);
    });
    return order;
  }

  void append_by_upper_edge(std::vector<std::uint32_t>& order) {
    std::vector<EdgeId> above(slots_.size() - type1_);
    std::vector<std::uint32_t> begin(upper_.edges.size() + 1, 0);
    for (std::size_t k = type1_; k < slots_.size(); ++k) {
      above[k - type1_] = edge(true, bases_[k].upper);
      ++begin[above[k - type1_].index() + 1];
    }
    for (std::size_t e = 0; e < upper_.edges.size(); ++e) begin[e + 1] += begin[e];
    const std::size_t first = order.size();
    order.resize(first + above.size());
    for (std::size_t k = type1_; k < slots_.size(); ++k) {
      order[first + begin[above[k - type1_].index()]++] = static_cast<std::uint32_t>(k);
      place_[k] = static_cast<std::uint32_t>(place_of_edge(edge(false, bases_[k].lower)));
    }
  }

  void number(const std::vector<std::uint32_t>& order) {
    TETLOFT_CHECK(order.size() == slots_.size());
    std::vector<std::uint32_t> next(lower_.edges.size() + lower_.vertex_count() + 1, 0);
    for (const std::uint32_t place : place_) ++next[place + 1];
    for (std::size_t p = 1; p < next.size(); ++p) next[p] += next[p - 1];
    for (const std::uint32_t k : order) name_[k] = {next[place_[k]]++, arrangement(k)};
  }

  [[nodiscard]] Arrangement arrangement(std::size_t k) const {
    const TetVertices& v = slots_[k].vertices;
    if (k < below_) return v[2] < v[1] ? kSecondIsHigher : kAsTheyAre;
    return k >= type1_ && v[1] < v[0] ? kBehindIsHigher : kAsTheyAre;
  }

  [[nodiscard]] TetMesh renamed() const {
    std::vector<TetVertices> tets(slots_.size());
    std::vector<HalfFaceId> opposite(4 * slots_.size());
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      const TetSlot& slot = slots_[k];
      for (std::size_t i = 0; i < 4; ++i) {
        const HalfFaceId h = name_[k].half_face(i);
        tets[h.index() / 4][h.index() % 4] = slot.vertices[i];
        const HalfFaceId across = slot.opposite[i];
        if (!across.valid()) continue;
        opposite[h.index()] =
            name_[across.index() / 4].half_face(static_cast<std::size_t>(TetMesh::face_of(across)));
      }
    }
    return TetMesh::from_adjacency(lower_.vertex_count() + upper_.vertex_count(), std::move(tets),
                                   std::move(opposite));
  }

  const ConformingSection& lower_;
  const ConformingSection& upper_;
  const std::vector<TetSlot>& slots_;
  const std::vector<TetBase>& bases_;
  std::array<EdgesOfSides, 2> edges_;
  // Slots are type 1 below, then type 1 above, then type 2.
  std::size_t below_;
  std::size_t type1_;
  std::vector<std::uint32_t> place_;
  std::vector<NewName> name_;
};

TriangleSideId side_with(const EdgesOfSides& edges, const ConformingSection& section, EdgeId e) {
  const ConformingSection::Edge& edge = section.edges[e];
  const TriangleId t = edge.left.valid() ? edge.left : edge.right;
  std::size_t i = 0;
  while (edges[t][i] != e) ++i;
  return side_of(t, i);
}

}  // namespace

SlabDelaunay canonical_slab(const ConformingSection& lower, const ConformingSection& upper,
                            const delaunay3_detail::SlabTets& tets) {
  return CanonicalSlab(lower, upper, tets).run();
}

SlabDelaunay with_bases(const ConformingSection& lower, const ConformingSection& upper,
                        TetMesh mesh) {
  SlabDelaunay result;
  result.edges = {sections::edges_of_sides(lower), sections::edges_of_sides(upper)};
  result.base.resize(mesh.tet_slots());
  for (const TetId t : result.base.ids()) {
    std::array<std::array<PlaneVertexId, 4>, 2> corner;
    std::array<std::size_t, 2> corners{};
    for (const VertexId v : mesh.vertices(t)) {
      const std::size_t plane = v.index() < lower.vertex_count() ? 0 : 1;
      corner[plane][corners[plane]++] =
          PlaneVertexId(v.index() - (plane == 1 ? lower.vertex_count() : 0));
    }
    const auto base_in = [&](std::size_t plane) -> TriangleSideId {
      const ConformingSection& section = plane == 1 ? upper : lower;
      const auto& [a, b, c, d] = corner[plane];
      if (corners[plane] == 2) {
        return side_with(result.edges[plane], section, section.find_edge(a, b));
      }
      return corners[plane] == 3 ? side_of(section.find_triangle(a, b, c), 0) : TriangleSideId();
    };
    result.base[t] = {base_in(0), base_in(1)};
  }
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace tetloft::internal
