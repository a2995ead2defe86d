#include "completion/handles.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "completion/void_space.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal {

namespace {

class HandleFiller {
 public:
  HandleFiller(const ChiGroups& groups, const SlabVoids& voids, Completion& completion,
               ComplexShape& shape)
      : sums_(shape.sums),
        joined_(shape.joined),
        groups_(groups),
        voids_(voids),
        completion_(completion),
        slab_(completion.slab()),
        classes_(completion.classes()) {}

  std::uint64_t run() {
    std::uint64_t filled = 0;
    bool again = true;
    while (again && groups_.any_low(sums_)) {
      again = false;
      for (const Candidate& candidate : candidates()) {
        Completion trial = completion_;
        trial.build({{candidate.tet, 0xF, candidate.id}});
        const ChiGroups::Sums after = groups_.sums(trial.complex());
        const std::int32_t gain = groups_.deviation(sums_) - groups_.deviation(after);
        if (gain <= 0) continue;
        if (joined_voids(slab_, classes_, voids_, trial.complex()) != joined_) continue;
        completion_.adopt(std::move(trial));
        filled += static_cast<std::uint64_t>(gain);
        sums_ = after;
        again = true;
        break;
      }
    }
    return filled;
  }

 private:
  struct Candidate {
    double size;
    TetId tet;
    ClassId id;
  };

  [[nodiscard]] bool has_edge(TetId t, int i, int j) {
    const SlabVertexId u = slab_.vertex(t, i);
    const SlabVertexId v = slab_.vertex(t, j);
    slab_.ring(u, v, t, ring_);
    const Complex& complex = completion_.complex();
    return std::any_of(ring_.begin(), ring_.end(), [&](TetId r) {
      return complex.is_attached(r, slab_.index_in(r, u)) &&
             complex.is_attached(r, slab_.index_in(r, v));
    });
  }

  // Does closing a tet, by itself, add to the Euler characteristic? It adds faces that are not
  // there yet, less edges that are not, less the tet. Edges of faces that are there are there as
  // well.
  [[nodiscard]] bool gains(const VoidSpace& space, TetId t) {
    unsigned faces = 0;
    int faces_added = 0;
    for (int i = 0; i < 4; ++i) {
      const HalfFaceId h = slab_.mesh().opposite(TetMesh::half_face(t, i));
      const bool has_face =
          space.is_closed(t, 0xFU & ~(1U << i)) ||
          (h.valid() && space.is_closed(TetMesh::tet_of(h), 0xFU & ~(1U << TetMesh::face_of(h))));
      faces |= has_face ? 1U << i : 0U;
      faces_added += has_face ? 0 : 1;
    }
    int gain = faces_added - 1;
    for (const auto& [i, j] : kEdgeVertex) {
      if (gain <= 0) return false;
      const unsigned around = 0xFU & ~(1U << i) & ~(1U << j);
      if ((faces & around) == 0 && !has_edge(t, i, j)) --gain;
    }
    return gain > 0;
  }

  // Tets of one class that are not closed, and would close a tunnel.
  [[nodiscard]] std::vector<Candidate> candidates() {
    std::vector<Candidate> result;
    const VoidSpace space(slab_, classes_, voids_, completion_.complex());
    for (const TetId t : slab_.tets()) {
      const ClassId c = classes_.of(slab_.vertex(t, 0));
      if (!groups_.is_low(c, sums_) || !space.of_one_class(t, 0xF) || !space.is_void(t)) continue;
      if (gains(space, t)) result.push_back({size(t), t, c});
    }
    std::sort(result.begin(), result.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.size, a.tet) < std::tie(b.size, b.tet);
    });
    return result;
  }

  // The largest extent of a tet along an axis of the plane.
  [[nodiscard]] double size(TetId t) const {
    double largest = 0;
    for (const auto& [i, j] : kEdgeVertex) {
      const Point3 p = slab_.point(slab_.vertex(t, i));
      const Point3 q = slab_.point(slab_.vertex(t, j));
      largest = std::max({largest, std::abs(p.x - q.x), std::abs(p.y - q.y)});
    }
    return largest;
  }

  ChiGroups::Sums& sums_;
  const std::vector<SlabVoidId>& joined_;
  const ChiGroups& groups_;
  const SlabVoids& voids_;
  Completion& completion_;
  const Slab& slab_;
  const SlabClasses& classes_;
  std::vector<TetId> ring_;
};

}  // namespace

std::uint64_t fill_handles(const ChiGroups& groups, const SlabVoids& voids, Completion& completion,
                           ComplexShape& shape) {
  return HandleFiller(groups, voids, completion, shape).run();
}

std::vector<SlabVoidId> joined_voids(const Slab& slab, const SlabClasses& classes,
                                     const SlabVoids& voids, const Complex& complex) {
  if (voids.void_count() == 2) return {voids.exterior(false), voids.exterior(false)};
  const VoidSpace space(slab, classes, voids, complex);
  UnionFind sets(voids.void_count());
  sets.unite(voids.exterior(false).index(), voids.exterior(true).index());
  IdVector<TetId, std::uint8_t> seen(slab.tet_count(), 0);
  for (const TetId t : slab.tets()) {
    if (seen[t] != 0 || !space.is_void(t)) continue;
    SlabVoidId first;
    for (const TetId u : space.part_of(t, seen)) {
      space.for_each_contact(u, [&](const VoidContact& contact) {
        if (!first.valid()) first = contact.with;
        sets.unite(first.index(), contact.with.index());
      });
    }
  }
  std::vector<SlabVoidId> leaders;
  for (std::size_t v = 0; v < sets.size(); ++v) leaders.emplace_back(sets.find(v));
  return leaders;
}

}  // namespace tetloft::internal
