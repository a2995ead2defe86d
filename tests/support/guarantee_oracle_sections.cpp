// Guarantee 2: the triangles in a plane have disjoint interiors, cross no contour, lie in
// the region and have its area; edges of one triangle only are the contours.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "support/guarantee_oracle_parts.hpp"

namespace tetloft::oracle {

void Oracle::crossing() {
  for (const auto& tet : tets_) {
    for (std::size_t s = 0; s < stack_.sections.size(); ++s) {
      const auto above = [&](std::size_t v) { return height(v) > z(s); };
      const auto under = [&](std::size_t v) { return height(v) < z(s); };
      if (std::any_of(tet.begin(), tet.end(), above) &&
          std::any_of(tet.begin(), tet.end(), under)) {
        violate(2, "crossing");
      }
    }
  }
}

std::vector<Polygon> Oracle::refined_contours(std::size_t s, const std::set<std::size_t>& inserted,
                                              std::vector<std::vector<std::size_t>>& ids) {
  const Section& section = stack_.sections[SectionId(s)];
  std::map<std::pair<double, double>, std::size_t> at;
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (height(v) != z(s)) continue;
    const Point3& p = model_.points[VertexId(v)];
    if (!at.emplace(std::pair(p.x + 0.0, p.y + 0.0), v).second) violate(2, "coincident");
  }
  struct Inserted {
    Rational along, distance2;
    std::size_t contour, edge;
  };
  std::set<std::size_t> input;
  for (const Contour& contour : section.contours) {
    for (const Point2& p : contour.vertices) {
      const auto found = at.find({p.x + 0.0, p.y + 0.0});
      if (found == at.end()) {
        violate(2, "input vertex missing");
        return {};
      }
      input.insert(found->second);
    }
  }
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::pair<Rational, std::size_t>>> on;
  for (const auto& [place, v] : at) {
    if (input.count(v) != 0 || inserted.count(v) == 0) continue;
    std::optional<Inserted> best;
    for (std::size_t c = 0; c < section.contours.size(); ++c) {
      const auto& vertices = section.contours[ContourId(c)].vertices;
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Point2& a = vertices[i];
        const Point2& b = vertices[(i + 1) % vertices.size()];
        const Point2Q qa = exactly(a);
        const Point2Q qb = exactly(b);
        const Rational dx = qb.x - qa.x;
        const Rational dy = qb.y - qa.y;
        const Rational length2 = dx * dx + dy * dy;
        const Rational along = (below(v).x - qa.x) * dx + (below(v).y - qa.y) * dy;
        if (along.sign() <= 0 || along >= length2) continue;
        const Rational area = turn(qa, qb, below(v));
        const Rational distance2 = area * area / length2;
        const double largest =
            std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
        const Rational ulp =
            Rational::exactly(std::nextafter(largest, INFINITY)) - Rational::exactly(largest);
        const Rational limit = ulp * Rational::exactly(options_.split_ulps);
        if (distance2 > limit * limit || (best && best->distance2 <= distance2)) continue;
        best = Inserted{along / length2, distance2, c, i};
      }
    }
    if (!best) {
      violate(2, "vertex off the contours");
      return {};
    }
    on[{best->contour, best->edge}].emplace_back(best->along, v);
  }
  std::vector<Polygon> polygons;
  for (std::size_t c = 0; c < section.contours.size(); ++c) {
    ids.emplace_back();
    const auto& vertices = section.contours[ContourId(c)].vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      ids.back().push_back(at.at({vertices[i].x + 0.0, vertices[i].y + 0.0}));
      auto& along = on[{c, i}];
      std::sort(along.begin(), along.end());
      for (std::size_t k = 0; k < along.size(); ++k) {
        if (k > 0 && along[k].first == along[k - 1].first) violate(2, "fold");
        ids.back().push_back(along[k].second);
      }
    }
    polygons.emplace_back();
    for (const std::size_t v : ids.back()) polygons.back().push_back(below(v));
  }
  return polygons;
}

void Oracle::resample(std::size_t s) {
  struct Sides {
    int below = 0, above = 0, within = 0;
  };
  std::map<Face, Sides> triangles;
  std::set<Edge> edges;
  const auto here = [&](std::size_t v) { return height(v) == z(s); };
  for (const auto& [face, uses] : uses_) {
    if (!std::all_of(face.begin(), face.end(), here)) continue;
    for (const Use& use : uses) {
      for (const std::size_t v : tets_[use.tet]) {
        if (std::count(face.begin(), face.end(), v) != 0) continue;
        ++(height(v) < z(s) ? triangles[face].below
                            : (height(v) > z(s) ? triangles[face].above : triangles[face].within));
      }
    }
  }
  for (const auto& tet : tets_) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (here(tet[i]) && here(tet[j])) edges.insert(sorted(Edge{tet[i], tet[j]}));
      }
    }
  }
  std::map<Edge, int> triangle_edges;
  std::vector<Polygon> corners;
  for (const auto& [face, sides] : triangles) {
    corners.push_back({below(face[0]), below(face[1]), below(face[2])});
    if (turn(corners.back()[0], corners.back()[1], corners.back()[2]).sign() == 0) {
      violate(2, "flat triangle");
      return;
    }
    if (sides.below > 1 || sides.above > 1 || sides.within > 0) violate(2, "sides");
    if (s > 0 && sides.below == 0) violate(2, "nothing below");
    if (s + 1 < stack_.sections.size() && sides.above == 0) violate(2, "nothing above");
    for (std::size_t k = 0; k < 3; ++k) ++triangle_edges[sorted(Edge{face[k], face[(k + 1) % 3]})];
  }
  for (const Edge& edge : edges) {
    if (triangle_edges.count(edge) == 0) violate(2, "edge in the plane");
  }
  std::set<std::size_t> on_boundary;
  for (const auto& [edge, count] : triangle_edges) {
    if (count == 1) on_boundary.insert(edge.begin(), edge.end());
  }
  std::vector<std::vector<std::size_t>> ids;
  const std::vector<Polygon> contours = refined_contours(s, on_boundary, ids);
  if (contours.size() != stack_.sections[SectionId(s)].contours.size()) return;
  if (!are_disjoint_simple(contours)) {
    violate(2, "refined contours touch");
    return;
  }
  Rational area = twice_region_area(s, contours);
  for (const Polygon& triangle : corners) area = area - twice_area(triangle).abs();
  if (area.sign() != 0) violate(2, "area");
  triangles_in_region(corners, contours);
  boundary_edges(triangle_edges, ids);
  inner_vertices(s, triangle_edges, contours, ids);
}

Rational Oracle::twice_region_area(std::size_t s, const std::vector<Polygon>& contours) {
  Rational area;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const Polygon before = input_polygon(stack_.sections[SectionId(s)].contours[ContourId(c)]);
    std::size_t depth = 0;
    for (std::size_t d = 0; d < contours.size(); ++d) {
      if (c == d) continue;
      const Polygon other = input_polygon(stack_.sections[SectionId(s)].contours[ContourId(d)]);
      const bool inside = is_inside(contours[c][0], contours[d]);
      depth += inside ? 1 : 0;
      if (inside != is_inside(before[0], other)) violate(2, "nesting changed");
    }
    if (twice_area(before).sign() != twice_area(contours[c]).sign()) violate(2, "turned over");
    area = depth % 2 == 0 ? area + twice_area(contours[c]).abs()
                          : area - twice_area(contours[c]).abs();
  }
  return area;
}

void Oracle::triangles_in_region(const std::vector<Polygon>& corners,
                                 const std::vector<Polygon>& contours) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2Q centre{(corners[i][0].x + corners[i][1].x + corners[i][2].x) / Rational(3),
                         (corners[i][0].y + corners[i][1].y + corners[i][2].y) / Rational(3)};
    bool inside = false;
    for (const Polygon& contour : contours) inside ^= is_inside(centre, contour);
    if (!inside) violate(2, "triangle outside");
    for (std::size_t j = 0; j < i; ++j) {
      if (interiors_meet(corners[i], corners[j])) violate(2, "triangles overlap");
    }
    for (const Polygon& contour : contours) {
      for (std::size_t k = 0; k < contour.size(); ++k) {
        if (interiors_meet(corners[i], {contour[k], contour[(k + 1) % contour.size()]})) {
          violate(2, "triangle across a contour");
        }
      }
    }
  }
}

void Oracle::boundary_edges(const std::map<Edge, int>& triangle_edges,
                            const std::vector<std::vector<std::size_t>>& ids) {
  std::size_t contour_edges = 0;
  for (const auto& chain : ids) {
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const auto found = triangle_edges.find(sorted(Edge{chain[k], chain[(k + 1) % chain.size()]}));
      if (found == triangle_edges.end() || found->second != 1) violate(2, "contour edge");
    }
    contour_edges += chain.size();
  }
  const auto alone = std::count_if(triangle_edges.begin(), triangle_edges.end(),
                                   [](const auto& edge) { return edge.second == 1; });
  if (static_cast<std::size_t>(alone) != contour_edges) violate(2, "edge of one triangle");
}

void Oracle::inner_vertices(std::size_t s, const std::map<Edge, int>& triangle_edges,
                            const std::vector<Polygon>& contours,
                            const std::vector<std::vector<std::size_t>>& ids) {
  std::set<std::size_t> known;
  for (const auto& chain : ids) known.insert(chain.begin(), chain.end());
  std::set<std::size_t> corners;
  for (const auto& [edge, count] : triangle_edges) corners.insert(edge.begin(), edge.end());
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (height(v) != z(s) || known.count(v) != 0) continue;
    bool inside = false;
    for (const Polygon& contour : contours) inside ^= is_inside(below(v), contour);
    if (!inside) violate(2, "vertex outside the region");
    if (corners.count(v) == 0) violate(2, "vertex of no triangle");
  }
}

}  // namespace tetloft::oracle
