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

struct Vector {
  double x, y;
};

double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
double length_of(const Vector& v) { return std::sqrt(dot(v, v)); }
Vector from_to(const Point2& a, const Point2& b) { return {b.x - a.x, b.y - a.y}; }

// Of the discs on either side of a line with this unit normal that touch it at 0, the one through
// p.
double through(const Vector& normal, const Vector& p) {
  const double height = std::abs(dot(normal, p));
  return height > 0 ? dot(p, p) / height : kNoBound;
}

// The same that touches the segment from p to q between its ends; the disc on the normal's side.
double touching(const Vector& normal, const Vector& p, const Vector& q) {
  const Vector along{q.x - p.x, q.y - p.y};
  const double length = length_of(along);
  Vector out{along.y / length, -along.x / length};  // of the segment, away from 0
  double distance = dot(out, p);
  if (distance < 0) {
    out = {-out.x, -out.y};
    distance = -distance;
  }
  const double turn = 1 + dot(normal, out);
  if (!(turn > 0)) return kNoBound;
  const double radius = distance / turn;
  const Vector touch{radius * (normal.x + out.x), radius * (normal.y + out.y)};
  const double place = dot({touch.x - p.x, touch.y - p.y}, along);
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
  const Vector along = from_to(low, high);
  const double length = length_of(along);
  const Vector normal{along.y / length, -along.x / length};
  const Vector opposite{-normal.x, -normal.y};
  double width = most;
  tree_.query_nearest(
      middle,
      [&](std::size_t k) {
        const Edge& edge = edges_[k];
        if (edge.low == low && edge.high == high) return;
        const Vector p = from_to(middle, edge.low);
        const Vector q = from_to(middle, edge.high);
        width = std::min({width, through(normal, p), through(normal, q), touching(normal, p, q),
                          touching(opposite, p, q)});
      },
      [&] { return width * kRoundedUp; });
  return width;
}

}  // namespace tetloft::internal::sections
