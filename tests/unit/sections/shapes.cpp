#include "unit/sections/shapes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "support/exact/predicates.hpp"

namespace tetloft::testing {

using oracle::Rational;

Contour contour(std::initializer_list<Point2> vertices) { return {vertices}; }

Contour rectangle(double x0, double y0, double x1, double y1) {
  return contour({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

Section section(double z, std::vector<Contour> contours) {
  Section result;
  result.z = z;
  result.contours = IdVector<ContourId, Contour>(std::move(contours));
  return result;
}

SectionStack stack(std::vector<Section> sections) {
  SectionStack result;
  result.sections = IdVector<SectionId, Section>(std::move(sections));
  return result;
}

SectionStack one(std::vector<Contour> contours) { return stack({section(0, std::move(contours))}); }

Contour random_star(Prng& prng, int x, int y, int radius, int points) {
  struct Direction {
    int x, y;
    [[nodiscard]] bool upper() const { return y > 0 || (y == 0 && x > 0); }
  };
  const auto draw = [&] {
    const auto range = static_cast<std::uint64_t>(2 * radius + 1);
    return Direction{static_cast<int>(prng.below(range)) - radius,
                     static_cast<int>(prng.below(range)) - radius};
  };
  // The axes make sure that the centre is inside.
  std::vector<Direction> directions{{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}};
  while (static_cast<int>(directions.size()) < points + 4) {
    const Direction d = draw();
    if (d.x != 0 || d.y != 0) directions.push_back(d);
  }
  const auto cross = [](const Direction& a, const Direction& b) {
    return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
  };
  std::stable_sort(directions.begin(), directions.end(),
                   [&](const Direction& a, const Direction& b) {
                     return a.upper() != b.upper() ? a.upper() : cross(a, b) > 0;
                   });
  Contour result;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const Direction& d = directions[k];
    if (k > 0 && directions[k - 1].upper() == d.upper() && cross(directions[k - 1], d) == 0) {
      continue;
    }
    result.vertices.push_back({static_cast<double>(x + d.x), static_cast<double>(y + d.y)});
  }
  return result;
}

Contour reversed(const Contour& contour) {
  Contour result = contour;
  std::reverse(result.vertices.begin(), result.vertices.end());
  return result;
}

Contour rotated(const Contour& contour, std::size_t by) {
  Contour result = contour;
  std::rotate(result.vertices.begin(),
              result.vertices.begin() + static_cast<std::ptrdiff_t>(by % contour.vertices.size()),
              result.vertices.end());
  return result;
}

Contour moved(const Contour& contour, double factor, Point2 offset) {
  Contour result = contour;
  for (Point2& p : result.vertices) p = {p.x * factor + offset.x, p.y * factor + offset.y};
  return result;
}

namespace {

struct RationalPoint {
  Rational x, y;
};

RationalPoint exactly(const Point2& p) { return {Rational::exactly(p.x), Rational::exactly(p.y)}; }

Rational turn(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

using Polygon = std::vector<RationalPoint>;

Rational twice_signed_area(const Polygon& polygon) {
  Rational sum;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const RationalPoint& p = polygon[k];
    const RationalPoint& q = polygon[(k + 1) % polygon.size()];
    sum = sum + p.x * q.y - p.y * q.x;
  }
  return sum;
}

// The part of a convex polygon to the left of a → b (Sutherland and Hodgman).
Polygon clip(const Polygon& polygon, const RationalPoint& a, const RationalPoint& b) {
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const RationalPoint& p = polygon[k];
    const RationalPoint& q = polygon[(k + 1) % polygon.size()];
    const Rational at_p = turn(a, b, p);
    const Rational at_q = turn(a, b, q);
    if (at_p.sign() >= 0) result.push_back(p);
    if (at_p.sign() * at_q.sign() < 0) {
      const Rational t = at_p / (at_p - at_q);
      result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return result;
}

struct SignedTriangle {
  Polygon corners;  // counter-clockwise
  int sign;
};

std::vector<SignedTriangle> fans(const std::vector<Contour>& region) {
  std::vector<SignedTriangle> result;
  for (std::size_t k = 0; k < region.size(); ++k) {
    Polygon polygon;
    for (const Point2& p : region[k].vertices) polygon.push_back(exactly(p));
    const int direction = twice_signed_area(polygon).sign() * (k == 0 ? 1 : -1);
    for (std::size_t v = 1; v + 1 < polygon.size(); ++v) {
      Polygon triangle{polygon[0], polygon[v], polygon[v + 1]};
      const int sign = twice_signed_area(triangle).sign();
      if (sign == 0) continue;
      if (sign < 0) std::swap(triangle[1], triangle[2]);
      result.push_back({std::move(triangle), sign * direction});
    }
  }
  return result;
}

}  // namespace

bool is_inside(const Contour& contour, const Rational& x, const Rational& y) {
  bool inside = false;
  for (std::size_t v = 0; v < contour.vertices.size(); ++v) {
    RationalPoint a = exactly(contour.vertices[v]);
    RationalPoint b = exactly(contour.vertices[(v + 1) % contour.vertices.size()]);
    if ((a.y > y) == (b.y > y)) continue;
    if (a.y > b.y) std::swap(a, b);
    if (turn(a, b, {x, y}).sign() > 0) inside = !inside;
  }
  return inside;
}

bool is_inside(const Contour& contour, const Point2& p) {
  return is_inside(contour, Rational::exactly(p.x), Rational::exactly(p.y));
}

Rational overlap_by_clipping(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  Rational sum;
  for (const SignedTriangle& s : fans(a)) {
    for (const SignedTriangle& t : fans(b)) {
      Polygon common = s.corners;
      for (std::size_t k = 0; k < 3; ++k) {
        common = clip(common, t.corners[k], t.corners[(k + 1) % 3]);
      }
      const Rational area = twice_signed_area(common) / Rational(2);
      sum = s.sign == t.sign ? sum + area : sum - area;
    }
  }
  return sum;
}

Rational exact_area(const std::vector<Contour>& region) {
  Rational sum;
  for (const SignedTriangle& t : fans(region)) {
    const Rational area = twice_signed_area(t.corners) / Rational(2);
    sum = t.sign > 0 ? sum + area : sum - area;
  }
  return sum;
}

RegionOutline outline_of(const std::vector<Contour>& region) {
  RegionOutline result;
  for (const Contour& c : region) result.contours.push_back(&c);
  return result;
}

}  // namespace tetloft::testing
