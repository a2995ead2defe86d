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

bool Completion::may_be_redundant(TetId t) const {
  if (complex_.kept[t] != 0 || slab_.kind(t) != TetKind::cc) return false;
  const ClassId c = classes_.of(slab_.vertex(t, 0));
  return active_[c] != 0 && own_corners(slab_, classes_, t, c) == kAllCorners;
}

bool Completion::is_inside_contours(TetId t) const {
  std::array<std::array<SlabVertexId, 2>, 2> edge;  // below, above
  std::array<std::size_t, 2> found{};
  for (const SlabVertexId v : slab_.vertices(t)) {
    const std::size_t plane = slab_.is_upper(v) ? 1 : 0;
    edge[plane][found[plane]++] = v;
  }
  const auto& [a, b] = edge[0];
  const auto& [c, d] = edge[1];
  return tet_on_inner_side(slab_, a, b, c, d) && tet_on_inner_side(slab_, c, d, a, b);
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
    const unsigned corners = kAllCorners & ~(1U << TetMesh::face_of(h));
    if ((complex_.kept[across] & corners) == 0) continue;
    // A sheet detached at one of the corners would be joined to it.
    if ((complex_.attached[across] & corners) != corners) return false;
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
// a higher one in the same pass, a lower one in the next. Where a tet lies is asked last, and once:
// few are an expansion at all.
void Completion::fill_convex() {
  std::vector<TetId> pass = convex_candidates();
  while (!pass.empty()) {
    std::vector<TetId> next;
    std::vector<TetId> higher;  // heap, the lowest first
    for (std::size_t at = 0; at < pass.size() || !higher.empty();) {
      const bool from_pass = higher.empty() || (at < pass.size() && pass[at] < higher.front());
      const TetId t = from_pass ? pass[at++] : higher.front();
      if (!from_pass) {
        std::pop_heap(higher.begin(), higher.end(), std::greater<>());
        higher.pop_back();
      }
      if (fill_where_convex(t)) look_again_around(t, higher, next);
    }
    std::sort(next.begin(), next.end());
    pass = std::move(next);
  }
  candidate_ = {};
}

// By id; no other tet has two faces in the complex, as an expansion has.
std::vector<TetId> Completion::convex_candidates() {
  candidate_.assign(slab_.tet_count(), kNoFace);
  for (const TetId t : slab_.tets()) {
    if (complex_.kept[t] == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const TetId across = slab_.mesh().neighbour(t, i);
      if (!across.valid() || complex_.kept[across] != 0) continue;
      if ((complex_.kept[t] & ~(1U << i)) != 0) ++candidate_[across];
    }
  }
  std::vector<TetId> candidates;
  for (const TetId t : slab_.tets()) {
    if (candidate_[t] < kFaces || !may_be_redundant(t)) continue;
    candidate_[t] = kWaiting;
    candidates.push_back(t);
  }
  return candidates;
}

bool Completion::fill_where_convex(TetId t) {
  candidate_[t] = kRejected;
  if (!is_expansion(t)) return false;
  candidate_[t] = kNoCandidate;
  if (!is_inside_contours(t)) return false;
  // Each corner is on a shared face, so that the tet belongs to its primary sheet.
  complex_.kept[t] = kAllCorners;
  complex_.attached[t] = kAllCorners;
  return true;
}

void Completion::look_again_around(TetId t, std::vector<TetId>& higher, std::vector<TetId>& lower) {
  for (int i = 0; i < 4; ++i) {
    const TetId across = slab_.mesh().neighbour(t, i);
    if (!across.valid() || candidate_[across] > kRejected) continue;
    if (candidate_[across] != kRejected && !may_be_redundant(across)) continue;
    candidate_[across] = kWaiting;
    if (across < t) {
      lower.push_back(across);
      continue;
    }
    higher.push_back(across);
    std::push_heap(higher.begin(), higher.end(), std::greater<>());
  }
}

}  // namespace tetloft::internal
