// See plane_diagram.hpp.
#include "delaunay3/plane_diagram.hpp"

#include <algorithm>
#include <cmath>

#include "core/guard.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

constexpr double kRounding = 0x1p-53;  // u

// The circumcentre of a b c is a + n / d with d = 2 p × q, n = |p|² (q.y, −q.x) −
// |q|² (p.y, −p.x), p = b − a, q = c − a. Errors, to first order in u:
// d: two products with 3 roundings each and their difference, (3 + 1) u (|l| + |r|);
// n: 7 roundings at most (difference 1, square 1 more of both factors, sum, difference of the
//    other factor, product: 2 + 1 + 1 + 1 + 1, and the last difference), 7 u (|l| + |r|);
// n / d: (δn + |n / d| δd) / (|d| − δd), one rounding of the quotient and one of the sum.
// The constants below are raised by one, and the whole by 2 %, for all terms of higher order as
// long as δd <= |d| / 64. Underflow: values are below 2^160 and |d| at least 2^-500, so absolute
// errors of at most 2^-1074 · 2^170 in n and d become at most 2^-400 in the quotient and are
// covered by the addend.
constexpr double kDenominatorError = 5 * kRounding;
constexpr double kNumeratorError = 8 * kRounding;
constexpr double kQuotientError = 2 * kRounding;
constexpr double kHigherOrder = 1.02;
constexpr double kSlack = 8 * kRounding;  // see Bisector::nearer_to_first
constexpr double kLargest = 0x1p+160;
constexpr double kLeastDenominator = 0x1p-500;
constexpr double kTiny = 0x1p-399;
// Users of centres compute squares of their distances.
constexpr double kFarthestCentre = 0x1p+400;

// A radius that no filter answers with.
constexpr double kUnknown = HUGE_VAL;

Circumcentre circumcentre_with_bound(const Point2& a, const Point2& b, const Point2& c,
                                     double reach_of_points) {
  if (!(reach_of_points <= kFarthestTrusted)) return {a.x, a.y, kUnknown, kUnknown};
  const double px = b.x - a.x, py = b.y - a.y;
  const double qx = c.x - a.x, qy = c.y - a.y;
  const double left = px * qy, right = py * qx;
  const double d = 2 * (left - right);
  const double d_error = 2 * kDenominatorError * (std::abs(left) + std::abs(right));
  const double size = std::abs(d);
  const double extent =
      std::max(std::max(std::abs(px), std::abs(py)), std::max(std::abs(qx), std::abs(qy)));
  if (!(extent <= kLargest && size >= kLeastDenominator && 64 * d_error <= size)) {
    return {a.x, a.y, kUnknown, kUnknown};
  }
  const double p2 = px * px + py * py;
  const double q2 = qx * qx + qy * qy;
  const double x = (p2 * qy - q2 * py) / d;
  const double y = (q2 * px - p2 * qx) / d;
  const double n_error = kNumeratorError * (p2 * std::max(std::abs(qx), std::abs(qy)) +
                                            q2 * std::max(std::abs(px), std::abs(py)));
  const double reach = std::max(std::abs(x), std::abs(y));
  if (!(reach <= kFarthestCentre)) return {a.x, a.y, kUnknown, kUnknown};
  const double centre_x = a.x + x;
  const double centre_y = a.y + y;
  const double radius =
      (n_error + reach * d_error) / (size - d_error) +
      kQuotientError * (reach + std::max(std::abs(centre_x), std::abs(centre_y))) + kTiny;
  const double whole = kHigherOrder * radius;
  return {centre_x, centre_y, whole,
          kSlack * (std::max(std::abs(centre_x), std::abs(centre_y)) + reach_of_points) +
              (1 + 0x1p-20) * whole};
}

// An order of the triangles in which neighbours in the plane are mostly near in memory: by
// cells of a grid, column by column, up and down in turns. Canonical order is by x alone,
// hence vertices are cut into columns by number. Small sets fit the cache as they are.
IdVector<TriangleId, TriangleId> near_in_memory(const Triangulation2& plane) {
  constexpr std::size_t kSmall = 4096;
  constexpr double kVerticesInCell = 16;
  const std::size_t n = plane.points.size();
  IdVector<TriangleId, TriangleId> order(plane.triangles.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[TriangleId(k)] = TriangleId(k);
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Point2& p : plane.points) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const double extent = high - low;
  if (n < kSmall || !(extent > 0 && extent < HUGE_VAL)) return order;

  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / kVerticesInCell));
  const auto cell_of = [&](TriangleId t) {
    const PlaneVertexId v = plane.triangles[t][0];
    const std::size_t column = v.index() * side / n;
    const double height = (plane.points[v].y - low) / extent;
    const auto row =
        std::min(side - 1, static_cast<std::size_t>(height * static_cast<double>(side)));
    return column * side + (column % 2 == 0 ? row : side - 1 - row);
  };
  std::vector<std::uint32_t> cell(order.size());
  std::vector<std::uint32_t> first(side * side + 1);
  for (std::size_t k = 0; k < order.size(); ++k) {
    cell[k] = static_cast<std::uint32_t>(cell_of(TriangleId(k)));
    ++first[cell[k] + 1];
  }
  for (std::size_t c = 0; c < side * side; ++c) first[c + 1] += first[c];
  for (std::size_t k = 0; k < order.size(); ++k)
    order[TriangleId(first[cell[k]]++)] = TriangleId(k);
  return order;
}

}  // namespace

double reach_of(const IdVector<PlaneVertexId, Point2>& points) {
  double largest = 0;
  for (const Point2& p : points) {
    largest = std::max(largest, std::max(std::abs(p.x), std::abs(p.y)));
  }
  return largest;
}

PlaneDiagram::PlaneDiagram(const Triangulation2& triangulation, double reach)
    : points_(&triangulation.points),
      finite_count_(triangulation.triangles.size()),
      input_of_(near_in_memory(triangulation)),
      place_of_(finite_count_) {
  const auto& triangles = triangulation.triangles;
  TETLOFT_CHECK(!triangles.empty());
  for (std::size_t k = 0; k < triangles.size(); ++k)
    place_of_[input_of_[TriangleId(k)]] = TriangleId(k);

  triangles_.reserve(triangles.size() + triangles.size() / 16 + 16);
  for (const TriangleId t : input_of_) {
    const PlaneTriangleVertices& v = triangles[t];
    triangles_.push_back(
        {v, {}, circumcentre_with_bound(point(v[0]), point(v[1]), point(v[2]), reach)});
  }
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const TriangleId t = input_of_[TriangleId(k)];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const TriangleId u = triangulation.neighbours[t][i];
      if (!u.valid() || u < t) continue;  // a hull edge, or one that is seen from u
      const auto& back = triangulation.neighbours[u];
      // Either as often as the others: a sum, as branches would be foretold wrongly.
      const std::uint32_t side = (back[1] == t ? 1U : 0U) + (back[2] == t ? 2U : 0U);
      glue(half_edge(TriangleId(k), i), half_edge(place_of_[u], side));
    }
  }

  // Each vertex of the hull has one hull edge that leaves it: the convex hull is one cycle.
  IdVector<PlaneVertexId, HalfEdgeId> to_ghost(points_->size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdgeId h = half_edge(TriangleId(k), i);
      if (opposite(h).valid()) continue;
      const TriangleId ghost = triangles_.push_back(
          {{kGhostVertex, destination(h), origin(h)}, {}, {0, 0, kUnknown, kUnknown}});
      glue(h, half_edge(ghost, 0));
      to_ghost[origin(h)] = half_edge(ghost, 1);  // origin → ghost
    }
  }
  for (std::size_t k = triangles.size(); k < triangle_count(); ++k) {
    const HalfEdgeId back = half_edge(TriangleId(k), 2);  // ghost → destination
    glue(back, to_ghost[destination(back)]);
  }
}

}  // namespace tetloft::internal::delaunay3_detail
