#include "completion/attached_chi.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace tetloft::internal {

namespace {

// Counts distinct edges, by class. Ends come tet by tet in canonical order, so that those of tets
// whose lowest vertex is an edge's lower end come in a row, after those of all tets that have it in
// another place: these wait in lists.
class EdgeCounter {
 public:
  EdgeCounter(const SlabClasses& classes, std::size_t vertices,
              IdVector<ClassId, std::int32_t>& edges)
      : classes_(classes), edges_(edges), waiting_(vertices, kNone), counted_(vertices) {}

  // To be called before the edges of a tet with this lowest vertex are added.
  void reach(SlabVertexId lowest) {
    for (; next_ <= lowest.index(); ++next_) {
      for (std::uint32_t k = waiting_[SlabVertexId(next_)]; k != kNone; k = others_[k].next) {
        count(SlabVertexId(next_), others_[k].upper);
      }
    }
  }
  void add(SlabVertexId lowest, SlabVertexId u, SlabVertexId v) {
    if (v < u) std::swap(u, v);
    if (u == lowest) {
      count(u, v);
      return;
    }
    others_.push_back({v, waiting_[u]});
    waiting_[u] = static_cast<std::uint32_t>(others_.size() - 1);
  }
  void finish() {
    if (!waiting_.empty()) reach(SlabVertexId(waiting_.size() - 1));
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  struct Other {
    SlabVertexId upper;
    std::uint32_t next;
  };

  void count(SlabVertexId u, SlabVertexId v) {
    if (counted_[v] == u) return;
    counted_[v] = u;
    ++edges_[classes_.of(u)];
  }

  const SlabClasses& classes_;
  IdVector<ClassId, std::int32_t>& edges_;
  IdVector<SlabVertexId, std::uint32_t> waiting_;  // by lower end: the first of others_
  std::vector<Other> others_;
  std::size_t next_ = 0;
  IdVector<SlabVertexId, SlabVertexId> counted_;  // by upper end: the last lower one
};

}  // namespace

IdVector<ClassId, std::int32_t> attached_chi(const Slab& slab, const SlabClasses& classes,
                                             const IdVector<ClassId, std::uint8_t>& active,
                                             const Complex& complex) {
  IdVector<ClassId, std::int32_t> chi(classes.class_count(), 0);
  for (const SlabVertexId p : slab.vertices()) chi[classes.of(p)] += active[classes.of(p)];
  IdVector<ClassId, std::int32_t> edges(classes.class_count(), 0);
  EdgeCounter counter(classes, slab.vertex_count(), edges);
  for (const TetId t : slab.tets()) {
    const unsigned attached = complex.attached[t];
    if ((attached & (attached - 1)) == 0) continue;  // no two corners
    const std::array<SlabVertexId, 4> v = slab.vertices(t);
    const std::array<ClassId, 4> c{classes.of(v[0]), classes.of(v[1]), classes.of(v[2]),
                                   classes.of(v[3])};
    counter.reach(v[0]);
    unsigned closed_edges = 0;
    for (const auto& [i, j] : kEdgeVertex) {
      const auto k = static_cast<std::size_t>(i);
      const auto l = static_cast<std::size_t>(j);
      if (!has_corner(attached, i) || !has_corner(attached, j) || c[k] != c[l]) continue;
      ++closed_edges;
      counter.add(v[0], v[k], v[l]);
    }
    if (closed_edges < 3) continue;  // no three corners of one class
    if (closed_edges == 6) --chi[c[0]];
    for (int i = 0; i < 4; ++i) {
      const unsigned face = 0xFU & ~(1U << i);
      const std::size_t one = i == 0 ? 1 : 0;
      const bool closed =
          (attached & face) == face && c[one] == c[i <= 1 ? 2 : 1] && c[one] == c[i == 3 ? 2 : 3];
      if (!closed) continue;
      const HalfFaceId h = slab.mesh().opposite(TetMesh::half_face(t, i));
      // Of two tets that close a face the lower one counts it.
      const unsigned same = 0xFU & ~(1U << TetMesh::face_of(h));
      if (h.valid() && TetMesh::tet_of(h) < t &&
          (complex.attached[TetMesh::tet_of(h)] & same) == same) {
        continue;
      }
      ++chi[c[one]];
    }
  }
  counter.finish();
  for (const ClassId k : chi.ids()) chi[k] -= edges[k];
  return chi;
}

}  // namespace tetloft::internal
