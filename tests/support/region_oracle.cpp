#include "support/region_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetloft::oracle {

namespace {

Polygon polygon_of(const std::vector<Point2>& vertices) {
  Polygon polygon;
  for (const Point2& p : vertices) polygon.push_back(exactly(p));
  return polygon;
}

// Twice.
Rational area_of(const std::vector<Polygon>& outline) {
  Rational area = twice_area(outline[0]).abs();
  for (std::size_t h = 1; h < outline.size(); ++h) area = area - twice_area(outline[h]).abs();
  return area;
}

Point2 lowest(const std::vector<Point2>& vertices) {
  return *std::min_element(vertices.begin(), vertices.end(), [](const Point2& a, const Point2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
}

bool holds(const Region& region, const Point2Q& p) {
  std::size_t around = 0;
  for (const Polygon& polygon : region.outline) around += is_inside(p, polygon) ? 1U : 0U;
  return around % 2 == 1;
}

Rational squared_distance(const Point2Q& p, const Point2Q& a, const Point2Q& b) {
  const Point2Q d{b.x - a.x, b.y - a.y};
  const Point2Q q{p.x - a.x, p.y - a.y};
  const Rational length = d.x * d.x + d.y * d.y;
  const Rational along = d.x * q.x + d.y * q.y;
  if (along <= Rational(0)) return q.x * q.x + q.y * q.y;
  if (along >= length) return (q.x - d.x) * (q.x - d.x) + (q.y - d.y) * (q.y - d.y);
  const Rational across = d.x * q.y - d.y * q.x;
  return across * across / length;
}

struct Edge2 {
  Point2 a, b;
};

std::vector<Edge2> edges_of(const Region& region) {
  std::vector<Edge2> edges;
  for (const auto& contour : region.shape) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      edges.push_back({contour[i], contour[(i + 1) % contour.size()]});
    }
  }
  return edges;
}

// Never more than the distance, but for a rounding.
double at_least(const Edge2& e, const Edge2& f) {
  const auto apart = [](double a, double b, double c, double d) {
    return std::max({0.0, std::min(c, d) - std::max(a, b), std::min(a, b) - std::max(c, d)});
  };
  return std::max(apart(e.a.x, e.b.x, f.a.x, f.b.x), apart(e.a.y, e.b.y, f.a.y, f.b.y));
}

Rational squared_distance(const Edge2& e, const Edge2& f) {
  const Point2Q a = exactly(e.a);
  const Point2Q b = exactly(e.b);
  const Point2Q c = exactly(f.a);
  const Point2Q d = exactly(f.b);
  if (segments_meet(a, b, c, d)) return Rational(0);
  return std::min({squared_distance(a, c, d), squared_distance(b, c, d), squared_distance(c, a, b),
                   squared_distance(d, a, b)});
}

Rational power_of_two(int exponent) { return Rational::exactly(std::ldexp(1.0, exponent)); }

// n · 2^e with 2^31 ≤ n ≤ 2^32, as near as can be: `reaches(y)` tells whether the number is at
// least y, `about` is close to it.
template <class Reaches>
double rounded_by(double about, Reaches&& reaches) {
  int e = std::ilogb(about) - 31;
  while (!reaches(power_of_two(e + 31))) --e;
  while (reaches(power_of_two(e + 32))) ++e;
  const auto reaches_half_below = [&](std::int64_t n) {
    return reaches((Rational(2 * n - 1) / Rational(2)) * power_of_two(e));
  };
  auto n = static_cast<std::int64_t>(std::floor(std::ldexp(about, -e)));
  while (!reaches_half_below(n)) --n;
  while (reaches_half_below(n + 1)) ++n;
  return std::ldexp(static_cast<double>(n), e);
}

}  // namespace

std::vector<Region> regions_of(const SectionStack& stack) {
  std::vector<Region> regions;
  std::size_t number = 0;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    std::vector<std::vector<Point2>> contours;
    std::vector<Polygon> polygons;
    for (const Contour& c : stack.sections[SectionId(s)].contours) {
      contours.push_back(c.vertices);
      polygons.push_back(polygon_of(c.vertices));
    }
    const auto around = [&](std::size_t c) {
      std::vector<std::size_t> result;
      for (std::size_t d = 0; d < polygons.size(); ++d) {
        if (c != d && is_inside(polygons[c][0], polygons[d])) result.push_back(d);
      }
      return result;
    };
    std::vector<Region> here;
    for (std::size_t c = 0; c < polygons.size(); ++c) {
      const std::size_t depth = around(c).size();
      if (depth % 2 == 1) continue;
      Region region{s, {contours[c]}, {polygons[c]}, {}, {number + c}};
      for (std::size_t d = 0; d < polygons.size(); ++d) {
        const auto outside = around(d);
        if (outside.size() != depth + 1 || std::count(outside.begin(), outside.end(), c) == 0) {
          continue;
        }
        region.shape.push_back(contours[d]);
        region.outline.push_back(polygons[d]);
        region.contours.push_back(number + d);
      }
      region.area = area_of(region.outline);
      here.push_back(std::move(region));
    }
    std::sort(here.begin(), here.end(), [](const Region& a, const Region& b) {
      const Point2 p = lowest(a.shape[0]);
      const Point2 q = lowest(b.shape[0]);
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    regions.insert(regions.end(), here.begin(), here.end());
    number += polygons.size();
  }
  return regions;
}

std::optional<Region> moved_by(const Region& region, const Point2& d) {
  Region moved = region;
  for (std::size_t c = 0; c < moved.shape.size(); ++c) {
    for (Point2& p : moved.shape[c]) {
      p = {p.x + d.x, p.y + d.y};
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return std::nullopt;
    }
    moved.outline[c] = polygon_of(moved.shape[c]);
  }
  if (!are_disjoint_simple(moved.outline)) return std::nullopt;
  for (std::size_t h = 1; h < moved.outline.size(); ++h) {
    for (std::size_t c = 0; c < moved.outline.size(); ++c) {
      if (c != h && is_inside(moved.outline[h][0], moved.outline[c]) != (c == 0)) {
        return std::nullopt;
      }
    }
  }
  moved.area = area_of(moved.outline);
  return moved;
}

Bounds bounds(const Region& region) {
  Bounds box{region.shape[0][0], region.shape[0][0]};
  for (const Point2& p : region.shape[0]) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

Rational exact_ratio(const Region& a, const Region& b) {
  const Bounds in_a = bounds(a);
  const Bounds in_b = bounds(b);
  if (in_a.high.x <= in_b.low.x || in_b.high.x <= in_a.low.x || in_a.high.y <= in_b.low.y ||
      in_b.high.y <= in_a.low.y) {
    return Rational(0);
  }
  return Rational(2) * common_area(a.outline, b.outline) / std::min(a.area, b.area);
}

Rational squared_distance(const Region& a, const Region& b) {
  for (const Polygon& polygon : a.outline) {
    if (holds(b, polygon[0])) return Rational(0);
  }
  for (const Polygon& polygon : b.outline) {
    if (holds(a, polygon[0])) return Rational(0);
  }
  std::optional<Rational> least;
  double about = 0;
  for (const Edge2& e : edges_of(a)) {
    for (const Edge2& f : edges_of(b)) {
      if (least.has_value() && at_least(e, f) > about * 1.001) continue;
      const Rational distance = squared_distance(e, f);
      if (least.has_value() && !(distance < *least)) continue;
      least = distance;
      about = std::sqrt(distance.approximate());
    }
  }
  return *least;
}

double rounded(const Rational& x) {
  if (x.sign() == 0) return 0;
  return rounded_by(x.approximate(), [&](const Rational& y) { return x >= y; });
}

double rounded_root(const Rational& x) {
  if (x.sign() == 0) return 0;
  return rounded_by(std::sqrt(x.approximate()), [&](const Rational& y) { return x >= y * y; });
}

}  // namespace tetloft::oracle
