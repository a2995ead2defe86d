#include "completion/completion.hpp"

#include <algorithm>
#include <functional>

#include "completion/link_discs.hpp"
#include "core/guard.hpp"

namespace tetloft::internal {

Completion::Completion(const Slab& slab, const SlabClasses& classes,
                       const IdVector<ClassId, std::uint8_t>& active, Complex complex,
                       RuleCounts& rules)
    : slab_(slab),
      classes_(classes),
      active_(active),
      complex_(std::move(complex)),
      rules_(rules),
      parts_(classes.regions().size()),
      changed_(slab.vertex_count(), 0),
      queued_(slab.vertex_count(), 0),
      seen_(slab.tet_count(), 0),
      boundary_(slab.vertex_count()),
      spoke_of_(slab.tet_count(), kHull) {}

std::vector<LeftApart> Completion::run() {
  settle_all();
  std::vector<LeftApart> left = connect_classes();
  if (left.empty()) fill_convex();
  return left;
}

void Completion::enqueue(SlabVertexId v) {
  if (queued_[v] != 0) return;
  queued_[v] = 1;
  heap_.push_back(v);
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

void Completion::keep(TetId t, ClassId c) {
  const std::uint8_t mask = own_corners(slab_, classes_, t, c);
  complex_.kept[t] = static_cast<std::uint8_t>(complex_.kept[t] | mask);
  for (int i = 0; i < 4; ++i) {
    if (!has_corner(mask, i)) continue;
    enqueue(slab_.vertex(t, i));
    disc_[slab_.vertex(t, i)] = 0;
    note_change(slab_.vertex(t, i));
  }
}

// Every vertex of an active class, and what the rules want besides: as if all had been enqueued.
// Where the link is a disc already, and nothing more is kept, there is nothing to settle.
void Completion::settle_all() {
  disc_ = link_discs(slab_, complex_.kept);
  work_ += slab_.tet_count();
  for (const SlabVertexId v : slab_.vertices()) queued_[v] = active_[classes_.of(v)];
  for (const SlabVertexId v : slab_.vertices()) {
    if (queued_[v] == 0) continue;
    while (!heap_.empty() && heap_.front() < v) settle_lowest();
    if (disc_[v] == 0) settle(v);
    queued_[v] = 0;
  }
  settle_queue();
  attach_discs();
}

// All that is kept at the vertices nobody had to settle.
void Completion::attach_discs() {
  for (const TetId t : slab_.tets()) {
    const std::uint8_t kept = complex_.kept[t];
    if (kept == 0) continue;
    unsigned discs = 0;
    for (int i = 0; i < 4; ++i) discs |= static_cast<unsigned>(disc_[slab_.vertex(t, i)]) << i;
    complex_.attached[t] = static_cast<std::uint8_t>(complex_.attached[t] | (kept & discs));
  }
}

void Completion::settle_queue() {
  while (!heap_.empty()) settle_lowest();
}

void Completion::settle_lowest() {
  std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
  const SlabVertexId v = heap_.back();
  heap_.pop_back();
  settle(v);
  queued_[v] = 0;
}

// Those of a vertex hang together over its internal edges, whose rings are kept: one of them leads
// to all.
TetId Completion::tet_on_internal_triangle(SlabVertexId p) const {
  const bool upper = slab_.is_upper(p);
  const ConformingSection& section = slab_.section(upper);
  const PlaneVertexId v = slab_.in_section(p);
  TETLOFT_CHECK(section.next[v].valid());
  const ConformingSection::Edge& edge = section.edges[section.find_edge(v, section.next[v])];
  const bool left = edge.left.valid() && section.internal[edge.left] != 0;
  return slab_.tet_on(upper, left ? edge.left : edge.right);
}

// Floods the primary sheet at p, and notes its boundary in the link; the rest of the star is not
// looked at.
Completion::LinkShape Completion::flood_sheet(SlabVertexId p) {
  ++epoch_;
  boundary_.clear();
  sheet_.clear();
  const auto reach = [&](TetId t, int corner) {
    seen_[t] = epoch_;
    sheet_.push_back(TetMesh::half_face(t, corner));
  };
  const TetId first = tet_on_internal_triangle(p);
  reach(first, slab_.index_in(first, p));
  for (std::size_t at = 0; at < sheet_.size(); ++at) {
    const TetId t = TetMesh::tet_of(sheet_[at]);
    const int corner = TetMesh::face_of(sheet_[at]);
    for (int i = 0; i < 4; ++i) {
      if (i == corner) continue;
      const TetId across = slab_.mesh().neighbour(t, i);
      if (across.valid()) {
        if (in_sheet(across)) continue;
        const int there = slab_.index_in(across, p);
        if (complex_.keeps(across, there)) {
          reach(across, there);
          continue;
        }
      }
      const LinkEdge& edge = link_edge(corner, i);
      boundary_.add(slab_.vertex(t, edge.from), slab_.vertex(t, edge.to));
    }
  }
  work_ += sheet_.size();
  if (boundary_.is_pinched()) return LinkShape::pinched;
  return boundary_.is_simple_cycle() ? LinkShape::disc : LinkShape::holed;
}

void Completion::settle(SlabVertexId p) {
  for (;;) {
    const LinkShape shape = flood_sheet(p);
    if (shape == LinkShape::disc) break;
    if (shape == LinkShape::pinched && fill_rings(p)) continue;
    if (!fill_holes(p)) break;
  }
  for (const HalfFaceId c : sheet_) attach(TetMesh::tet_of(c), TetMesh::face_of(c));
}

// The corners of p by tet, over the faces at it: few stars are gathered, and lists of corners for
// all vertices would cost more. A star is connected.
void Completion::find_star(SlabVertexId p) {
  ++epoch_;
  star_.clear();
  const auto reach = [&](TetId t) {
    seen_[t] = epoch_;
    star_.push_back(TetMesh::half_face(t, slab_.index_in(t, p)));
  };
  reach(tet_on_internal_triangle(p));
  for (std::size_t at = 0; at < star_.size(); ++at) {
    const TetId t = TetMesh::tet_of(star_[at]);
    for (int i = 0; i < 4; ++i) {
      if (i == TetMesh::face_of(star_[at])) continue;
      const TetId across = slab_.mesh().neighbour(t, i);
      if (across.valid() && seen_[across] != epoch_) reach(across);
    }
  }
  std::sort(star_.begin(), star_.end());
}

void Completion::gather_star(SlabVertexId p) {
  spokes_.clear();
  find_star(p);
  for (const HalfFaceId c : star_) {
    const TetId t = TetMesh::tet_of(c);
    spoke_of_[t] = static_cast<std::int32_t>(spokes_.size());
    spokes_.push_back({t, TetMesh::face_of(c), {}});
  }
  work_ += spokes_.size();
  for (Spoke& spoke : spokes_) {
    for (int i = 0; i < 4; ++i) {
      if (i == spoke.corner) continue;
      const TetId across = slab_.mesh().neighbour(spoke.tet, i);
      spoke.next[static_cast<std::size_t>(i)] = across.valid() ? spoke_of_[across] : kHull;
    }
  }
}

void Completion::find_primary_sheet(SlabVertexId p) {
  primary_.assign(spokes_.size(), 0);
  const auto start = static_cast<std::uint32_t>(spoke_of_[tet_on_internal_triangle(p)]);
  primary_[start] = 1;
  stack_.assign(1, start);
  while (!stack_.empty()) {
    const Spoke& spoke = spokes_[stack_.back()];
    stack_.pop_back();
    for (int i = 0; i < 4; ++i) {
      if (i == spoke.corner) continue;
      const std::int32_t k = spoke.next[static_cast<std::size_t>(i)];
      if (k == kHull || primary_[static_cast<std::size_t>(k)] != 0) continue;
      if (!spoke_kept(static_cast<std::size_t>(k))) continue;
      primary_[static_cast<std::size_t>(k)] = 1;
      stack_.push_back(static_cast<std::uint32_t>(k));
    }
  }
}

// Fills the complements of the primary sheet in the star that touch no hull facet.
bool Completion::fill_holes(SlabVertexId p) {
  gather_star(p);
  find_primary_sheet(p);
  std::vector<std::uint8_t> visited = primary_;
  to_keep_.clear();
  for (std::size_t start = 0; start < spokes_.size(); ++start) {
    if (visited[start] != 0) continue;
    std::vector<TetId> hole;
    bool open = false;
    visited[start] = 1;
    stack_.assign(1, static_cast<std::uint32_t>(start));
    while (!stack_.empty()) {
      const Spoke& spoke = spokes_[stack_.back()];
      stack_.pop_back();
      hole.push_back(spoke.tet);
      for (int i = 0; i < 4; ++i) {
        if (i == spoke.corner) continue;
        const std::int32_t k = spoke.next[static_cast<std::size_t>(i)];
        if (k == kHull) {
          open = true;
        } else if (visited[static_cast<std::size_t>(k)] == 0) {
          visited[static_cast<std::size_t>(k)] = 1;
          stack_.push_back(static_cast<std::uint32_t>(k));
        }
      }
    }
    if (open) continue;
    count(rules_, Rule::hole_in_link);
    to_keep_.insert(to_keep_.end(), hole.begin(), hole.end());
  }
  const ClassId c = classes_.of(p);
  for (const TetId t : to_keep_) keep(t, c);
  return !to_keep_.empty();
}

}  // namespace tetloft::internal
