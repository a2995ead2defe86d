// Whether two regions overlap, by topology.
//
// Two edges that cross properly leave a common corner of both regions. If none do, the
// boundaries meet in given vertices and along given edges only: edges cut at the vertices
// that lie on them are then equal or meet at ends, and a sweep can tell for every piece
// which regions lie above it.
#include "sections/interiors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/entry.hpp"
#include "sections/nesting.hpp"
#include "sections/segments.hpp"
#include "sections/sweep.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

namespace {

constexpr std::uint8_t kBoth = 3;

// An edge with its ends in canonical order. In sets of regions bit 0 stands for a, bit 1
// for b.
struct OwnedEdge {
  SweepEdge edge;
  std::uint8_t owner;  // the regions whose boundary it is on
  std::uint8_t above;  // those of them that lie above it
};

struct Cut {
  std::uint32_t edge;
  Point2 at;
};

// The edges of `region` that reach into the range of x of `common`. The others decide
// nothing: where they end, the other region is absent.
void collect(const RegionOutline& region, std::uint8_t owner, const Box2& common,
             std::vector<OwnedEdge>& edges) {
  for (std::size_t k = 0; k < region.contours.size(); ++k) {
    const std::vector<Point2>& vertices = region.contours[k]->vertices;
    const bool region_left = is_counter_clockwise(*region.contours[k]) == (k == 0);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const Point2& a = vertices[v];
      const Point2& b = vertices[v + 1 == vertices.size() ? 0 : v + 1];
      const bool forward = canonical_less(a, b);
      const SweepEdge edge = forward ? SweepEdge{a, b} : SweepEdge{b, a};
      if (edge.low.x > common.x1 || common.x0 > edge.high.x) continue;
      edges.push_back({edge, owner, forward == region_left ? owner : std::uint8_t{0}});
    }
  }
}

// Finds where vertices of one region lie in edges of the other. False if two edges cross.
bool find_cuts(const std::vector<OwnedEdge>& edges, std::size_t first_b, std::vector<Cut>& cuts) {
  std::vector<Box2> boxes;
  boxes.reserve(edges.size() - first_b);
  for (std::size_t j = first_b; j < edges.size(); ++j) {
    boxes.push_back(box_of(edges[j].edge.low, edges[j].edge.high));
  }
  const BoxTree2 tree(boxes);
  bool crossing = false;
  for (std::size_t i = 0; i < first_b && !crossing; ++i) {
    const SweepEdge& e = edges[i].edge;
    tree.query(box_of(e.low, e.high), [&](std::size_t k) {
      const std::size_t j = first_b + k;
      const SweepEdge& f = edges[j].edge;
      crossing = crossing || cross(e.low, e.high, f.low, f.high);
      for (const Point2& p : {f.low, f.high}) {
        if (in_segment(e.low, e.high, p)) cuts.push_back({static_cast<std::uint32_t>(i), p});
      }
      for (const Point2& p : {e.low, e.high}) {
        if (in_segment(f.low, f.high, p)) cuts.push_back({static_cast<std::uint32_t>(j), p});
      }
    });
  }
  return !crossing;
}

// Cuts the edges; equal pieces become one with both owners.
std::vector<OwnedEdge> pieces(const std::vector<OwnedEdge>& edges, std::vector<Cut>& cuts) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& c, const Cut& d) {
    return c.edge != d.edge ? c.edge < d.edge : canonical_less(c.at, d.at);
  });
  std::vector<OwnedEdge> result;
  result.reserve(edges.size() + cuts.size());
  auto cut = cuts.begin();
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    Point2 from = edges[i].edge.low;
    for (; cut != cuts.end() && cut->edge == i; ++cut) {
      if (cut->at == from) continue;  // two edges end there
      result.push_back({{from, cut->at}, edges[i].owner, edges[i].above});
      from = cut->at;
    }
    result.push_back({{from, edges[i].edge.high}, edges[i].owner, edges[i].above});
  }
  std::sort(result.begin(), result.end(), [](const OwnedEdge& p, const OwnedEdge& q) {
    return p.edge.low == q.edge.low ? canonical_less(p.edge.high, q.edge.high)
                                    : canonical_less(p.edge.low, q.edge.low);
  });
  std::size_t kept = 0;
  for (const OwnedEdge& piece : result) {
    if (kept > 0 && result[kept - 1].edge.low == piece.edge.low &&
        result[kept - 1].edge.high == piece.edge.high) {
      result[kept - 1].owner |= piece.owner;
      result[kept - 1].above |= piece.above;
    } else {
      result[kept++] = piece;
    }
  }
  result.resize(kept);
  return result;
}

}  // namespace

void require_finite(const Contour& contour) {
  for (const Point2& p : contour.vertices) {
    require_fit(std::isfinite(p.x) && std::isfinite(p.y), "a coordinate is not finite");
  }
}

void require_outline(const RegionOutline& region) {
  require_fit(!region.contours.empty(), "an outline without contour");
  for (const Contour* contour : region.contours) {
    require_fit(contour != nullptr, "an outline with a null contour");
    require_finite(*contour);
  }
}

Box2 bounds(const RegionOutline& region) {
  Box2 box;
  for (const Point2& p : region.contours.front()->vertices) box.add(p);
  return box;
}

bool interiors_meet(const RegionOutline& a, const RegionOutline& b) {
  return interiors_meet(a, bounds(a), b, bounds(b));
}

bool interiors_meet(const RegionOutline& a, const Box2& box_a, const RegionOutline& b,
                    const Box2& box_b) {
  if (!box_a.overlaps(box_b)) return false;
  std::vector<OwnedEdge> edges;
  collect(a, 1, box_b, edges);
  const std::size_t first_b = edges.size();
  collect(b, 2, box_a, edges);
  std::vector<Cut> cuts;
  if (!find_cuts(edges, first_b, cuts)) return true;

  const std::vector<OwnedEdge> arrangement = pieces(edges, cuts);
  std::vector<SweepEdge> sweep_edges;
  sweep_edges.reserve(arrangement.size());
  for (const OwnedEdge& piece : arrangement) sweep_edges.push_back(piece.edge);
  std::vector<std::uint8_t> above(arrangement.size(), 0);  // all regions above each piece
  bool meet = false;
  Sweep(sweep_edges).run([&](const SweepEvent& event) {
    std::uint8_t inside = event.below == kNoEdge ? std::uint8_t{0} : above[event.below];
    for (const std::uint32_t edge : event.outgoing) {
      const OwnedEdge& piece = arrangement[edge];
      inside = static_cast<std::uint8_t>((inside & ~piece.owner) | piece.above);
      above[edge] = inside;
      meet = meet || inside == kBoth;
    }
    return !meet;
  });
  return meet;
}

}  // namespace tetloft::internal::sections
