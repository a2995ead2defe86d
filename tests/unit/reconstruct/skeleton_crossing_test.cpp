// Proposition 1 of Nonato et al. (2000): the slab has a reverse tet on an edge below and an edge
// above iff the Voronoi edges dual to them cross in projection. Crossings are computed in
// rationals, from the vertices alone.
//
// Skeletons that only touch decide nothing: in degenerate positions D is one of several Delaunay
// triangulations, and a tet may or may not be there. So what is tested is that tets have dual
// edges that meet, and that dual edges that cross properly have their tet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "support/exact/rational.hpp"
#include "support/rational_geometry.hpp"
#include "unit/reconstruct/cases.hpp"

namespace tetloft::testing {
namespace {

using oracle::Point2Q;
using oracle::Rational;

Point2Q circumcentre_of(const ConformingSection& section, TriangleId t) {
  const TriangleVertices& v = section.triangulation.triangles[t];
  const Point2Q a = oracle::exactly(section.point(v[0]));
  const Point2Q b = oracle::exactly(section.point(v[1]));
  const Point2Q c = oracle::exactly(section.point(v[2]));
  const Rational bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const Rational b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const Rational twice = Rational(2) * (bx * cy - by * cx);
  return {a.x + (cy * b2 - by * c2) / twice, a.y + (bx * c2 - cx * b2) / twice};
}

// A Voronoi edge, from + t · along with t from 0 to 1, or without end.
struct DualEdge {
  Point2Q from, along;
  bool ray = false;
  // A box around a segment, with room for the rounding of its corners.
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;

  void set_box() {
    const double x = from.x.approximate(), y = from.y.approximate();
    const double dx = along.x.approximate(), dy = along.y.approximate();
    const double room = 1e-9 * (std::abs(x) + std::abs(y) + std::abs(dx) + std::abs(dy));
    low_x = std::min(x, x + dx) - room;
    high_x = std::max(x, x + dx) + room;
    low_y = std::min(y, y + dy) - room;
    high_y = std::max(y, y + dy) + room;
  }
  [[nodiscard]] bool is_far_from(const DualEdge& other) const {
    return !ray && !other.ray &&
           (high_x < other.low_x || other.high_x < low_x || high_y < other.low_y ||
            other.high_y < low_y);
  }
};

DualEdge dual_of(const ConformingSection& section, EdgeId e) {
  const ConformingSection::Edge& edge = section.edges[e];
  const TriangleId inner = edge.left.valid() ? edge.left : edge.right;
  DualEdge dual;
  dual.from = circumcentre_of(section, inner);
  if (edge.left.valid() && edge.right.valid()) {
    const Point2Q to = circumcentre_of(section, edge.right);
    dual.along = {to.x - dual.from.x, to.y - dual.from.y};
    dual.set_box();
    return dual;
  }
  const Point2Q a = oracle::exactly(section.point(edge.a));
  const Point2Q b = oracle::exactly(section.point(edge.b));
  const Rational sign(edge.left.valid() ? 1 : -1);
  dual.along = {sign * (b.y - a.y), sign * (a.x - b.x)};
  dual.ray = true;
  return dual;
}

enum class Meeting { apart, touch, cross };

Meeting meeting_of(const DualEdge& p, const DualEdge& q) {
  const auto cross = [](const Point2Q& u, const Point2Q& v) { return u.x * v.y - u.y * v.x; };
  const Rational zero(0), one(1);
  const Rational denominator = cross(p.along, q.along);
  const Point2Q d{q.from.x - p.from.x, q.from.y - p.from.y};
  // Parallel ones, and those of length zero, can only touch; whether they do is not asked.
  if (denominator == zero) return Meeting::touch;
  const Rational s = cross(d, q.along) / denominator;
  const Rational t = cross(d, p.along) / denominator;
  if (s < zero || t < zero || (!p.ray && s > one) || (!q.ray && t > one)) return Meeting::apart;
  const bool inside = s > zero && t > zero && (p.ray || s < one) && (q.ray || t < one);
  return inside ? Meeting::cross : Meeting::touch;
}

TEST(SkeletonCrossing, IsWhereReverseTetsAre) {
  std::size_t tets = 0, crossings = 0, touching_tets = 0;
  for (const NamedSlab& named : generated_slabs(900, 2)) {
    if (!named.built) continue;
    const Slab& slab = *named.built->slab;
    // Rationals are slow, most of all of coordinates from 1e-150 to 1e150.
    if (slab.vertex_count() > 40 || named.name.starts_with("scale_offset")) continue;
    SCOPED_TRACE(named.name);
    std::set<std::pair<EdgeId, EdgeId>> of_tets;
    for (std::size_t k = 0; k < slab.mesh().tet_slots(); ++k) {
      const TetId t(k);
      if (slab.kind(t) != TetKind::ii && slab.kind(t) != TetKind::ie) continue;
      std::vector<VertexId> low, high;
      for (const VertexId v : slab.mesh().vertices(t)) {
        (slab.is_upper(v) ? high : low).push_back(slab.in_section(v));
      }
      of_tets.emplace(slab.lower().find_edge(low[0], low[1]),
                      slab.upper().find_edge(high[0], high[1]));
    }
    std::vector<DualEdge> above;
    for (std::size_t e = 0; e < slab.upper().edges.size(); ++e) {
      above.push_back(dual_of(slab.upper(), EdgeId(e)));
    }
    for (std::size_t e = 0; e < slab.lower().edges.size(); ++e) {
      const DualEdge below = dual_of(slab.lower(), EdgeId(e));
      const EdgeKind kind = slab.lower().edges[EdgeId(e)].kind;
      for (std::size_t f = 0; f < above.size(); ++f) {
        const EdgeKind other = slab.upper().edges[EdgeId(f)].kind;
        const bool reverse = kind != EdgeKind::contour && other != EdgeKind::contour &&
                             (kind == EdgeKind::internal || other == EdgeKind::internal);
        if (!reverse) continue;
        const bool has_tet = of_tets.contains({EdgeId(e), EdgeId(f)});
        if (!has_tet && below.is_far_from(above[f])) continue;
        const Meeting meeting = meeting_of(below, above[f]);
        tets += has_tet ? 1U : 0U;
        crossings += meeting == Meeting::cross ? 1U : 0U;
        touching_tets += has_tet && meeting == Meeting::touch ? 1U : 0U;
        if (has_tet) {
          EXPECT_NE(meeting, Meeting::apart) << "edges " << e << " and " << f;
        }
        if (meeting == Meeting::cross) {
          EXPECT_TRUE(has_tet) << "edges " << e << " and " << f;
        }
      }
    }
  }
  EXPECT_GT(tets, 15U);
  EXPECT_GT(crossings, 15U);
  EXPECT_GT(touching_tets, 0U);  // the degenerate case is among them
}

}  // namespace
}  // namespace tetloft::testing
