#include "sections/gates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tetloft/predicates.hpp>

#include "sections/point_segment.hpp"
#include "sections/segments.hpp"

namespace tetloft::internal::sections {

namespace {

// Lengths along a ring.
class AlongRing {
 public:
  explicit AlongRing(const Ring& ring) {
    double length = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      from_start_.push_back(length);
      length += std::sqrt(square_distance(ring.points[k], ring.points[ring.after(k)]));
    }
    all_ = length;
  }
  [[nodiscard]] double at(std::size_t k) const { return from_start_[k]; }
  /// The shorter way between two places.
  [[nodiscard]] double between(double s, double t) const {
    const double one = std::abs(s - t);
    return std::min(one, all_ - one);
  }

 private:
  std::vector<double> from_start_;
  double all_ = 0;
};

BoxTree2 edge_tree(const Ring& ring) {
  std::vector<Box2> boxes;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    boxes.push_back(box_of(ring.points[k], ring.points[ring.after(k)]));
  }
  return BoxTree2(boxes);
}

Box2 box_around(const Point2& p, double width) {
  return {p.x - width, p.y - width, p.x + width, p.y + width};
}

// Does the segment to q leave point k into what is not region?
bool leaves_region(const Ring& ring, std::size_t k, const Point2& q) {
  const Point2& a = ring.points[ring.before(k)];
  const Point2& p = ring.points[k];
  const Point2& b = ring.points[ring.after(k)];
  const bool right_of_first = orient2d(a, p, q) == Sign::negative;
  const bool right_of_second = orient2d(p, b, q) == Sign::negative;
  return orient2d(a, p, b) == Sign::positive ? right_of_first || right_of_second
                                             : right_of_first && right_of_second;
}

class GateSearch {
 public:
  GateSearch(const Ring& ring, const OtherEdges& others, std::size_t self, double width)
      : ring_(ring),
        others_(others),
        self_(self),
        width_(width),
        along_(ring),
        edges_(edge_tree(ring)) {}

  [[nodiscard]] std::vector<Gate> run() {
    collect();
    std::sort(candidates_.begin(), candidates_.end(), [&](const Gate& g, const Gate& h) {
      const double a = square_length(g);
      const double b = square_length(h);
      return a != b ? a < b : std::pair{g.from, g.to} < std::pair{h.from, h.to};
    });
    return without_crossings();
  }

 private:
  [[nodiscard]] double square_length(const Gate& g) const {
    return square_distance(ring_.points[g.from], ring_.points[g.to]);
  }

  // Of each point the shortest gates on, for its neighbours have theirs.
  void collect() {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      near.clear();
      const Point2& p = ring_.points[i];
      edges_.query(box_around(p, width_), [&](std::size_t j) {
        const double square = square_distance(p, ring_.points[j]);
        if (square > width_ * width_) return;
        if (along_.between(along_.at(i), along_.at(j)) > 2 * width_) near.emplace_back(square, j);
      });
      std::sort(near.begin(), near.end());
      constexpr std::size_t kMost = 3;
      std::size_t found = 0;
      for (const auto& [square, j] : near) {
        if (found == kMost) break;
        if (!is_open(i, j)) continue;
        ++found;
        candidates_.push_back({std::min(i, j), std::max(i, j)});
      }
    }
    std::sort(candidates_.begin(), candidates_.end(), [](const Gate& g, const Gate& h) {
      return std::pair{g.from, g.to} < std::pair{h.from, h.to};
    });
    candidates_.erase(
        std::unique(candidates_.begin(), candidates_.end(),
                    [](const Gate& g, const Gate& h) { return g.from == h.from && g.to == h.to; }),
        candidates_.end());
  }

  // Does the segment between two points meet no contour but there, and no region?
  [[nodiscard]] bool is_open(std::size_t i, std::size_t j) const {
    const Point2& p = ring_.points[i];
    const Point2& q = ring_.points[j];
    if (!leaves_region(ring_, i, q) || !leaves_region(ring_, j, p)) return false;
    bool open = true;
    edges_.query(box_of(p, q), [&](std::size_t k) {
      const std::size_t l = ring_.after(k);
      if (k == i || k == j || l == i || l == j) return;
      if (touch(p, q, ring_.points[k], ring_.points[l])) open = false;
    });
    others_.tree.query(box_of(p, q), [&](std::size_t k) {
      const OtherEdges::Edge& e = others_.edges[k];
      if (others_.contour[k] != self_ && touch(p, q, e.a, e.b)) open = false;
    });
    return open;
  }

  // Two of a ring cross where their ends alternate along it.
  [[nodiscard]] static bool alternate(const Gate& g, const Gate& h) {
    const auto strictly_in = [&](std::size_t k) { return g.from < k && k < g.to; };
    const auto strictly_out = [&](std::size_t k) { return k < g.from || k > g.to; };
    return (strictly_in(h.from) && strictly_out(h.to)) ||
           (strictly_out(h.from) && strictly_in(h.to));
  }

  [[nodiscard]] std::vector<Gate> without_crossings() const {
    std::vector<Box2> boxes;
    for (const Gate& g : candidates_) {
      boxes.push_back(box_of(ring_.points[g.from], ring_.points[g.to]));
    }
    const BoxTree2 tree(boxes);
    std::vector<bool> taken(candidates_.size(), false);
    std::vector<Gate> gates;
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      bool free = true;
      tree.query(boxes[k], [&](std::size_t l) {
        if (taken[l] && alternate(candidates_[k], candidates_[l])) free = false;
      });
      if (!free) continue;
      taken[k] = true;
      gates.push_back(candidates_[k]);
    }
    return gates;
  }

  const Ring& ring_;
  const OtherEdges& others_;
  std::size_t self_;
  double width_;
  AlongRing along_;
  BoxTree2 edges_;
  std::vector<Gate> candidates_;
};

}  // namespace

void add_feet(Ring& ring, double width) {
  const AlongRing along(ring);
  const BoxTree2 edges = edge_tree(ring);
  struct Foot {
    std::size_t edge;
    double along;
    Point2 at;
  };
  std::vector<Foot> feet;
  const double most = width * width;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& p = ring.points[i];
    edges.query(box_around(p, width), [&](std::size_t k) {
      const Point2& a = ring.points[k];
      const Point2& b = ring.points[ring.after(k)];
      if (square_distance(p, a) <= most || square_distance(p, b) <= most) return;
      const Point2 foot = nearest_on(p, a, b);
      if (square_distance(p, foot) > most || foot == a || foot == b) return;
      const double place = along.at(k) + std::sqrt(square_distance(a, foot));
      if (along.between(along.at(i), place) <= 2 * width || !leaves_region(ring, i, foot)) return;
      feet.push_back({k, place, foot});
    });
  }
  std::sort(feet.begin(), feet.end(), [](const Foot& f, const Foot& g) {
    if (f.edge != g.edge) return f.edge < g.edge;
    return f.along != g.along ? f.along < g.along : canonical_less(f.at, g.at);
  });
  Ring longer;
  std::size_t next = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    longer.points.push_back(ring.points[k]);
    longer.added.push_back(ring.added[k]);
    for (; next < feet.size() && feet[next].edge == k; ++next) {
      if (longer.points.back() == feet[next].at) continue;
      longer.points.push_back(feet[next].at);
      longer.added.push_back(true);
    }
  }
  ring = std::move(longer);
}

std::vector<Gate> find_gates(const Ring& ring, const OtherEdges& others, std::size_t self,
                             double width) {
  return GateSearch(ring, others, self, width).run();
}

}  // namespace tetloft::internal::sections
