#include "support/rational_geometry.hpp"

#include <algorithm>

namespace tetloft::oracle {

namespace {

bool in_range(const Rational& x, const Rational& a, const Rational& b) {
  return std::min(a, b) <= x && x <= std::max(a, b);
}

bool on_segment2(const Point2Q& p, const Point2Q& a, const Point2Q& b) {
  return turn(a, b, p).sign() == 0 && in_range(p.x, a.x, b.x) && in_range(p.y, a.y, b.y);
}

// The part of a convex polygon where the affine function `value` is not negative.
template <class Value>
std::vector<Point3Q> clip(const std::vector<Point3Q>& polygon, Value&& value) {
  std::vector<Point3Q> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3Q& p = polygon[i];
    const Point3Q& q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = value(p);
    const Rational at_q = value(q);
    if (at_p.sign() >= 0) kept.push_back(p);
    if (at_p.sign() * at_q.sign() < 0) {
      const Rational t = at_p / (at_p - at_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)});
    }
  }
  return kept;
}

struct EdgeOver {
  Point2Q left, right;
  bool of_a;
  [[nodiscard]] Rational at(const Rational& x) const {
    return left.y + (right.y - left.y) * (x - left.x) / (right.x - left.x);
  }
};

void add_edges(const std::vector<Polygon>& region, bool of_a, std::vector<EdgeOver>& edges) {
  for (const Polygon& polygon : region) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point2Q& p = polygon[i];
      const Point2Q& q = polygon[(i + 1) % polygon.size()];
      if (p.x == q.x) continue;
      edges.push_back(p.x < q.x ? EdgeOver{p, q, of_a} : EdgeOver{q, p, of_a});
    }
  }
}

}  // namespace

Point2Q exactly(const Point2& p) { return {Rational::exactly(p.x), Rational::exactly(p.y)}; }

Point3Q exactly(const Point3& p) {
  return {Rational::exactly(p.x), Rational::exactly(p.y), Rational::exactly(p.z)};
}

Rational twice_area(const Polygon& polygon) {
  Rational sum;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2Q& p = polygon[i];
    const Point2Q& q = polygon[(i + 1) % polygon.size()];
    sum = sum + (p.x * q.y - p.y * q.x);
  }
  return sum;
}

Rational turn(const Point2Q& a, const Point2Q& b, const Point2Q& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_inside(const Point2Q& p, const Polygon& polygon) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2Q& a = polygon[i];
    const Point2Q& b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y) > p.x) inside = !inside;
  }
  return inside;
}

bool segments_meet(const Point2Q& a, const Point2Q& b, const Point2Q& c, const Point2Q& d) {
  if (on_segment2(a, c, d) || on_segment2(b, c, d) || on_segment2(c, a, b) ||
      on_segment2(d, a, b)) {
    return true;
  }
  return turn(a, b, c).sign() * turn(a, b, d).sign() < 0 &&
         turn(c, d, a).sign() * turn(c, d, b).sign() < 0;
}

bool are_disjoint_simple(const std::vector<Polygon>& polygons) {
  struct Edge {
    std::size_t polygon, index;
    const Point2Q *a, *b;
  };
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const Polygon& polygon = polygons[k];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      edges.push_back({k, i, &polygon[i], &polygon[(i + 1) % polygon.size()]});
      if (*edges.back().a == *edges.back().b) return false;
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge& e = edges[i];
      const Edge& f = edges[j];
      const std::size_t n = polygons[e.polygon].size();
      if (e.polygon == f.polygon && (e.index + 1) % n == f.index) {
        if (on_segment2(*f.b, *e.a, *e.b) || on_segment2(*e.a, *f.a, *f.b)) return false;
      } else if (e.polygon == f.polygon && (f.index + 1) % n == e.index) {
        if (on_segment2(*e.b, *f.a, *f.b) || on_segment2(*f.a, *e.a, *e.b)) return false;
      } else if (segments_meet(*e.a, *e.b, *f.a, *f.b)) {
        return false;
      }
    }
  }
  return true;
}

bool interiors_meet(const Polygon& a, const Polygon& b) {
  for (const Polygon* polygon : {&a, &b}) {
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const Point2Q& p = (*polygon)[i];
      const Point2Q& q = (*polygon)[(i + 1) % polygon->size()];
      if (separates(a, b, [&](const Point2Q& r) { return turn(p, q, r); })) return false;
    }
  }
  return true;
}

Rational common_area(const std::vector<Polygon>& a, const std::vector<Polygon>& b) {
  std::vector<EdgeOver> edges;
  add_edges(a, true, edges);
  add_edges(b, false, edges);
  std::vector<Rational> cuts;
  for (const EdgeOver& e : edges) {
    cuts.push_back(e.left.x);
    cuts.push_back(e.right.x);
    for (const EdgeOver& f : edges) {
      if (!e.of_a || f.of_a) continue;
      const Rational e_slope = (e.right.y - e.left.y) / (e.right.x - e.left.x);
      const Rational f_slope = (f.right.y - f.left.y) / (f.right.x - f.left.x);
      if (e_slope == f_slope) continue;
      const Rational x =
          (f.left.y - f_slope * f.left.x - e.left.y + e_slope * e.left.x) / (e_slope - f_slope);
      if (x > e.left.x && x < e.right.x && x > f.left.x && x < f.right.x) cuts.push_back(x);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  Rational area;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Rational& x0 = cuts[k];
    const Rational& x1 = cuts[k + 1];
    const Rational middle = (x0 + x1) / Rational(2);
    std::vector<std::pair<Rational, const EdgeOver*>> over;
    for (const EdgeOver& e : edges) {
      if (e.left.x <= x0 && e.right.x >= x1) over.emplace_back(e.at(middle), &e);
    }
    std::sort(over.begin(), over.end(),
              [](const auto& e, const auto& f) { return e.first < f.first; });
    bool in_a = false;
    bool in_b = false;
    for (std::size_t i = 0; i < over.size(); ++i) {
      if (i > 0 && in_a && in_b) {
        area = area + (over[i].first - over[i - 1].first) * (x1 - x0);
      }
      bool& inside = over[i].second->of_a ? in_a : in_b;
      inside = !inside;
    }
  }
  return area;
}

std::vector<Point3Q> triangle_intersection(const std::array<Point3Q, 3>& a,
                                           const std::array<Point3Q, 3>& b) {
  const Point3Q normal = cross(difference(b[1], b[0]), difference(b[2], b[0]));
  const auto height = [&](const Point3Q& p) { return dot(normal, difference(p, b[0])); };
  std::vector<Point3Q> polygon(a.begin(), a.end());
  polygon = clip(polygon, height);
  polygon = clip(polygon, [&](const Point3Q& p) { return -height(p); });
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3Q inward = cross(normal, difference(b[(i + 1) % 3], b[i]));
    polygon = clip(polygon, [&](const Point3Q& p) { return dot(inward, difference(p, b[i])); });
  }
  return polygon;
}

bool on_segment(const Point3Q& p, const Point3Q& a, const Point3Q& b) {
  return cross(difference(b, a), difference(p, a)) == Point3Q{} && in_range(p.x, a.x, b.x) &&
         in_range(p.y, a.y, b.y) && in_range(p.z, a.z, b.z);
}

}  // namespace tetloft::oracle
