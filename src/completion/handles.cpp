#include "completion/handles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "completion/attached_chi.hpp"
#include "completion/void_space.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal {

namespace {

class HandleFiller {
 public:
  HandleFiller(const Slab& slab, const SlabClasses& classes,
               const IdVector<ClassId, std::uint8_t>& active, const SlabVoids& voids,
               const std::vector<ChiRange>& groups, Completion& completion)
      : slab_(slab),
        classes_(classes),
        active_(active),
        voids_(voids),
        groups_(groups),
        completion_(completion),
        group_of_(classes.class_count(), kNoGroup) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (const ClassId c : groups[g].classes) group_of_[c] = g;
    }
  }

  std::uint64_t run() {
    std::uint64_t filled = 0;
    IdVector<ClassId, std::int32_t> chi = chi_of(completion_);
    if (!any_missing(chi)) return 0;
    std::vector<std::size_t> joined = joined_voids(completion_);
    bool again = true;
    while (again && any_missing(chi)) {
      again = false;
      for (const Candidate& candidate : candidates(chi)) {
        Completion trial = completion_;
        trial.build({{candidate.tet, 0xF, candidate.id}});
        const IdVector<ClassId, std::int32_t> after = chi_of(trial);
        if (deviation(after) >= deviation(chi)) continue;
        if (joined_voids(trial) != joined) continue;
        completion_.adopt(std::move(trial));
        filled += static_cast<std::uint64_t>(deviation(chi) - deviation(after));
        chi = after;
        again = true;
        break;
      }
    }
    return filled;
  }

 private:
  static constexpr std::size_t kNoGroup = static_cast<std::size_t>(-1);
  struct Candidate {
    double area;
    TetId tet;
    ClassId id;
  };

  [[nodiscard]] IdVector<ClassId, std::int32_t> chi_of(const Completion& completion) const {
    return attached_chi(slab_, classes_, active_, completion.complex());
  }
  [[nodiscard]] std::int32_t sum(std::size_t g, const IdVector<ClassId, std::int32_t>& chi) const {
    std::int32_t total = 0;
    for (const ClassId c : groups_[g].classes) total += chi[c];
    return total;
  }
  [[nodiscard]] bool is_missing(std::size_t g, const IdVector<ClassId, std::int32_t>& chi) const {
    return sum(g, chi) < groups_[g].least;
  }
  [[nodiscard]] bool any_missing(const IdVector<ClassId, std::int32_t>& chi) const {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (is_missing(g, chi)) return true;
    }
    return false;
  }
  [[nodiscard]] std::int32_t deviation(const IdVector<ClassId, std::int32_t>& chi) const {
    std::int32_t total = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const std::int32_t got = sum(g, chi);
      total += std::max({0, groups_[g].least - got, got - groups_[g].most});
    }
    return total;
  }

  // Which voids hang together, each by the lowest.
  [[nodiscard]] std::vector<std::size_t> joined_voids(const Completion& completion) const {
    const VoidSpace space(slab_, classes_, voids_, completion.complex());
    UnionFind sets(voids_.void_count());
    sets.unite(voids_.exterior(false).index(), voids_.exterior(true).index());
    IdVector<TetId, std::uint8_t> seen(slab_.tet_count(), 0);
    for (const TetId t : slab_.tets()) {
      if (seen[t] != 0 || !space.is_void(t)) continue;
      SlabVoidId first;
      for (const TetId u : space.part_of(t, seen)) {
        space.for_each_contact(u, [&](const VoidContact& contact) {
          if (!first.valid()) first = contact.with;
          sets.unite(first.index(), contact.with.index());
        });
      }
    }
    std::vector<std::size_t> leaders;
    for (std::size_t v = 0; v < sets.size(); ++v) leaders.push_back(sets.find(v));
    return leaders;
  }

  [[nodiscard]] bool in_complex(TetId t, int i, int j) const {
    const SlabVertexId u = slab_.vertex(t, i);
    const SlabVertexId v = slab_.vertex(t, j);
    std::vector<TetId> ring;
    slab_.ring(u, v, t, ring);
    const Complex& complex = completion_.complex();
    return std::any_of(ring.begin(), ring.end(), [&](TetId r) {
      return complex.is_attached(r, slab_.index_in(r, u)) &&
             complex.is_attached(r, slab_.index_in(r, v));
    });
  }

  // Tets of one class that are not closed: adding one closes what it lacks.
  [[nodiscard]] std::vector<Candidate> candidates(
      const IdVector<ClassId, std::int32_t>& chi) const {
    std::vector<Candidate> result;
    const VoidSpace space(slab_, classes_, voids_, completion_.complex());
    for (const TetId t : slab_.tets()) {
      const ClassId c = classes_.of(slab_.vertex(t, 0));
      if (active_[c] == 0 || group_of_[c] == kNoGroup || !is_missing(group_of_[c], chi)) continue;
      if (!space.of_one_class(t, 0xF) || !space.is_void(t)) continue;
      std::int32_t gain = -1;
      for (int i = 0; i < 4; ++i) {
        const TetId across = slab_.mesh().neighbour(t, i);
        bool shared = space.is_closed(t, 0xFU & ~(1U << i));
        if (!shared && across.valid()) {
          const HalfFaceId h = slab_.mesh().opposite(TetMesh::half_face(t, i));
          shared = space.is_closed(across, 0xFU & ~(1U << TetMesh::face_of(h)));
        }
        gain += shared ? 0 : 1;
      }
      for (const auto& [i, j] : kEdgeVertex) gain -= in_complex(t, i, j) ? 0 : 1;
      if (gain < 1) continue;
      result.push_back({size(t), t, c});
    }
    std::sort(result.begin(), result.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.area, a.tet) < std::tie(b.area, b.tet);
    });
    return result;
  }

  // The largest extent of a tet in the plane.
  [[nodiscard]] double size(TetId t) const {
    double largest = 0;
    for (const auto& [i, j] : kEdgeVertex) {
      const Point3 p = slab_.point(slab_.vertex(t, i));
      const Point3 q = slab_.point(slab_.vertex(t, j));
      largest = std::max({largest, std::abs(p.x - q.x), std::abs(p.y - q.y)});
    }
    return largest;
  }

  const Slab& slab_;
  const SlabClasses& classes_;
  const IdVector<ClassId, std::uint8_t>& active_;
  const SlabVoids& voids_;
  const std::vector<ChiRange>& groups_;
  Completion& completion_;
  IdVector<ClassId, std::size_t> group_of_;
};

}  // namespace

std::uint64_t fill_handles(const Slab& slab, const SlabClasses& classes,
                           const IdVector<ClassId, std::uint8_t>& active, const SlabVoids& voids,
                           const std::vector<ChiRange>& groups, Completion& completion) {
  return HandleFiller(slab, classes, active, voids, groups, completion).run();
}

}  // namespace tetloft::internal
