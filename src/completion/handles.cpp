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
  explicit HandleFiller(ComplexState& state)
      : state_(state),
        groups_(state.groups()),
        slab_(state.completion().slab()),
        classes_(state.completion().classes()) {}

  std::uint64_t run() {
    std::uint64_t filled = 0;
    bool again = true;
    while (again && groups_.any_low(state_.sums())) {
      again = false;
      for (const Candidate& candidate : candidates(state_.sums())) {
        const std::int32_t gain = state_.try_walls({{candidate.tet, 0xF, candidate.id}});
        if (gain == 0) continue;
        filled += static_cast<std::uint64_t>(gain);
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
    const Complex& complex = state_.completion().complex();
    return std::any_of(ring_.begin(), ring_.end(), [&](TetId r) {
      return complex.is_attached(r, slab_.index_in(r, u)) &&
             complex.is_attached(r, slab_.index_in(r, v));
    });
  }

  // What closing a tet adds to the Euler characteristic, by itself.
  [[nodiscard]] int gain(const VoidSpace& space, TetId t) {
    int gain = -1;
    for (int i = 0; i < 4; ++i) {
      const HalfFaceId h = slab_.mesh().opposite(TetMesh::half_face(t, i));
      const bool has_face =
          space.is_closed(t, 0xFU & ~(1U << i)) ||
          (h.valid() && space.is_closed(TetMesh::tet_of(h), 0xFU & ~(1U << TetMesh::face_of(h))));
      gain += has_face ? 0 : 1;
    }
    for (const auto& [i, j] : kEdgeVertex) gain -= has_edge(t, i, j) ? 0 : 1;
    return gain;
  }

  // Tets of one class that are not closed, and would close a tunnel.
  [[nodiscard]] std::vector<Candidate> candidates(const ChiGroups::Sums& sums) {
    std::vector<Candidate> result;
    const VoidSpace space(slab_, classes_, state_.voids(), state_.completion().complex());
    for (const TetId t : slab_.tets()) {
      const ClassId c = classes_.of(slab_.vertex(t, 0));
      if (!groups_.is_low(c, sums) || !space.of_one_class(t, 0xF) || !space.is_void(t)) continue;
      if (gain(space, t) > 0) result.push_back({size(t), t, c});
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

  ComplexState& state_;
  const ChiGroups& groups_;
  const Slab& slab_;
  const SlabClasses& classes_;
  std::vector<TetId> ring_;
};

}  // namespace

std::uint64_t fill_handles(ComplexState& state) { return HandleFiller(state).run(); }

const ChiGroups::Sums& ComplexState::sums() {
  if (!sums_) sums_ = groups_.sums(completion_.complex());
  return *sums_;
}

const std::vector<SlabVoidId>& ComplexState::joined() {
  if (!joined_) {
    joined_ =
        joined_voids(completion_.slab(), completion_.classes(), voids_, completion_.complex());
  }
  return *joined_;
}

std::int32_t ComplexState::try_walls(const std::vector<Wall>& walls) {
  Completion trial = completion_;
  trial.build(walls);
  ChiGroups::Sums after = groups_.sums(trial.complex());
  const std::int32_t gain = groups_.deviation(sums()) - groups_.deviation(after);
  if (gain <= 0) return 0;
  if (joined_voids(trial.slab(), trial.classes(), voids_, trial.complex()) != joined()) return 0;
  completion_.adopt(std::move(trial));
  sums_ = std::move(after);
  return gain;
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
