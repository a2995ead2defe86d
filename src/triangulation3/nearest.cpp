// See nearest.hpp.
#include "triangulation3/nearest.hpp"

#include <algorithm>

#include "predicates/distances.hpp"

namespace tetloft::internal::triangulation3 {

Nearest::Nearest(const LiveTets& tets, const Point3& p, VertexId near) : tets_(tets), p_(p) {
  Candidate at = nearer_corner(near);
  bool tied = false;
  while (step(at, tied)) {
  }
  seen_.insert(at.vertex);
  if (tied) {
    collect_nearest(at);
  } else {
    candidates_.push_back(at);
  }
}

Nearest::Candidate Nearest::candidate(VertexId v) const {
  return {v, predicates::squared_distance(p_, tets_.point(v))};
}

Sign Nearest::compare(const Candidate& a, const Candidate& b) const {
  return predicates::compare_distances(p_, tets_.point(a.vertex), a.squared, tets_.point(b.vertex),
                                       b.squared);
}

bool Nearest::comes_later(const Candidate& a, const Candidate& b) const {
  const Sign s = compare(a, b);
  return s == Sign::positive || (s == Sign::zero && b.vertex < a.vertex);
}

// Of the vertices of the tet that p lies in, or of the hull facet beyond which it lies.
Nearest::Candidate Nearest::nearer_corner(VertexId near) const {
  Candidate best;
  const auto consider = [&](const TetVertices& tet) {
    for (const VertexId v : tet) {
      if (!LiveTets::is_point(v)) continue;
      const Candidate other = candidate(v);
      if (!best.vertex.valid() || compare(other, best) == Sign::negative) best = other;
    }
  };
  consider(tets_.tets().tet(tets_.locate(p_, near)));
  // A hull facet of auxiliary vertices has no point; every finite tet has.
  if (!best.vertex.valid()) consider(tets_.tets().tet(tets_.start(p_, near)));
  return best;
}

// To a neighbour that is nearer, if there is one; else tells whether one is as near.
bool Nearest::step(Candidate& at, bool& tied) {
  const Candidate from = at;
  tied = false;
  for_each_around(tets_, from.vertex, around_, [&](TetId /*t*/, VertexId v) {
    if (!LiveTets::is_point(v)) return true;
    const Candidate other = candidate(v);
    const Sign s = compare(other, from);
    if (s == Sign::negative) at = other;
    tied = tied || s == Sign::zero;
    return s != Sign::negative;
  });
  return at.vertex != from.vertex;
}

void Nearest::collect_nearest(const Candidate& nearest) {
  std::vector<Candidate> equal{nearest};
  for (std::size_t next = 0; next < equal.size(); ++next) {
    for_each_around(tets_, equal[next].vertex, around_, [&](TetId /*t*/, VertexId v) {
      if (!LiveTets::is_point(v) || seen_.contains(v)) return true;
      const Candidate other = candidate(v);
      if (compare(other, nearest) == Sign::zero) {
        seen_.insert(v);
        equal.push_back(other);
      }
      return true;
    });
  }
  for (const Candidate& c : equal) add(c);
}

void Nearest::add(const Candidate& c) {
  candidates_.push_back(c);
  std::push_heap(candidates_.begin(), candidates_.end(),
                 [&](const Candidate& a, const Candidate& b) { return comes_later(a, b); });
}

VertexId Nearest::next() {
  if (candidates_.empty()) return {};
  std::pop_heap(candidates_.begin(), candidates_.end(),
                [&](const Candidate& a, const Candidate& b) { return comes_later(a, b); });
  const VertexId v = candidates_.back().vertex;
  candidates_.pop_back();
  for_each_around(tets_, v, around_, [&](TetId /*t*/, VertexId u) {
    if (LiveTets::is_point(u) && seen_.insert(u)) add(candidate(u));
    return true;
  });
  return v;
}

}  // namespace tetloft::internal::triangulation3
