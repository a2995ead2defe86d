#include "support/guarantee_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "support/rational_geometry.hpp"

namespace tetloft::oracle {

namespace {

using Face = std::array<std::size_t, 3>;
using Edge = std::array<std::size_t, 2>;

template <std::size_t N>
std::array<std::size_t, N> sorted(std::array<std::size_t, N> ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}

class Oracle {
 public:
  Oracle(const Model& model, const SectionStack& stack, const CheckOptions& options)
      : model_(model), stack_(stack), options_(options) {}

  GuaranteeVerdicts run() {
    bool well_formed = true;
    for (const TetVertices& tet : model_.tets) {
      std::set<std::size_t> distinct;
      for (const VertexId v : tet) distinct.insert(v.index());
      well_formed =
          well_formed && distinct.size() == 4 && *distinct.rbegin() < model_.points.size();
    }
    bool finite = true;
    for (const Point3& p : model_.points) {
      finite = finite && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    }
    if (!well_formed) violate(1, "malformed tet");
    if (!finite) violate(3, "not finite");
    if (!well_formed || !finite) {
      verdict_.holds[1] = verdict_.holds[3] = std::nullopt;
      verdict_.holds[well_formed ? 0 : 2] = std::nullopt;
      return verdict_;
    }
    for (const Point3& p : model_.points) points_.push_back(exactly(p));
    for (const TetVertices& tet : model_.tets) {
      tets_.push_back({tet[0].index(), tet[1].index(), tet[2].index(), tet[3].index()});
    }
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      for (const std::size_t v : tets_[t]) star_[v].push_back(t);
      for (const Face& face : faces(t)) uses_[sorted(face)].push_back({t, face});
    }
    manifold();
    for (std::size_t s = 0; s < stack_.sections.size(); ++s) resample(s);
    crossing();
    embedded();
    components();
    return verdict_;
  }

 private:
  struct Use {
    std::size_t tet;
    Face outward;
  };

  void violate(std::size_t guarantee, const std::string& reason) {
    verdict_.holds[guarantee - 1] = false;
    verdict_.reasons += std::to_string(guarantee) + ": " + reason + "\n";
  }

  [[nodiscard]] std::array<Face, 4> faces(std::size_t t) const {
    const auto& [a, b, c, d] = tets_[t];
    return {{{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}}};
  }

  [[nodiscard]] double z(std::size_t s) const { return stack_.sections[SectionId(s)].z; }
  [[nodiscard]] double height(std::size_t v) const { return model_.points[VertexId(v)].z; }
  [[nodiscard]] Point2Q below(std::size_t v) const { return {points_[v].x, points_[v].y}; }

  // ---- 1 ----

  static bool same_rotation(const Face& a, const Face& b) {
    return a == b || a == Face{b[1], b[2], b[0]} || a == Face{b[2], b[0], b[1]};
  }

  void manifold() {
    bool faces_good = true;
    for (const auto& [face, uses] : uses_) {
      if (uses.size() > 2 ||
          (uses.size() == 2 && same_rotation(uses[0].outward, uses[1].outward))) {
        faces_good = false;
      }
    }
    if (!faces_good) violate(1, "face");
    for (std::size_t v = 0; v < points_.size(); ++v) {
      bool in_plane = false;
      for (std::size_t s = 0; s < stack_.sections.size(); ++s) in_plane |= height(v) == z(s);
      if (star_.count(v) == 0) {
        if (!in_plane) violate(1, "spare vertex");
      } else if (faces_good && !has_regular_link(v)) {
        violate(1, "link of " + std::to_string(v));
      }
    }
  }

  [[nodiscard]] bool has_regular_link(std::size_t v) const {
    std::vector<Face> triangles;
    for (const std::size_t t : star_.at(v)) {
      for (const Face& face : faces(t)) {
        if (std::count(face.begin(), face.end(), v) == 0) triangles.push_back(face);
      }
    }
    std::map<Edge, std::vector<std::size_t>> sides;
    std::map<std::size_t, std::vector<std::size_t>> around;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const Face& f = triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        sides[sorted(Edge{f[k], f[(k + 1) % 3]})].push_back(i);
        around[f[k]].push_back(i);
      }
    }
    // Connected as a whole, and around each of its vertices, through shared edges.
    const auto connected = [&](const std::vector<std::size_t>& among, const auto& counts) {
      std::set<std::size_t> reached{among[0]};
      for (bool grown = true; grown;) {
        grown = false;
        for (const auto& [edge, two] : sides) {
          if (two.size() != 2 || !counts(edge)) continue;
          if (reached.count(two[0]) != reached.count(two[1])) {
            reached.insert(two[0]);
            reached.insert(two[1]);
            grown = true;
          }
        }
      }
      return reached.size() == among.size();
    };
    std::vector<std::size_t> all(triangles.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    bool good = connected(all, [](const Edge&) { return true; });
    for (const auto& [w, fan] : around) {
      good = good && connected(fan, [w = w](const Edge& e) { return e[0] == w || e[1] == w; });
    }
    bool closed = true;
    for (const auto& [edge, two] : sides) {
      good = good && two.size() <= 2;
      closed = closed && two.size() == 2;
    }
    const auto euler = static_cast<long>(around.size()) - static_cast<long>(sides.size()) +
                       static_cast<long>(triangles.size());
    return good && euler == (closed ? 2 : 1);
  }

  // ---- 2 ----

  void crossing() {
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

  // The contours of a section with the vertices inserted into each edge; region outlines
  // by contour. Empty where the vertices in the plane are not those of the contours.
  std::vector<Polygon> refined_contours(std::size_t s, std::vector<std::vector<std::size_t>>& ids) {
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
      if (input.count(v) != 0) continue;
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
        auto& inserted = on[{c, i}];
        std::sort(inserted.begin(), inserted.end());
        for (std::size_t k = 0; k < inserted.size(); ++k) {
          if (k > 0 && inserted[k].first == inserted[k - 1].first) violate(2, "fold");
          ids.back().push_back(inserted[k].second);
        }
      }
      polygons.emplace_back();
      for (const std::size_t v : ids.back()) polygons.back().push_back(below(v));
    }
    return polygons;
  }

  static Polygon input_polygon(const Contour& contour) {
    Polygon polygon;
    for (const Point2& p : contour.vertices) polygon.push_back(exactly(p));
    return polygon;
  }

  void resample(std::size_t s) {
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
          ++(height(v) < z(s)
                 ? triangles[face].below
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
      for (std::size_t k = 0; k < 3; ++k)
        ++triangle_edges[sorted(Edge{face[k], face[(k + 1) % 3]})];
    }
    for (const Edge& edge : edges) {
      if (triangle_edges.count(edge) == 0) violate(2, "edge in the plane");
    }
    std::vector<std::vector<std::size_t>> ids;
    const std::vector<Polygon> contours = refined_contours(s, ids);
    if (contours.size() != stack_.sections[SectionId(s)].contours.size()) return;
    if (!are_disjoint_simple(contours)) {
      violate(2, "refined contours touch");
      return;
    }
    // The region's area, each contour counted by its depth.
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
    for (std::size_t i = 0; i < corners.size(); ++i) {
      area = area - twice_area(corners[i]).abs();
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
    if (area.sign() != 0) violate(2, "area");
    for (const auto& chain : ids) {
      for (std::size_t k = 0; k < chain.size(); ++k) {
        const auto found =
            triangle_edges.find(sorted(Edge{chain[k], chain[(k + 1) % chain.size()]}));
        if (found == triangle_edges.end() || found->second != 1) violate(2, "contour edge");
      }
    }
  }

  // ---- 3 ----

  template <std::size_t N>
  [[nodiscard]] std::array<Point3Q, N> corners(const std::array<std::size_t, N>& ids) const {
    std::array<Point3Q, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = points_[ids[i]];
    return result;
  }

  template <std::size_t N>
  [[nodiscard]] bool boxes_meet(const std::array<std::size_t, N>& a,
                                const std::array<std::size_t, N>& b) const {
    for (const auto coordinate : {&Point3::x, &Point3::y, &Point3::z}) {
      const auto less = [&](std::size_t v, std::size_t w) {
        return model_.points[VertexId(v)].*coordinate < model_.points[VertexId(w)].*coordinate;
      };
      const auto [low_a, high_a] = std::minmax_element(a.begin(), a.end(), less);
      const auto [low_b, high_b] = std::minmax_element(b.begin(), b.end(), less);
      if (less(*high_a, *low_b) || less(*high_b, *low_a)) return false;
    }
    return true;
  }

  void embedded() {
    bool positive = true;
    for (const auto& tet : tets_) {
      positive =
          positive &&
          volume6(points_[tet[0]], points_[tet[1]], points_[tet[2]], points_[tet[3]]).sign() > 0;
    }
    if (!positive) {
      violate(3, "tet not positive");
      return;
    }
    for (std::size_t i = 0; i < tets_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (boxes_meet(tets_[i], tets_[j]) && tets_overlap(corners(tets_[i]), corners(tets_[j]))) {
          violate(3, "tets overlap");
        }
      }
    }
    std::vector<Face> boundary;
    for (const auto& [face, uses] : uses_) {
      if (uses.size() == 1) boundary.push_back(face);
    }
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (boxes_meet(boundary[i], boundary[j]) && in_contact(boundary[i], boundary[j])) {
          violate(3, "boundary contact");
        }
      }
    }
  }

  [[nodiscard]] bool in_contact(const Face& a, const Face& b) const {
    std::vector<std::size_t> shared;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
    for (const Point3Q& p : triangle_intersection(corners(a), corners(b))) {
      if (shared.empty()) return true;
      if (!on_segment(p, points_[shared.front()], points_[shared.back()])) return true;
    }
    return false;
  }

  // ---- 4 ----

  void components() {
    std::vector<std::size_t> component(tets_.size());
    for (std::size_t t = 0; t < tets_.size(); ++t) component[t] = t;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [face, uses] : uses_) {
        std::size_t least = component[uses[0].tet];
        for (const Use& use : uses) least = std::min(least, component[use.tet]);
        for (const Use& use : uses) {
          changed |= component[use.tet] != least;
          component[use.tet] = least;
        }
      }
    }
    // The components of every contour vertex, inserted ones included by their edges.
    std::vector<std::set<std::size_t>> of_contour;
    std::set<std::size_t> with_contour;
    for (std::size_t s = 0; s < stack_.sections.size(); ++s) {
      for (const Contour& contour : stack_.sections[SectionId(s)].contours) {
        of_contour.emplace_back();
        for (const Point2& p : contour.vertices) {
          for (std::size_t v = 0; v < points_.size(); ++v) {
            if (model_.points[VertexId(v)] != Point3{p.x, p.y, z(s)} || star_.count(v) == 0)
              continue;
            for (const std::size_t t : star_.at(v)) of_contour.back().insert(component[t]);
          }
        }
        with_contour.insert(of_contour.back().begin(), of_contour.back().end());
        if (of_contour.back().size() != 1) violate(4, "contour not on one component");
      }
    }
    for (const std::size_t c : component) {
      if (with_contour.count(c) == 0) violate(4, "component without contour");
    }
    if (options_.correspondence.criterion != Criterion::overlap ||
        !options_.correspondence.labels.empty()) {
      if (!verdict_.holds[3].has_value() || *verdict_.holds[3]) verdict_.holds[3] = std::nullopt;
      return;
    }
    const std::vector<std::size_t> expected = expected_sets();
    for (std::size_t c = 0; c < expected.size(); ++c) {
      for (std::size_t d = 0; d < c; ++d) {
        const bool together = of_contour[c] == of_contour[d];
        if (together != (expected[c] == expected[d])) violate(4, "partition");
      }
    }
  }

  // Sets of contours, all sections in one sequence, by the overlap rule.
  [[nodiscard]] std::vector<std::size_t> expected_sets() const {
    struct Region {
      std::size_t section;
      std::vector<Polygon> outline;
      Rational area;  // twice
      std::vector<std::size_t> contours;
    };
    std::vector<Region> regions;
    std::size_t number = 0;
    for (std::size_t s = 0; s < stack_.sections.size(); ++s) {
      std::vector<Polygon> polygons;
      for (const Contour& contour : stack_.sections[SectionId(s)].contours) {
        polygons.push_back(input_polygon(contour));
      }
      const auto around = [&](std::size_t c) {
        std::vector<std::size_t> result;
        for (std::size_t d = 0; d < polygons.size(); ++d) {
          if (c != d && is_inside(polygons[c][0], polygons[d])) result.push_back(d);
        }
        return result;
      };
      for (std::size_t c = 0; c < polygons.size(); ++c) {
        if (around(c).size() % 2 == 1) continue;
        Region region{s, {polygons[c]}, twice_area(polygons[c]).abs(), {number + c}};
        for (std::size_t d = 0; d < polygons.size(); ++d) {
          const auto outside = around(d);
          if (outside.size() != around(c).size() + 1 ||
              std::count(outside.begin(), outside.end(), c) == 0) {
            continue;
          }
          region.outline.push_back(polygons[d]);
          region.area = region.area - twice_area(polygons[d]).abs();
          region.contours.push_back(number + d);
        }
        regions.push_back(region);
      }
      number += polygons.size();
    }
    struct Pair {
      std::size_t lower, upper;
      bool strong;
    };
    std::vector<Pair> pairs;
    const Rational tau = Rational::exactly(options_.correspondence.tau);
    for (std::size_t i = 0; i < regions.size(); ++i) {
      for (std::size_t j = 0; j < regions.size(); ++j) {
        if (regions[j].section != regions[i].section + 1) continue;
        const Rational common = Rational(2) * common_area(regions[i].outline, regions[j].outline);
        const Rational least = std::min(regions[i].area, regions[j].area);
        if (common > tau * least) pairs.push_back({i, j, Rational(2) * common >= least});
      }
    }
    std::vector<std::size_t> set(number);
    for (std::size_t c = 0; c < number; ++c) set[c] = c;
    const auto unite = [&](std::size_t a, std::size_t b) {
      const std::size_t from = std::max(set[a], set[b]);
      const std::size_t to = std::min(set[a], set[b]);
      std::replace(set.begin(), set.end(), from, to);
    };
    for (const Region& region : regions) {
      for (const std::size_t c : region.contours) unite(region.contours[0], c);
    }
    for (const Pair& pair : pairs) {
      const auto strong_at = [&](auto same) {
        return std::any_of(pairs.begin(), pairs.end(),
                           [&](const Pair& p) { return p.strong && same(p); });
      };
      const bool outruled = !pair.strong &&
                            strong_at([&](const Pair& p) { return p.lower == pair.lower; }) &&
                            strong_at([&](const Pair& p) { return p.upper == pair.upper; });
      if (!outruled) unite(regions[pair.lower].contours[0], regions[pair.upper].contours[0]);
    }
    return set;
  }

  const Model& model_;
  const SectionStack& stack_;
  const CheckOptions& options_;
  std::vector<Point3Q> points_;
  std::vector<std::array<std::size_t, 4>> tets_;
  std::map<std::size_t, std::vector<std::size_t>> star_;
  std::map<Face, std::vector<Use>> uses_;
  GuaranteeVerdicts verdict_{{true, true, true, true}, {}};
};

}  // namespace

GuaranteeVerdicts guarantees(const Model& model, const SectionStack& stack,
                             const CheckOptions& options) {
  return Oracle(model, stack, options).run();
}

}  // namespace tetloft::oracle
