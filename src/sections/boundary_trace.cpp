#include "sections/boundary_trace.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"

namespace tetloft::internal::sections {

BoundaryTrace::BoundaryTrace(const Arrangement& arrangement, const RegionSides& sides)
    : arrangement_(arrangement), at_node_(arrangement.node_count()) {
  const std::vector<SidedPiece>& all = sides.pieces();
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].left != all[i].right) order.push_back(i);
  }
  const auto contour = [&](std::size_t i) { return arrangement.pieces()[all[i].first].contour; };
  // Input order decides where contours begin.
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return contour(i) < contour(j); });
  std::vector<std::size_t> place(all.size(), 0);
  for (const std::size_t i : order) {
    place[i] = pieces_.size();
    pieces_.push_back({all[i].a, all[i].b, contour(i), all[i].left});
  }
  for (std::size_t k = 0; k < arrangement.node_count(); ++k) {
    const NodeId n(k);
    NodePieces& here = at_node_[n];
    for (const std::size_t edge : sides.leaving(n)) {
      const SidedPiece& piece = all[edge / 2];
      if (piece.left != piece.right) here.pieces.push_back(place[edge / 2]);
    }
    const std::size_t m = here.pieces.size();
    TETLOFT_CHECK(m % 2 == 0);
    here.partner.assign(m, 0);
    here.cut.assign(m, false);
    if (m == 2) here.partner = {1, 0};
    if (m > 2) part(n, here);
  }
}

// Pairs the pieces that bound a wedge of the region; all but one wedge lose their corner.
void BoundaryTrace::part(NodeId n, NodePieces& here) {
  touching_.push_back(n);
  const std::size_t m = here.pieces.size();
  const Piece& front = pieces_[here.pieces.front()];
  const bool region_behind_front = (front.a == n) == front.left;
  const std::size_t first = region_behind_front ? 0 : m - 1;
  // A wedge of a half turn or more keeps its corner: cut off, it would reach into the others.
  std::size_t whole = first;
  for (std::size_t k = 0; k < m / 2; ++k) {
    const std::size_t i = (first + 2 * k) % m;
    const std::size_t j = (i + 1) % m;
    here.partner[i] = j;
    here.partner[j] = i;
    here.cut[i] = here.cut[j] = true;
    const Sign turn =
        orient2d(at(n), at(other_end(here.pieces[i], n)), at(other_end(here.pieces[j], n)));
    if (turn != Sign::positive) whole = i;
  }
  here.cut[whole] = here.cut[here.partner[whole]] = false;
}

std::vector<BoundaryTrace::Touching> BoundaryTrace::touching() const {
  std::vector<Touching> result;
  for (const NodeId n : touching_) {
    const std::vector<std::size_t>& pieces = at_node_[n].pieces;
    ContourId first = pieces_[pieces.front()].contour;
    for (const std::size_t piece : pieces) first = std::min(first, pieces_[piece].contour);
    result.push_back({first, at(n)});
  }
  return result;
}

// The point of the piece near its node, `cut` away or a quarter of it.
Point2 BoundaryTrace::near_node(NodeId n, std::size_t piece, double cut) const {
  const Point2& p = at(n);
  const Point2& q = at(other_end(piece, n));
  const double x = q.x - p.x;
  const double y = q.y - p.y;
  const double t = std::min(0.25, cut / std::sqrt(x * x + y * y));
  return {p.x + t * x, p.y + t * y};
}

std::vector<std::pair<ContourId, Contour>> BoundaryTrace::contours(double cut) const {
  std::vector<std::pair<ContourId, Contour>> result;
  std::vector<bool> done(pieces_.size(), false);
  for (std::size_t start = 0; start < pieces_.size(); ++start) {
    if (done[start]) continue;
    Contour contour;
    std::size_t piece = start;
    NodeId n = pieces_[start].b;
    do {
      done[piece] = true;
      const NodePieces& here = at_node_[n];
      const auto in = static_cast<std::size_t>(
          std::find(here.pieces.begin(), here.pieces.end(), piece) - here.pieces.begin());
      const std::size_t next = here.pieces[here.partner[in]];
      if (here.cut[in]) {
        contour.vertices.push_back(near_node(n, piece, cut));
        contour.vertices.push_back(near_node(n, next, cut));
      } else {
        contour.vertices.push_back(at(n));
      }
      piece = next;
      n = other_end(piece, n);
    } while (piece != start);
    result.emplace_back(pieces_[start].contour, std::move(contour));
  }
  return result;
}

}  // namespace tetloft::internal::sections
