// See nearer.hpp.
#include "delaunay3/nearer.hpp"

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "predicates/counting.hpp"
#include "predicates/exact.hpp"
#include "predicates/filter.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

using predicates::Stages;

}  // namespace

int turn_between(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  // The derivation of orient2d_filter holds: all four factors are differences.
  const double left = (b.x - a.x) * (d.y - c.y);
  const double right = (b.y - a.y) * (d.x - c.x);
  const double bound =
      predicates::kOrient2dError * (std::abs(left) + std::abs(right)) + predicates::kOrient2dTiny;
  if (const int s = predicates::certain_sign(left - right, bound); s != 0) return s;
  return static_cast<int>(predicates::exact_cross(a, b, c, d).sign);
}

// The ray dual to a hull edge leaves to the left of the ghost's half-edge 0. Parallel to the
// bisector it stays on the side where it starts.
bool Bisector::decide_ghost(TriangleId t) const {
  const PlaneDiagram& centres = *planes_->centres;
  const HalfEdgeId hull = PlaneDiagram::half_edge(t, 0);
  const int turn = turn_between(b_, a_, centres.point(centres.origin(hull)),
                                centres.point(centres.destination(hull)));
  return turn != 0 ? turn < 0 : nearer_to_first(centres.right(hull));
}

bool Bisector::look_closer(TriangleId t) const {
  // |c − q|² − |c − p|² = (p − q) · ((c − p) + (c − q)). Rounding: at most 2 u in each sum
  // of two differences, relative to their magnitudes, and u for the other difference, the
  // product and the last sum: 5 u, raised by one for higher orders. The circumcentre's own
  // error counts twice. Underflow: see orient2d_filter. Overflow: no product exceeds 2^805.
  constexpr double kError = 6 * 0x1p-53;
  constexpr double kCentre = 2 + 0x1p-40;
  constexpr double kUnderflow = 0x1p-900;
  const Circumcentre& c = planes_->centres->centre(t);
  const double ax = c.x - a_.x, bx = c.x - b_.x;
  const double ay = c.y - a_.y, by = c.y - b_.y;
  const double value = ex_ * (ax + bx) + ey_ * (ay + by);
  const double bound = kError * (std::abs(ex_) * (std::abs(ax) + std::abs(bx)) +
                                 std::abs(ey_) * (std::abs(ay) + std::abs(by))) +
                       (kCentre * size_ * c.radius + kUnderflow);
  return std::abs(value) > bound ? value > 0 : decide(t);
}

bool Bisector::decide(TriangleId t) const {
  if (planes_->centres->is_ghost(t)) return decide_ghost(t);
  const auto corner = [&](std::uint32_t i) {
    return planes_->centres->apex(PlaneDiagram::half_edge(t, i % 3));
  };
  const auto at = [&](std::uint32_t i) -> const Point2& {
    return planes_->centres->point(corner(i));
  };
  if (const int s = predicates::two_plane_insphere_filter(a_, b_, at(0), at(1), at(2)); s != 0) {
    predicates::count_answer(&PredicateCounters::insphere, &Stages::filter);
    return s > 0;
  }
  const predicates::Answer exact =
      predicates::exact_two_plane_insphere(a_, b_, at(0), at(1), at(2));
  if (exact.sign != Sign::zero) {
    predicates::count_answer(&PredicateCounters::insphere, exact.stage);
    return exact.sign == Sign::positive;
  }
  // Cospherical. The latest of the five in canonical order (by plane, then as ids) is raised
  // by infinitely more than the others. A raised site is farther from everything.
  predicates::count_answer(&PredicateCounters::insphere, &Stages::symbolic);
  if (planes_->sites_above) return p_ < q_;
  // A raised corner attracts the circumcentre along the bisector of the edge opposite, to its
  // left. Where that edge is parallel to p q this leads to neither, and the next corner decides.
  // Triangles start at their lowest vertex.
  const std::uint32_t latest = corner(1) < corner(2) ? 2 : 1;
  for (const std::uint32_t i : {latest, 3 - latest}) {
    if (const int turn = turn_between(at(i + 1), at(i + 2), a_, b_); turn != 0) return turn < 0;
  }
  TETLOFT_CHECK(false);  // two edges of a triangle are not parallel
}

}  // namespace tetloft::internal::delaunay3_detail
