// Convex filling: redundant tets (CC) that lie on the region's side of both their contour
// edges are added where that changes no topology (see completion.hpp).
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <tetloft/predicates.hpp>

#include "completion/completion.hpp"

namespace tetloft::internal {

namespace {

constexpr std::uint8_t kAllCorners = 0xF;

// Does the whole tet lie on the region's side of the contour edge u v of one plane, in
// projection?
bool tet_on_inner_side(const Slab& slab, SlabVertexId u, SlabVertexId v, SlabVertexId w,
                       SlabVertexId x) {
  const auto flat = [&](SlabVertexId t) { return slab.section_of(t).point(slab.in_section(t)); };
  if (slab.section_of(u).next[slab.in_section(u)] != slab.in_section(v)) std::swap(u, v);
  return orient2d(flat(u), flat(v), flat(w)) != Sign::negative &&
         orient2d(flat(u), flat(v), flat(x)) != Sign::negative;
}

}  // namespace

bool Completion::is_convex_filling(TetId t) const {
  if (slab_.kind(t) != TetKind::cc) return false;
  std::array<SlabVertexId, 4> v = slab_.vertices(t);
  const ClassId c = classes_.of(v[0]);
  if (active_[c] == 0) return false;
  for (const SlabVertexId u : v) {
    if (classes_.of(u) != c) return false;
  }
  std::stable_partition(v.begin(), v.end(), [&](SlabVertexId u) { return !slab_.is_upper(u); });
  return tet_on_inner_side(slab_, v[0], v[1], v[2], v[3]) &&
         tet_on_inner_side(slab_, v[2], v[3], v[0], v[1]);
}

// Adding a tet is an elementary expansion if it meets the complex in a disc: here in three
// faces, or in two whose opposite edge is not in the complex. All four corners are own
// vertices, so fewer faces would leave out a vertex that is in the complex. Links stay discs:
// no vertex has to be settled anew.
bool Completion::is_expansion(TetId t) {
  ++work_;
  std::array<bool, 4> shared{};
  int faces = 0;
  for (int i = 0; i < 4; ++i) {
    const HalfFaceId h = slab_.mesh().opposite(TetMesh::half_face(t, i));
    if (!h.valid()) continue;
    const TetId across = TetMesh::tet_of(h);
    int kept = 0;
    int attached = 0;
    for (int j = 0; j < 4; ++j) {
      if (j == TetMesh::face_of(h)) continue;
      kept += complex_.keeps(across, j) ? 1 : 0;
      attached += complex_.is_attached(across, j) ? 1 : 0;
    }
    if (kept == 0) continue;
    // A sheet detached at one of the corners would be joined to it.
    if (attached != 3) return false;
    shared[static_cast<std::size_t>(i)] = true;
    ++faces;
  }
  if (faces == 3) return true;
  if (faces != 2) return false;
  // The edge opposite to the one common to both shared faces joins the corners opposite to
  // them.
  std::array<int, 2> ends{};
  int found = 0;
  for (int i = 0; i < 4; ++i) {
    if (shared[static_cast<std::size_t>(i)]) ends[static_cast<std::size_t>(found++)] = i;
  }
  const SlabVertexId u = slab_.vertex(t, ends[0]);
  const SlabVertexId v = slab_.vertex(t, ends[1]);
  if (slab_.is_upper(u) == slab_.is_upper(v)) return false;  // a contour edge
  slab_.ring(u, v, t, ring_);
  return std::none_of(ring_.begin(), ring_.end(),
                      [&](TetId r) { return complex_.keeps(r, slab_.index_in(r, u)); });
}

// Passes over the candidates by id, until one adds nothing. Adding a tet makes an expansion of
// its neighbours at most: more kept tets in a ring never do. So only these are looked at again,
// a higher one in the same pass, a lower one in the next.
void Completion::fill_convex() {
  enum : std::uint8_t { kNone, kRejected, kWaiting };
  IdVector<TetId, std::uint8_t> candidate(slab_.tet_count(), kNone);
  std::vector<TetId> pass;
  for (const TetId t : slab_.tets()) {
    if (complex_.kept[t] != 0 || !is_convex_filling(t)) continue;
    candidate[t] = kWaiting;
    pass.push_back(t);
  }
  std::vector<TetId> next;
  while (!pass.empty()) {
    std::make_heap(pass.begin(), pass.end(), std::greater<>());
    while (!pass.empty()) {
      std::pop_heap(pass.begin(), pass.end(), std::greater<>());
      const TetId t = pass.back();
      pass.pop_back();
      if (!is_expansion(t)) {
        candidate[t] = kRejected;
        continue;
      }
      // Each corner is on a shared face, so that the tet belongs to its primary sheet.
      complex_.kept[t] = kAllCorners;
      complex_.attached[t] = kAllCorners;
      candidate[t] = kNone;
      for (int i = 0; i < 4; ++i) {
        const TetId across = slab_.mesh().neighbour(t, i);
        if (!across.valid() || candidate[across] != kRejected) continue;
        candidate[across] = kWaiting;
        if (t < across) {
          pass.push_back(across);
          std::push_heap(pass.begin(), pass.end(), std::greater<>());
        } else {
          next.push_back(across);
        }
      }
    }
    std::swap(pass, next);
  }
}

}  // namespace tetloft::internal
