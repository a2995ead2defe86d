// Reverse tetrahedra without a 3D triangulation (Nonato et al. 2000, Definition 2 and
// Proposition 1): a tet with an edge in each plane belongs to D iff the Voronoi edges dual
// to its two edges cross.
//
// Candidates are pairs of edges whose Voronoi edges, in boxes that rounding cannot fool,
// come near; whether the tet (a, b, c, d) of edges (a, b) and (c, d) belongs to D is decided
// by insphere_perturbed against the vertices opposite the edges in their (one or two)
// triangles each. Why that local test suffices: README.md, "Reverse tetrahedra".
#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include <tetloft/conforming_section.hpp>
#include <tetloft/predicates.hpp>

#include "check/box_tree.hpp"
#include "check/interval.hpp"
#include "check/partition.hpp"
#include "sections/scaling.hpp"

namespace tetloft::internal::checking {

namespace {

constexpr double kEndOfRay = std::numeric_limits<double>::infinity();

// A section with the boxes of its Voronoi vertices and edges.
struct Diagram {
  ConformingSection section;
  std::vector<Box2> edge_box;  // by EdgeId
};

// A box around the circumcentre of (a, b, c).
Box2 circumcentre_box(const Point2& a, const Point2& b, const Point2& c) {
  const Interval bx = Interval(b.x) - a.x;
  const Interval by = Interval(b.y) - a.y;
  const Interval cx = Interval(c.x) - a.x;
  const Interval cy = Interval(c.y) - a.y;
  const Interval b2 = bx * bx + by * by;
  const Interval c2 = cx * cx + cy * cy;
  const Interval twice = Interval(2) * (bx * cy - by * cx);
  const Interval x = Interval(a.x) + (cy * b2 - by * c2) / twice;
  const Interval y = Interval(a.y) + (bx * c2 - cx * b2) / twice;
  return {{x.low, y.low}, {x.high, y.high}};
}

// Extends a box without end along a direction, of which only the signs count.
void extend(Box2& box, int sign_x, int sign_y) {
  if (sign_x > 0) box.high.x = kEndOfRay;
  if (sign_x < 0) box.low.x = -kEndOfRay;
  if (sign_y > 0) box.high.y = kEndOfRay;
  if (sign_y < 0) box.low.y = -kEndOfRay;
}

int compare(double a, double b) { return a < b ? -1 : (a > b ? 1 : 0); }

Diagram make_diagram(ConformingSection section) {
  Diagram diagram{std::move(section), {}};
  const Triangulation2& triangulation = diagram.section.triangulation;
  std::vector<Box2> centre;
  for (const PlaneTriangleVertices& t : triangulation.triangles) {
    centre.push_back(circumcentre_box(triangulation.points[t[0]], triangulation.points[t[1]],
                                      triangulation.points[t[2]]));
  }
  for (const ConformingSection::Edge& edge : diagram.section.edges) {
    const TriangleId inner = edge.left.valid() ? edge.left : edge.right;
    Box2 box = centre[inner.index()];
    if (edge.left.valid() && edge.right.valid()) {
      box.include(centre[edge.right.index()]);
    } else {
      // A ray, away from the triangle: to the right of a → b is (dy, −dx).
      const Point2& a = diagram.section.point(edge.a);
      const Point2& b = diagram.section.point(edge.b);
      const int dx = compare(b.x, a.x);
      const int dy = compare(b.y, a.y);
      if (edge.left.valid()) {
        extend(box, dy, -dx);
      } else {
        extend(box, -dy, dx);
      }
    }
    diagram.edge_box.push_back(box);
  }
  return diagram;
}

// The vertices opposite an edge in its triangles; fewer than two on the convex hull.
std::vector<Point3> opposite_vertices(const ConformingSection& section,
                                      const ConformingSection::Edge& edge) {
  std::vector<Point3> opposite;
  for (const TriangleId t : {edge.left, edge.right}) {
    if (!t.valid()) continue;
    for (const PlaneVertexId v : section.triangulation.triangles[t]) {
      if (v != edge.a && v != edge.b) opposite.push_back(section.point3(v));
    }
  }
  return opposite;
}

bool is_delaunay_tet(const ConformingSection& below, const ConformingSection::Edge& lower,
                     const ConformingSection& above, const ConformingSection::Edge& upper) {
  Point3 a = below.point3(lower.a);
  Point3 b = below.point3(lower.b);
  const Point3 c = above.point3(upper.a);
  const Point3 d = above.point3(upper.b);
  const Sign orientation = orient3d(a, b, c, d);
  if (orientation == Sign::zero) return false;  // parallel edges span no tet
  if (orientation == Sign::negative) std::swap(a, b);
  const auto outside = [&](const Point3& p) {
    return insphere_perturbed(a, b, c, d, p) == Sign::negative;
  };
  const auto all_outside = [&](const std::vector<Point3>& points) {
    return std::all_of(points.begin(), points.end(), outside);
  };
  return all_outside(opposite_vertices(below, lower)) &&
         all_outside(opposite_vertices(above, upper));
}

class SlabLinks {
 public:
  SlabLinks(const Diagram& below, const Diagram& above) : below_(below), above_(above) {}

  /// Pairs (region below, region above) of all reverse tets.
  std::set<std::pair<RegionId, RegionId>> run() {
    std::vector<EdgeId> lower_edges;
    std::vector<Box2> lower_boxes;
    for (std::size_t e = 0; e < below_.section.edges.size(); ++e) {
      if (below_.section.edges[EdgeId(e)].kind == EdgeKind::contour) continue;
      lower_edges.push_back(EdgeId(e));
      lower_boxes.push_back(below_.edge_box[e]);
    }
    const BoxTree tree(std::move(lower_boxes));
    for (std::size_t e = 0; e < above_.section.edges.size(); ++e) {
      const ConformingSection::Edge& upper = above_.section.edges[EdgeId(e)];
      if (upper.kind == EdgeKind::contour) continue;
      tree.meeting(above_.edge_box[e], [&](std::uint32_t i) {
        const ConformingSection::Edge& lower = below_.section.edges[lower_edges[i]];
        const bool reverse = lower.kind == EdgeKind::internal || upper.kind == EdgeKind::internal;
        if (reverse && !known(lower, upper) &&
            is_delaunay_tet(below_.section, lower, above_.section, upper)) {
          for (const auto& link : links_of(lower, upper)) links_.insert(link);
        }
        return true;
      });
    }
    return std::move(links_);
  }

 private:
  using Links = std::array<std::pair<RegionId, RegionId>, 4>;
  [[nodiscard]] Links links_of(const ConformingSection::Edge& lower,
                               const ConformingSection::Edge& upper) const {
    const RegionId a = below_.section.region[lower.a];
    const RegionId b = below_.section.region[lower.b];
    const RegionId c = above_.section.region[upper.a];
    const RegionId d = above_.section.region[upper.b];
    return {{{a, c}, {a, d}, {b, c}, {b, d}}};
  }
  // Most candidates would only tell again what earlier ones did.
  [[nodiscard]] bool known(const ConformingSection::Edge& lower,
                           const ConformingSection::Edge& upper) const {
    const Links links = links_of(lower, upper);
    return std::all_of(links.begin(), links.end(),
                       [&](const auto& link) { return links_.count(link) != 0; });
  }

  const Diagram& below_;
  const Diagram& above_;
  std::set<std::pair<RegionId, RegionId>> links_;
};

}  // namespace

Result<std::vector<Link>> reverse_links(const SectionStack& refined, const Regions& regions) {
  // Far from 1 the boxes would be so wide that all pairs of edges are candidates.
  const int exponent = sections::unit_of(refined).exponent();
  const SectionStack in_unit = sections::scaled(refined, exponent);
  std::vector<Link> links;
  Diagram below;
  for (std::size_t s = 0; s < in_unit.sections.size(); ++s) {
    auto conforming = conform(in_unit.sections[SectionId(s)], SectionId(s));
    if (!conforming.ok()) {
      Error error = conforming.error();
      if (error.where.point) error.where.point = scaled(*error.where.point, -exponent);
      return error;
    }
    Diagram above = make_diagram(*std::move(conforming));
    if (s > 0) {
      // Regions of the refined section may be numbered differently: a contour tells.
      const auto global = [&](std::size_t section, const Diagram& diagram, RegionId region) {
        return regions.of(section, diagram.section.nesting.outer[region].index());
      };
      for (const auto& [lower, upper] : SlabLinks(below, above).run()) {
        links.push_back({global(s - 1, below, lower), global(s, above, upper)});
      }
    }
    below = std::move(above);
  }
  std::sort(links.begin(), links.end());
  return links;
}

}  // namespace tetloft::internal::checking
