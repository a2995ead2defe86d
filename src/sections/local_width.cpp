#include "sections/local_width.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tetloft::internal::sections {

namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();
// More than what rounding takes from a diameter: what is looked at decides nothing.
constexpr double kRoundedUp = 1 + 0x1p-40;

struct PlaneVector {
  double x, y;
};

double inner_product(const PlaneVector& a, const PlaneVector& b) { return a.x * b.x + a.y * b.y; }
double length_of(const PlaneVector& v) { return std::sqrt(inner_product(v, v)); }
PlaneVector vector_to(const Point2& a, const Point2& b) { return {b.x - a.x, b.y - a.y}; }

// Of the discs on either side of a line with this unit normal that touch it at 0, the one through
// p.
double through(const PlaneVector& normal, const PlaneVector& p) {
  const double height = std::abs(inner_product(normal, p));
  return height > 0 ? inner_product(p, p) / height : kNoBound;
}

// The same that touches the segment from p to q between its ends; the disc on the normal's side.
double touching(const PlaneVector& normal, const PlaneVector& p, const PlaneVector& q) {
  const PlaneVector along{q.x - p.x, q.y - p.y};
  const double length = length_of(along);
  PlaneVector out{along.y / length, -along.x / length};  // of the segment, away from 0
  double distance = inner_product(out, p);
  if (distance < 0) {
    out = {-out.x, -out.y};
    distance = -distance;
  }
  const double turn = 1 + inner_product(normal, out);
  if (!(turn > 0)) return kNoBound;
  const double radius = distance / turn;
  const PlaneVector touch{radius * (normal.x + out.x), radius * (normal.y + out.y)};
  const double place = inner_product({touch.x - p.x, touch.y - p.y}, along);
  return 0 < place && place < length * length ? 2 * radius : kNoBound;
}

}  // namespace

LocalWidth::LocalWidth(const Section& section) : tree_({}) {
  std::vector<Box2> boxes;
  for (const Contour& contour : section.contours) {
    const std::size_t n = contour.vertices.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Point2& a = contour.vertices[k];
      const Point2& b = contour.vertices[(k + 1) % n];
      edges_.push_back(canonical_less(a, b) ? Edge{a, b} : Edge{b, a});
      boxes.push_back(box_of(a, b));
    }
  }
  tree_ = BoxTree2(boxes);
}

double LocalWidth::at_middle(const Point2& a, const Point2& b, double most) const {
  const bool forward = canonical_less(a, b);
  const Point2& low = forward ? a : b;
  const Point2& high = forward ? b : a;
  const Point2 middle{0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
  const PlaneVector along = vector_to(low, high);
  const double length = length_of(along);
  const PlaneVector normal{along.y / length, -along.x / length};
  const PlaneVector opposite{-normal.x, -normal.y};
  double width = most;
  tree_.query_nearest(
      middle,
      [&](std::size_t k) {
        const Edge& edge = edges_[k];
        if (edge.low == low && edge.high == high) return;
        const PlaneVector p = vector_to(middle, edge.low);
        const PlaneVector q = vector_to(middle, edge.high);
        width = std::min({width, through(normal, p), through(normal, q), touching(normal, p, q),
                          touching(opposite, p, q)});
      },
      [&] { return width * kRoundedUp; });
  return width;
}

}  // namespace tetloft::internal::sections
