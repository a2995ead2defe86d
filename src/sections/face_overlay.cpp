// Every counter-clockwise cycle of the graph of both sections' contours bounds a face from outside.
// A connected part of the graph has one clockwise cycle, around it: it bounds the face of the rest
// that contains the part, which is that of the first piece below the part's lowest vertex.
#include "sections/face_overlay.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include <tetloft/point.hpp>

#include "core/guard.hpp"
#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"
#include "sections/complement.hpp"
#include "sections/overlay_curves.hpp"
#include "sections/overlay_graph.hpp"
#include "sections/overlay_ray.hpp"
#include "sections/overlay_touches.hpp"

namespace tetloft::internal::sections {

struct FaceOverlay::Plane {
  Plane(const Section& lower, const Section& upper)
      : curves{OverlayCurves(lower), OverlayCurves(upper)},
        graph({&curves[0], &curves[1]}),
        ray({&curves[0], &curves[1]}, graph) {}

  std::array<OverlayCurves, 2> curves;
  OverlayGraph graph;
  OverlayRay ray;
  std::vector<FaceId> face;  // of cycles
};

namespace {

constexpr std::uint32_t kUnbounded = 0;

// A connected part of the graph.
struct Part {
  Point2 lowest;
  std::uint32_t around = kNone;  // its clockwise cycle
};

/// What is on both sides of the contours of a section.
struct Sides {
  IdVector<ContourId, FaceSide> inner, outer;
};

Sides sides_of(const Section& section, const Nesting& nesting) {
  const IdVector<ContourId, RegionId> voids = voids_of_contours(section, nesting);
  Sides sides;
  for (const ContourId c : section.contours.ids()) {
    const FaceSide solid{true, nesting.region[c]};
    const FaceSide empty{false, voids[c]};
    const bool hole = nesting.depth[c] % 2 != 0;
    sides.inner.push_back(hole ? empty : solid);
    sides.outer.push_back(hole ? solid : empty);
  }
  return sides;
}

// By what a node is the same whatever the order of contours.
std::array<Point2, 4> key(const std::array<OverlayCurves, 2>& curves, const OverlayNode& node) {
  for (std::size_t s = 0; s < 2; ++s) {
    if (node.at_start[s]) {
      const Point2& p = curves[s].start(node.edge[s]);
      return {p, p, p, p};
    }
  }
  return {curves[0].low(node.edge[0]), curves[0].high(node.edge[0]), curves[1].low(node.edge[1]),
          curves[1].high(node.edge[1])};
}

class Faces {
 public:
  Faces(const std::array<OverlayCurves, 2>& curves, const OverlayGraph& graph,
        const OverlayRay& ray, const std::array<Sides, 2>& sides,
        const std::array<const Nesting*, 2>& nestings)
      : curves_(curves), graph_(graph), ray_(ray), sides_(sides), nestings_(nestings) {
    make_faces();
    place_parts(find_parts());
    collect_borders();
    number();
  }

  IdVector<FaceId, OverlayFace> faces;  // in canonical order
  std::vector<FaceId> of_cycle;

 private:
  // Faces in the order of their outer cycles, the unbounded one first.
  struct Draft {
    OverlayFace face;
    std::uint32_t outer = kNone;
  };

  FaceSide side(std::uint32_t half, std::size_t s) const {
    const ContourId c(graph_.arcs()[half / 2].contour[s]);
    return graph_.is_inside(half, s) ? sides_[s].inner[c] : sides_[s].outer[c];
  }

  static FaceSide& side_of(OverlayFace& face, std::size_t s) {
    return s == 0 ? face.lower : face.upper;
  }

  void make_faces();
  std::vector<Part> find_parts() const;
  void place_parts(const std::vector<Part>& parts);
  void collect_borders();
  void number();
  // A half-arc of the outer cycle that names it.
  std::uint32_t leading_half(std::uint32_t cycle) const;
  bool comes_before(std::uint32_t half, std::uint32_t other) const;

  const std::array<OverlayCurves, 2>& curves_;
  const OverlayGraph& graph_;
  const OverlayRay& ray_;
  const std::array<Sides, 2>& sides_;
  std::array<const Nesting*, 2> nestings_;
  std::vector<Draft> drafts_;
  std::vector<std::uint32_t> draft_of_;  // of cycles
};

void Faces::make_faces() {
  drafts_.emplace_back();
  drafts_[kUnbounded].face.lower = {false, kExterior};
  drafts_[kUnbounded].face.upper = {false, kExterior};
  draft_of_.assign(graph_.cycles().size(), kNone);
  for (std::uint32_t c = 0; c < graph_.cycles().size(); ++c) {
    const OverlayCycle& cycle = graph_.cycles()[c];
    if (!cycle.counter_clockwise) continue;
    draft_of_[c] = static_cast<std::uint32_t>(drafts_.size());
    Draft draft;
    draft.outer = c;
    for (std::size_t s = 0; s < 2; ++s) {
      // A loop knows its own section's side alone: the other one is told where it is placed.
      if (!graph_.is_loop(cycle.first)) {
        side_of(draft.face, s) = side(graph_.clockwise_on(cycle.first, s), s);
      } else if (graph_.arcs()[cycle.first / 2].contour[s] != kNone) {
        side_of(draft.face, s) = side(cycle.first, s);
      }
    }
    drafts_.push_back(std::move(draft));
  }
}

std::vector<Part> Faces::find_parts() const {
  const std::array<std::uint32_t, 2> base = {0, curves_[0].contour_count()};
  UnionFind connected(base[1] + curves_[1].contour_count());
  for (const OverlayNode& node : graph_.nodes().nodes) {
    connected.unite(base[0] + curves_[0].contour(node.edge[0]),
                    base[1] + curves_[1].contour(node.edge[1]));
  }
  std::vector<std::uint32_t> part_of(connected.size(), kNone);
  std::vector<Part> parts;
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::uint32_t c = 0; c < curves_[s].contour_count(); ++c) {
      std::uint32_t& part = part_of[connected.find(base[s] + c)];
      const Point2& lowest = curves_[s].lowest(c);
      if (part == kNone) {
        part = static_cast<std::uint32_t>(parts.size());
        parts.push_back({lowest, kNone});
      } else if (canonical_less(lowest, parts[part].lowest)) {
        parts[part].lowest = lowest;
      }
    }
  }
  for (std::uint32_t c = 0; c < graph_.cycles().size(); ++c) {
    if (graph_.cycles()[c].counter_clockwise) continue;
    const OverlayArc& arc = graph_.arcs()[graph_.cycles()[c].first / 2];
    const std::size_t s = arc.contour[0] != kNone ? 0 : 1;
    std::uint32_t& around = parts[part_of[connected.find(base[s] + arc.contour[s])]].around;
    TETLOFT_CHECK(around == kNone);
    around = c;
  }
  std::sort(parts.begin(), parts.end(),
            [](const Part& p, const Part& q) { return canonical_less(p.lowest, q.lowest); });
  return parts;
}

void Faces::place_parts(const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    TETLOFT_CHECK(part.around != kNone);
    const std::uint32_t below = ray_.half_below(part.lowest);
    // What is below belongs to a part whose lowest vertex is lower: one placed already.
    const std::uint32_t at = below == kNone ? kUnbounded : draft_of_[graph_.cycle(below)];
    TETLOFT_CHECK(at != kNone);
    draft_of_[part.around] = at;
    --drafts_[at].face.chi;
    const std::uint32_t first = graph_.cycles()[part.around].first;
    if (!graph_.is_loop(first)) continue;
    const std::size_t other = graph_.arcs()[first / 2].contour[0] == kNone ? 0 : 1;
    OverlayFace& inside = drafts_[draft_of_[graph_.cycle(first ^ 1U)]].face;
    side_of(inside, other) = side_of(drafts_[at].face, other);
  }
}

void Faces::collect_borders() {
  for (std::uint32_t half = 0; half < 2 * graph_.arcs().size(); ++half) {
    const std::uint32_t cycle = graph_.cycle(half);
    if (cycle == kNone) continue;
    std::vector<BorderRegion>& border = drafts_[draft_of_[cycle]].face.border;
    for (std::size_t s = 0; s < 2; ++s) {
      const std::uint32_t contour = graph_.arcs()[half / 2].contour[s];
      if (contour == kNone) continue;
      const BorderRegion region{s == 1, nestings_[s]->region[ContourId(contour)]};
      if (border.empty() || border.back() != region) border.push_back(region);
    }
  }
  for (Draft& draft : drafts_) sort_distinct(draft.face.border);
}

// Half-arcs of loops by the loop's lowest vertex, after all others, by their node and place.
bool Faces::comes_before(std::uint32_t half, std::uint32_t other) const {
  const auto less = [](const Point2& p, const Point2& q) { return canonical_less(p, q); };
  if (graph_.is_loop(half) != graph_.is_loop(other)) return graph_.is_loop(other);
  if (graph_.is_loop(half)) {
    const auto lowest = [&](std::uint32_t h) {
      const OverlayArc& arc = graph_.arcs()[h / 2];
      const std::size_t s = arc.contour[0] != kNone ? 0 : 1;
      return curves_[s].lowest(arc.contour[s]);
    };
    return less(lowest(half), lowest(other));
  }
  const OverlayGraph::Leaving& p = graph_.leaving(half);
  const OverlayGraph::Leaving& q = graph_.leaving(other);
  if (p.node == q.node) return p.place < q.place;
  const std::array<Point2, 4> a = key(curves_, graph_.nodes().nodes[p.node]);
  const std::array<Point2, 4> b = key(curves_, graph_.nodes().nodes[q.node]);
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
}

std::uint32_t Faces::leading_half(std::uint32_t cycle) const {
  const std::uint32_t first = graph_.cycles()[cycle].first;
  std::uint32_t lead = first;
  for (std::uint32_t half = graph_.next(first); half != first; half = graph_.next(half)) {
    if (comes_before(half, lead)) lead = half;
  }
  return lead;
}

void Faces::number() {
  struct Named {
    std::uint32_t draft, lead;
  };
  std::vector<Named> order;
  order.reserve(drafts_.size());
  for (std::uint32_t d = 0; d < drafts_.size(); ++d) {
    order.push_back({d, d == kUnbounded ? kNone : leading_half(drafts_[d].outer)});
  }
  std::sort(order.begin(), order.end(), [&](const Named& p, const Named& q) {
    const OverlayFace& a = drafts_[p.draft].face;
    const OverlayFace& b = drafts_[q.draft].face;
    const auto sides = std::tie(a.lower, a.upper) <=> std::tie(b.lower, b.upper);
    if (sides != 0) return sides < 0;
    if (p.draft == kUnbounded || q.draft == kUnbounded) {
      return p.draft == kUnbounded && q.draft != kUnbounded;
    }
    return comes_before(p.lead, q.lead);
  });
  std::vector<FaceId> id_of(drafts_.size());
  for (const Named& named : order) {
    id_of[named.draft] = faces.push_back(std::move(drafts_[named.draft].face));
  }
  of_cycle.reserve(draft_of_.size());
  for (const std::uint32_t draft : draft_of_) of_cycle.push_back(id_of[draft]);
}

Point2 position(const std::array<OverlayCurves, 2>& curves, const OverlayNode& node) {
  for (std::size_t s = 0; s < 2; ++s) {
    if (node.at_start[s]) return curves[s].start(node.edge[s]);
  }
  const Point2& a = curves[0].start(node.edge[0]);
  const Point2& b = curves[0].end(node.edge[0]);
  const Point2& c = curves[1].start(node.edge[1]);
  const Point2& d = curves[1].end(node.edge[1]);
  const double along = (c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x);
  const double whole = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
  const double t = whole == 0 ? 0.5 : along / whole;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

// The vertices of an arc, and the nodes at both ends: a face may lie on either side.
void append_points(const OverlayGraph& graph, const std::array<OverlayCurves, 2>& curves,
                   std::uint32_t arc, std::vector<Point2>& points) {
  const std::array<std::uint32_t, 2>& contour = graph.arcs()[arc].contour;
  const OverlayNodes& all = graph.nodes();
  const auto nodes = static_cast<std::uint32_t>(all.nodes.size());
  if (graph.is_loop(2 * arc)) {
    const std::size_t s = contour[0] != kNone ? 0 : 1;
    for (std::uint32_t v = 0; v < curves[s].edge_count(); ++v) {
      if (curves[s].contour(v) == contour[s]) points.push_back(curves[s].start(v));
    }
    return;
  }
  const std::size_t s = arc < nodes ? 0 : 1;
  const std::uint32_t pass = s == 0 ? arc : arc - nodes;
  const OverlayNodes::Range range = all.range[s][contour[s]];
  const OverlayNode& from = all.nodes[all.passes[s][pass]];
  const OverlayNode& to = all.nodes[all.passes[s][pass + 1 == range.last ? range.first : pass + 1]];
  points.push_back(position(curves, from));
  points.push_back(position(curves, to));
  // From the vertex after the first node to that before the second: around once, if the last node
  // of a contour lies on the edge of its first.
  std::uint32_t v = from.edge[s];
  const std::uint32_t end = to.edge[s];
  bool whole = pass + 1 == range.last && v == end;
  while (v != end || whole) {
    whole = false;
    v = curves[s].next(v);
    if (v != end || !to.at_start[s]) points.push_back(curves[s].start(v));
  }
}

}  // namespace

FaceOverlay::FaceOverlay(const Section& lower, const Nesting& lower_nesting, const Section& upper,
                         const Nesting& upper_nesting) {
  auto plane = std::make_shared<Plane>(lower, upper);
  const std::array<Sides, 2> sides = {sides_of(lower, lower_nesting),
                                      sides_of(upper, upper_nesting)};
  Faces found(plane->curves, plane->graph, plane->ray, sides, {&lower_nesting, &upper_nesting});
  faces_ = std::move(found.faces);
  plane->face = std::move(found.of_cycle);
  OverlayTouches touches = touches_of(plane->graph, {&plane->curves[0], &plane->curves[1]}, faces_,
                                      plane->face, {&lower_nesting, &upper_nesting});
  meetings_ = std::move(touches.meetings);
  touching_voids_ = std::move(touches.voids);
  plane_ = std::move(plane);
}

FaceId FaceOverlay::locate(const Point2& p) const {
  if (plane_->ray.meets(p)) return {};
  const std::uint32_t below = plane_->ray.half_below(p);
  return below == kNone ? kUnboundedFace : plane_->face[plane_->graph.cycle(below)];
}

std::vector<Point2> FaceOverlay::border_points(FaceId face) const {
  std::vector<Point2> points;
  for (std::uint32_t half = 0; half < 2 * plane_->graph.arcs().size(); ++half) {
    const std::uint32_t cycle = plane_->graph.cycle(half);
    if (cycle != kNone && plane_->face[cycle] == face) {
      append_points(plane_->graph, plane_->curves, half / 2, points);
    }
  }
  return points;
}

}  // namespace tetloft::internal::sections
