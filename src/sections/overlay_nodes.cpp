#include "sections/overlay_nodes.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include <tetloft/predicates.hpp>

#include "sections/segments.hpp"

namespace tetloft::internal::sections {

namespace {

// The nodes of one pair of edges; one at an end belongs to the edge that starts there.
void meet(const TwoCurves& curves, std::uint32_t i, std::uint32_t j,
          std::vector<OverlayNode>& nodes) {
  const Point2& a = curves[0]->start(i);
  const Point2& b = curves[0]->end(i);
  const Point2& c = curves[1]->start(j);
  const Point2& d = curves[1]->end(j);
  const Sign side_a = orient2d(c, d, a);
  const Sign side_b = orient2d(c, d, b);
  if (side_a == side_b && side_a != Sign::zero) return;
  if (side_a == Sign::zero) {
    if (a == c) {
      nodes.push_back({{i, j}, {true, true}});
    } else if (strictly_between(c, d, a)) {
      nodes.push_back({{i, j}, {true, false}});
    }
    // Of parallel edges, the start of the other may lie on this one as well.
    if (side_b == Sign::zero && strictly_between(a, b, c)) {
      nodes.push_back({{i, j}, {false, true}});
    }
    return;
  }
  if (side_b == Sign::zero) return;
  const Sign side_c = orient2d(a, b, c);
  if (side_c == Sign::zero) {
    nodes.push_back({{i, j}, {false, true}});
  } else if (orient2d(a, b, d) == -side_c) {
    nodes.push_back({{i, j}, {false, false}});
  }
}

Box2 edge_box(const OverlayCurves& curves, std::uint32_t edge) {
  return box_of(curves.start(edge), curves.end(edge));
}

std::vector<OverlayNode> find_nodes(const TwoCurves& curves) {
  std::vector<OverlayNode> nodes;
  struct BoxedEdge {
    std::uint32_t edge;
    Box2 box;
  };
  std::vector<BoxedEdge> near;
  for (std::size_t k = 0; k < curves[0]->blocks().size(); ++k) {
    const OverlayCurves::Block block = curves[0]->blocks()[k];
    const Box2& box = curves[0]->block_boxes()[k];
    curves[1]->tree().query(box, [&](std::size_t m) {
      const OverlayCurves::Block other = curves[1]->blocks()[m];
      near.clear();
      for (std::uint32_t j = other.first; j < other.last; ++j) {
        const Box2 edge = edge_box(*curves[1], j);
        if (edge.meets(box)) near.push_back({j, edge});
      }
      if (near.empty()) return;
      for (std::uint32_t i = block.first; i < block.last; ++i) {
        const Box2 edge = edge_box(*curves[0], i);
        for (const BoxedEdge& f : near) {
          if (edge.meets(f.box)) meet(curves, i, f.edge, nodes);
        }
      }
    });
  }
  return nodes;
}

// The side of the line of an edge on which all of another edge lies but ends on the line; zero
// where the line parts it.
Sign common_side(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Sign side_c = orient2d(a, b, c);
  const Sign side_d = orient2d(a, b, d);
  if (side_c == Sign::zero) return side_d;
  return side_d == -side_c ? Sign::zero : side_c;
}

// Does the contour of section s pass through p before q, both between the ends of its edge?
bool passes_first(const TwoCurves& curves, std::size_t s, const OverlayNode& p,
                  const OverlayNode& q) {
  const Point2& a = curves[s]->start(p.edge[s]);
  const OverlayCurves& others = *curves[1 - s];
  const std::uint32_t f = p.edge[1 - s];
  const std::uint32_t g = q.edge[1 - s];
  if (p.at_start[1 - s] && q.at_start[1 - s]) {
    return curves[s]->rises(p.edge[s]) ? canonical_less(others.start(f), others.start(g))
                                       : canonical_less(others.start(g), others.start(f));
  }
  // f and g do not cross: the line of one of them, which meets e in that one's node alone, does not
  // part the other one. That is on the side of e's start iff its node is.
  const Sign side_g = common_side(others.start(f), others.end(f), others.start(g), others.end(g));
  if (side_g != Sign::zero) return orient2d(others.start(f), others.end(f), a) != side_g;
  return orient2d(others.start(g), others.end(g), a) ==
         common_side(others.start(g), others.end(g), others.start(f), others.end(f));
}

}  // namespace

OverlayNodes::OverlayNodes(const TwoCurves& curves) : nodes(find_nodes(curves)) {
  for (std::size_t s = 0; s < 2; ++s) {
    passes[s].resize(nodes.size());
    std::iota(passes[s].begin(), passes[s].end(), 0U);
    std::sort(passes[s].begin(), passes[s].end(), [&](std::uint32_t i, std::uint32_t j) {
      const OverlayNode& p = nodes[i];
      const OverlayNode& q = nodes[j];
      if (p.edge[s] != q.edge[s]) return p.edge[s] < q.edge[s];
      if (i == j || q.at_start[s]) return false;
      return p.at_start[s] || passes_first(curves, s, p, q);
    });
    place[s].resize(nodes.size());
    range[s].resize(curves[s]->contour_count(), Range{0, 0});
    for (std::uint32_t k = 0; k < passes[s].size(); ++k) {
      place[s][passes[s][k]] = k;
      Range& r = range[s][curves[s]->contour(nodes[passes[s][k]].edge[s])];
      if (r.last == 0) r.first = k;
      r.last = k + 1;
    }
  }
}

}  // namespace tetloft::internal::sections
