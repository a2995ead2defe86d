// A cycle is counter-clockwise iff it turns once to the left. Half turns are counted where it
// changes between rising and falling (canonical order): no coordinate of a crossing is needed.
#include "sections/overlay_graph.hpp"

#include <algorithm>
#include <cstddef>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"

namespace tetloft::internal::sections {

namespace {

// A way out of a node.
struct Direction {
  std::uint32_t half;
  const Point2* from;  // the edge's ends, in this direction
  const Point2* to;
  bool rises;
};

// Positive iff e comes before f, counter-clockwise from straight down. Zero iff they are the same.
Sign turn(const Direction& e, const Direction& f) {
  if (e.rises != f.rises) return e.rises ? Sign::positive : Sign::negative;
  return orient2d(*e.from, *e.to, *f.to);  // the node is on the line of e
}

}  // namespace

OverlayGraph::OverlayGraph(const TwoCurves& curves) : curves_(curves), nodes_(curves) {
  make_arcs();
  const auto nodes = static_cast<std::uint32_t>(nodes_.nodes.size());
  stars_.resize(nodes);
  for (std::uint32_t n = 0; n < nodes; ++n) make_star(n);
  make_loops();
  walk_cycles();
}

void OverlayGraph::make_arcs() {
  const std::size_t nodes = nodes_.nodes.size();
  for (std::size_t s = 0; s < 2; ++s) {
    const OverlayCurves& curves = *curves_[s];
    for (const auto& range : nodes_.range[s]) {
      for (std::uint32_t k = range.first; k < range.last; ++k) {
        const bool wraps = k + 1 == range.last;
        const OverlayNode& p = nodes_.nodes[nodes_.passes[s][k]];
        const OverlayNode& q = nodes_.nodes[nodes_.passes[s][wraps ? range.first : k + 1]];
        OverlayArc arc;
        arc.contour[s] = curves.contour(p.edge[s]);
        arcs_.push_back(arc);
        // Vertices from the one after p to the one before q.
        turns_.push_back((wraps ? curves.turns(arc.contour[s]) : 0) +
                         curves.turns_before(q.edge[s] + (q.at_start[s] ? 0 : 1)) -
                         curves.turns_before(p.edge[s] + 1));
      }
    }
  }
  leaving_.resize(4 * nodes);
}

void OverlayGraph::make_star(std::uint32_t n) {
  const OverlayNode& node = nodes_.nodes[n];
  const auto nodes = static_cast<std::uint32_t>(nodes_.nodes.size());
  std::array<Direction, 4> out{};
  Star& star = stars_[n];
  for (std::size_t s = 0; s < 2; ++s) {
    const OverlayCurves& curves = *curves_[s];
    const std::uint32_t edge = node.edge[s];
    const std::uint32_t pass = nodes_.place[s][n];
    const OverlayNodes::Range range = nodes_.range[s][curves.contour(edge)];
    const std::uint32_t before = pass == range.first ? range.last - 1 : pass - 1;
    const std::uint32_t base = s == 0 ? 0 : 2 * nodes;
    const Point2& start = curves.start(edge);
    const Point2& end = curves.end(edge);
    const Point2& back = node.at_start[s] ? curves.start(curves.previous(edge)) : start;
    const Point2& from = node.at_start[s] ? start : end;
    const std::array<Direction, 2> ways = {
        Direction{base + 2 * pass, &start, &end, canonical_less(start, end)},
        Direction{base + 2 * before + 1, &from, &back, canonical_less(from, back)}};
    for (std::size_t w = 0; w < 2; ++w) {
      std::uint32_t at = 0;
      Sign sign = Sign::positive;
      while (at < star.degree && (sign = turn(out[at], ways[w])) == Sign::positive) ++at;
      if (at < star.degree && sign == Sign::zero) {
        // The same piece: both sections have its next node.
        const std::uint32_t kept = out[at].half;
        OverlayArc& arc = arcs_[kept / 2];
        arc.contour[1] = curves.contour(edge);
        arc.along[1] = (w == 0) == (kept % 2 == 0);
        continue;
      }
      for (std::uint32_t k = star.degree; k > at; --k) out[k] = out[k - 1];
      out[at] = ways[w];
      ++star.degree;
    }
  }
  for (std::uint32_t k = 0; k < star.degree; ++k) {
    star.half[k] = out[k].half;
    leaving_[out[k].half] = {n, static_cast<std::uint8_t>(k), out[k].rises};
  }
}

void OverlayGraph::make_loops() {
  first_loop_ = static_cast<std::uint32_t>(arcs_.size());
  for (std::size_t s = 0; s < 2; ++s) {
    const std::uint32_t contours = curves_[s]->contour_count();
    loop_[s].assign(contours, kNone);
    for (std::uint32_t c = 0; c < contours; ++c) {
      if (nodes_.range[s][c].last != 0) continue;
      loop_[s][c] = static_cast<std::uint32_t>(2 * arcs_.size());
      OverlayArc arc;
      arc.contour[s] = c;
      arcs_.push_back(arc);
      turns_.push_back(curves_[s]->turns(c));
    }
  }
}

std::uint32_t OverlayGraph::next(std::uint32_t half) const {
  if (is_loop(half)) return half;
  const Leaving& back = leaving_[half ^ 1U];
  const Star& star = stars_[back.node];
  return star.half[back.place == 0 ? star.degree - 1 : back.place - 1U];
}

std::int32_t OverlayGraph::turns_within(std::uint32_t half) const {
  return half % 2 == 0 ? turns_[half / 2] : -turns_[half / 2];
}

void OverlayGraph::walk_cycles() {
  cycle_.assign(2 * arcs_.size(), kNone);
  for (std::uint32_t first = 0; first < cycle_.size(); ++first) {
    const bool is_merged = !is_loop(first) && leaving_[first].node == kNone;
    if (is_merged || cycle_[first] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(cycles_.size());
    std::int32_t turns = 0;
    std::uint32_t half = first;
    do {
      cycle_[half] = id;
      turns += turns_within(half);
      const std::uint32_t onward = next(half);
      if (!is_loop(half)) {
        const Leaving& back = leaving_[half ^ 1U];
        const Leaving& out = leaving_[onward];
        // The sector of the face runs from `onward` to the way back: it is convex iff it does
        // not contain straight down, if both rise or both fall.
        if (back.rises == out.rises) turns += out.place < back.place ? 1 : -1;
      }
      half = onward;
    } while (half != first);
    TETLOFT_CHECK(turns == 2 || turns == -2);
    cycles_.push_back({first, turns > 0});
  }
}

bool OverlayGraph::is_inside(std::uint32_t half, std::size_t s) const {
  const OverlayArc& arc = arcs_[half / 2];
  const bool along = arc.along[s] == (half % 2 == 0);
  return along == curves_[s]->is_counter_clockwise(arc.contour[s]);
}

std::uint32_t OverlayGraph::clockwise_on(std::uint32_t half, std::size_t s) const {
  const Leaving& out = leaving_[half];
  const Star& star = stars_[out.node];
  std::uint32_t place = out.place;
  while (arcs_[star.half[place] / 2].contour[s] == kNone) {
    place = place == 0 ? star.degree - 1 : place - 1;
  }
  return star.half[place];
}

}  // namespace tetloft::internal::sections
