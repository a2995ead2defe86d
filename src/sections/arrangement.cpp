#include "sections/arrangement.hpp"

#include <cmath>

#include "sections/segments.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

namespace {

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

double distance_to_line(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return std::abs(dx * (p.y - a.y) - dy * (p.x - a.x)) / length_of(dx, dy);
}

// Where two edges cross, rounded; within the boxes of both.
Point2 crossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double dx = d.x - c.x;
  const double dy = d.y - c.y;
  const double from_a = dx * (a.y - c.y) - dy * (a.x - c.x);
  const double from_b = dx * (b.y - c.y) - dy * (b.x - c.x);
  double t = from_a / (from_a - from_b);
  if (!(t >= 0 && t <= 1)) t = 0.5;  // over- or underflow
  Point2 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  for (const auto& [q, r] : {std::pair{a, b}, std::pair{c, d}}) {
    p.x = std::clamp(p.x, std::min(q.x, r.x), std::max(q.x, r.x));
    p.y = std::clamp(p.y, std::min(q.y, r.y), std::max(q.y, r.y));
  }
  return p;
}

}  // namespace

void Arrangement::add_edge(const Point2& a, const Point2& b, ContourId contour) {
  pieces_.push_back({node(a), node(b), contour, 1});
}

Arrangement::Outcome Arrangement::settle() {
  constexpr int kRounds = 20;
  constexpr std::size_t kGrowth = 64;
  const std::size_t many = 100 + kGrowth * pieces_.size();
  merge_near_nodes();
  cancel();
  for (int round = 0; round < kRounds; ++round) {
    if (!split_once()) {
      tell_shared();
      return Outcome::settled;
    }
    if (moved_ > most_) return Outcome::moved_too_far;
    if (pieces_.size() > many) return Outcome::endless;
    cancel();
  }
  return Outcome::endless;
}

NodeId Arrangement::node(const Point2& p) {
  const auto [place, is_new] = node_of_.try_emplace({p.x, p.y}, nodes_.end_id());
  if (is_new) nodes_.push_back(p);
  return place->second;
}

bool Arrangement::lies_on(const Point2& p, const Point2& a, const Point2& b) const {
  if (in_segment(a, b, p)) return true;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
  return along > 0 && along < dx * dx + dy * dy && distance_to_line(p, a, b) <= radius_;
}

// A node for a crossing: the nearest that there is within the radius, or a new one.
NodeId Arrangement::node_near(const Point2& p) {
  NodeId nearest;
  double least = radius_;
  for (auto i = node_of_.lower_bound({p.x - radius_, -INFINITY});
       i != node_of_.end() && i->first.first <= p.x + radius_; ++i) {
    const double d = length_of(i->first.first - p.x, i->first.second - p.y);
    if (d > least) continue;
    least = d;
    nearest = i->second;
  }
  return nearest.valid() ? nearest : node(p);
}

// By canonical order of what they keep: the nearest one before within the radius, or the node
// itself. Ends of one piece are a shape of the input, unless hardly anything lies between.
IdVector<NodeId, NodeId> Arrangement::nearest_kept_nodes() const {
  std::vector<std::pair<NodeId, NodeId>> joined;
  for (const ArrangementPiece& p : pieces_) {
    joined.emplace_back(std::min(p.a, p.b), std::max(p.a, p.b));
  }
  std::sort(joined.begin(), joined.end());
  const auto are_joined = [&](NodeId m, NodeId n) {
    return std::binary_search(joined.begin(), joined.end(),
                              std::pair{std::min(m, n), std::max(m, n)});
  };
  const double tiny = radius_ * 0x1p-16;
  std::vector<Box2> boxes;
  for (const Point2& p : nodes_) boxes.push_back(box_of(p, p));
  const BoxTree2 tree(boxes);
  IdVector<NodeId, NodeId> kept(nodes_.size());
  for (const auto& place : node_of_) {
    const NodeId n = place.second;
    const Point2& p = at(n);
    NodeId nearest = n;
    double least = radius_;
    tree.query({p.x - radius_, p.y - radius_, p.x + radius_, p.y + radius_}, [&](std::size_t k) {
      const NodeId m(k);
      if (kept[m] != m || m == n) return;  // not yet come to, or itself moved
      const double d = length_of(at(m).x - p.x, at(m).y - p.y);
      if (d > least || (d > tiny && are_joined(m, n))) return;
      if (d == least && nearest != n && canonical_less(at(nearest), at(m))) return;
      least = d;
      nearest = m;
    });
    kept[n] = nearest;
  }
  return kept;
}

void Arrangement::merge_near_nodes() {
  const IdVector<NodeId, NodeId> kept = nearest_kept_nodes();
  for (ArrangementPiece& p : pieces_) {
    for (NodeId* const n : {&p.a, &p.b}) {
      const NodeId to = kept[*n];
      if (to == *n) continue;
      moved_ = std::max(moved_, length_of(at(to).x - at(*n).x, at(to).y - at(*n).y));
      if (n == &p.a) events_.push_back({ArrangementEvent::Kind::merged, p.contour, at(*n)});
      node_of_.erase({at(*n).x, at(*n).y});
      *n = to;
    }
  }
}

std::size_t Arrangement::end_of_equal(std::size_t i) const {
  std::size_t k = i + 1;
  while (k < pieces_.size() && pieces_[k].a == pieces_[i].a && pieces_[k].b == pieces_[i].b) ++k;
  return k;
}

// Are both sides of equal pieces the same by the rule, whatever they are?
bool Arrangement::takes_nothing(std::size_t first, std::size_t last) const {
  int sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += pieces_[i].times;
  switch (rule_) {
    case FillRule::odd: return sum % 2 == 0;
    case FillRule::winding: return sum == 0;
    case FillRule::unite: return false;
  }
  return false;
}

// Equal pieces of a contour become one, and go where they take nothing away. Pieces go from their
// lower end and are sorted, so that no round depends on the order or direction of contours.
void Arrangement::cancel() {
  for (ArrangementPiece& p : pieces_) {
    if (!canonical_less(at(p.b), at(p.a))) continue;
    std::swap(p.a, p.b);
    p.times = -p.times;
  }
  const auto key = [&](const ArrangementPiece& p) {
    return std::array{at(p.a).x, at(p.a).y, at(p.b).x, at(p.b).y};
  };
  std::sort(pieces_.begin(), pieces_.end(),
            [&](const ArrangementPiece& p, const ArrangementPiece& q) {
              const auto k = key(p);
              const auto l = key(q);
              return k != l ? k < l : p.contour < q.contour;
            });
  std::size_t kept = 0;
  for (std::size_t i = 0, end = 0; i < pieces_.size(); i = end) {
    end = end_of_equal(i);
    if (pieces_[i].a == pieces_[i].b) continue;
    const ArrangementPiece front = pieces_[i];
    const std::size_t first = kept;
    bool removed = false;
    for (std::size_t k = i; k < end; ++k) {
      ArrangementPiece piece = pieces_[k];
      while (k + 1 < end && pieces_[k + 1].contour == piece.contour) {
        piece.times += pieces_[++k].times;
      }
      if (piece.times == 0) {
        removed = true;
      } else {
        pieces_[kept++] = piece;
      }
    }
    if (kept > first && takes_nothing(first, kept)) {
      kept = first;
      removed = true;
    }
    if (removed) {
      events_.push_back({ArrangementEvent::Kind::cancelled, front.contour, at(front.a)});
    }
  }
  pieces_.resize(kept);
}

void Arrangement::tell_shared() {
  for (std::size_t i = 0; i < pieces_.size(); i = end_of_equal(i)) {
    if (end_of_equal(i) == i + 1 && std::abs(pieces_[i].times) == 1) continue;
    events_.push_back({ArrangementEvent::Kind::shared, pieces_[i].contour, at(pieces_[i].a)});
  }
}

// One round; false where no two pieces meet but at ends. Rounding may make new contacts, which
// the next round finds.
bool Arrangement::split_once() {
  std::vector<std::vector<NodeId>> splits(pieces_.size());
  bool any = false;
  double moved = 0;
  const auto split = [&](std::size_t i, NodeId n) {
    if (n == pieces_[i].a || n == pieces_[i].b) return;
    splits[i].push_back(n);
    moved = std::max(moved, distance_to_line(at(n), at(pieces_[i].a), at(pieces_[i].b)));
    any = true;
  };
  const auto edge = [&](std::size_t i) {
    return std::array<Point2, 2>{at(pieces_[i].a), at(pieces_[i].b)};
  };
  for_each_near_pair(pieces_.size(), edge, [&](std::size_t i, std::size_t j) {
    if (pieces_[i].a == pieces_[j].a && pieces_[i].b == pieces_[j].b) return;
    const auto [a, b] = edge(i);
    const auto [c, d] = edge(j);
    if (lies_on(a, c, d)) split(j, pieces_[i].a);
    if (lies_on(b, c, d)) split(j, pieces_[i].b);
    if (lies_on(c, a, b)) split(i, pieces_[j].a);
    if (lies_on(d, a, b)) split(i, pieces_[j].b);
    if (!cross(a, b, c, d)) return;
    const NodeId n = node_near(crossing(a, b, c, d));
    split(i, n);
    split(j, n);
    events_.push_back({ArrangementEvent::Kind::crossing, pieces_[i].contour, at(n)});
  });
  if (!any) return false;
  moved_ += moved;
  apply(splits);
  return true;
}

void Arrangement::apply(std::vector<std::vector<NodeId>>& splits) {
  std::vector<ArrangementPiece> result;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const ArrangementPiece& piece = pieces_[i];
    const Point2 a = at(piece.a);
    const Point2 b = at(piece.b);
    const auto along = [&](NodeId n) {
      return (at(n).x - a.x) * (b.x - a.x) + (at(n).y - a.y) * (b.y - a.y);
    };
    std::sort(splits[i].begin(), splits[i].end(), [&](NodeId m, NodeId n) {
      return along(m) != along(n) ? along(m) < along(n) : canonical_less(at(m), at(n));
    });
    splits[i].erase(std::unique(splits[i].begin(), splits[i].end()), splits[i].end());
    NodeId from = piece.a;
    for (const NodeId n : splits[i]) {
      result.push_back({from, n, piece.contour, piece.times});
      from = n;
    }
    result.push_back({from, piece.b, piece.contour, piece.times});
  }
  pieces_ = std::move(result);
}

}  // namespace tetloft::internal::sections
