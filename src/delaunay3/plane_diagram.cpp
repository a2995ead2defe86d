// See plane_diagram.hpp.
#include "delaunay3/plane_diagram.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace tetloft::delaunay3_detail {

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
constexpr double kLargest = 0x1p+160;
constexpr double kLeastDenominator = 0x1p-500;
constexpr double kTiny = 0x1p-399;
// Users of centres compute squares of their distances.
constexpr double kFarthestCentre = 0x1p+400;

Circumcentre circumcentre_with_bound(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double kUnknown = HUGE_VAL;
  const double px = b.x - a.x, py = b.y - a.y;
  const double qx = c.x - a.x, qy = c.y - a.y;
  const double left = px * qy, right = py * qx;
  const double d = 2 * (left - right);
  const double d_error = 2 * kDenominatorError * (std::abs(left) + std::abs(right));
  const double size = std::abs(d);
  const double extent =
      std::max(std::max(std::abs(px), std::abs(py)), std::max(std::abs(qx), std::abs(qy)));
  if (!(extent <= kLargest && size >= kLeastDenominator && 64 * d_error <= size)) {
    return {a.x, a.y, kUnknown};
  }
  const double p2 = px * px + py * py;
  const double q2 = qx * qx + qy * qy;
  const double x = (p2 * qy - q2 * py) / d;
  const double y = (q2 * px - p2 * qx) / d;
  const double n_error = kNumeratorError * (p2 * std::max(std::abs(qx), std::abs(qy)) +
                                            q2 * std::max(std::abs(px), std::abs(py)));
  const double reach = std::max(std::abs(x), std::abs(y));
  if (!(reach <= kFarthestCentre)) return {a.x, a.y, kUnknown};
  const double centre_x = a.x + x;
  const double centre_y = a.y + y;
  const double radius =
      (n_error + reach * d_error) / (size - d_error) +
      kQuotientError * (reach + std::max(std::abs(centre_x), std::abs(centre_y))) + kTiny;
  return {centre_x, centre_y, kHigherOrder * radius};
}

}  // namespace

PlaneDiagram::PlaneDiagram(const Triangulation2& triangulation) : points_(&triangulation.points) {
  const auto& triangles = triangulation.triangles;
  TETLOFT_CHECK(!triangles.empty());
  centre_.reserve(triangles.size());
  for (const TriangleVertices& t : triangles) {
    centre_.push_back(circumcentre_with_bound(point(t[0]), point(t[1]), point(t[2])));
  }

  std::size_t hull = 0;
  for (const auto& across : triangulation.neighbours) {
    for (const TriangleId u : across) hull += u.valid() ? 0U : 1U;
  }
  apex_.reserve(3 * (triangles.size() + hull));
  opposite_.reserve(3 * (triangles.size() + hull));
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const TriangleId t(k);
    for (std::uint32_t i = 0; i < 3; ++i) {
      apex_.push_back(triangles[t][i]);
      const TriangleId u = triangulation.neighbours[t][i];
      if (!u.valid()) {
        opposite_.push_back(HalfEdgeId());
        continue;
      }
      const auto& back = triangulation.neighbours[u];
      const std::uint32_t j = back[0] == t ? 0U : (back[1] == t ? 1U : 2U);
      opposite_.push_back(half_edge(u, j));
    }
  }

  // Each vertex of the hull has one hull edge that leaves it: the convex hull is one cycle.
  IdVector<VertexId, HalfEdgeId> to_ghost(points_->size());
  for (std::size_t k = 0; k < 3 * triangles.size(); ++k) {
    const HalfEdgeId h(k);
    if (opposite_[h].valid()) continue;
    const TriangleId ghost(apex_.size() / 3);
    const VertexId from = origin(h);
    const VertexId to = destination(h);
    for (const VertexId v : {kGhostVertex, to, from}) {
      apex_.push_back(v);
      opposite_.push_back(HalfEdgeId());
    }
    glue(h, half_edge(ghost, 0));
    to_ghost[from] = half_edge(ghost, 1);  // from → ghost
  }
  for (std::size_t k = triangles.size(); k < triangle_count(); ++k) {
    const HalfEdgeId back = half_edge(TriangleId(k), 2);  // ghost → to
    glue(back, to_ghost[destination(back)]);
  }
}

double PlaneDiagram::reach() const {
  double largest = 0;
  for (const Point2& p : *points_) {
    largest = std::max(largest, std::max(std::abs(p.x), std::abs(p.y)));
  }
  return largest;
}

void PlaneDiagram::distrust_centres() {
  for (Circumcentre& c : centre_) c.radius = HUGE_VAL;
}

}  // namespace tetloft::delaunay3_detail
