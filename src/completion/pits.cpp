#include "completion/pits.hpp"

#include <algorithm>
#include <bit>

#include <tetloft/delaunay2.hpp>
#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/union_find.hpp"
#include "sections/conforming_section.hpp"

namespace tetloft::internal {

namespace {

// Some vertex of every contour.
IdVector<ContourId, PlaneVertexId> first_vertices(const ConformingSection& section) {
  IdVector<ContourId, PlaneVertexId> first(section.nesting.region.size());
  for (const PlaneVertexId v : section.contour.ids()) {
    const ContourId c = section.contour[v];
    if (c.valid() && !first[c].valid()) first[c] = v;
  }
  return first;
}

// Is a point outside the region in the circle of an internal triangle? The triangles whose
// circles it is in are connected, and reach from it: then one of them lies at a contour edge.
bool in_internal_circle(const ConformingSection& section, const Point2& p) {
  for (const ConformingSection::Edge& edge : section.edges) {
    if (edge.kind != EdgeKind::contour) continue;
    const bool left = edge.left.valid() && section.internal[edge.left] != 0;
    const auto& [a, b, c] = section.triangulation.triangles[left ? edge.left : edge.right];
    if (incircle_perturbed(section.point(a), section.point(b), section.point(c), p) ==
        Sign::positive) {
      return true;
    }
  }
  return false;
}

}  // namespace

ConformingSection with_exterior_vertices(const ConformingSection& section,
                                         const std::vector<Point2>& exterior) {
  const std::size_t n = section.vertex_count();
  std::vector<Point2> points(section.triangulation.points.begin(),
                             section.triangulation.points.end());
  points.insert(points.end(), exterior.begin(), exterior.end());
  Result<Triangulation2> triangulation = delaunay2(points);
  TETLOFT_CHECK(accepted(triangulation));

  ConformingSection result;
  result.z = section.z;
  result.nesting = section.nesting;
  result.gabriel = section.gabriel;
  const IdVector<PlaneVertexId, PlaneVertexId> number = sections::adopt(*triangulation, result);
  const auto renumbered = [&](PlaneVertexId v) { return v.valid() ? number[v] : PlaneVertexId(); };
  result.contour.resize(points.size());
  result.region.resize(points.size());
  result.next.resize(points.size());
  result.previous.resize(points.size());
  result.input_vertex.assign(points.size(), ConformingSection::kNotInput);
  result.edge_of.assign(points.size(), ConformingSection::kNotInput);
  for (std::size_t k = 0; k < n; ++k) {
    const PlaneVertexId old(k);
    const PlaneVertexId v = number[old];
    result.contour[v] = section.contour[old];
    result.region[v] = section.region[old];
    result.next[v] = renumbered(section.next[old]);
    result.previous[v] = renumbered(section.previous[old]);
    result.input_vertex[v] = section.input_vertex[old];
    result.edge_of[v] = section.edge_of[old];
  }
  result.internal.assign(result.triangulation.triangles.size(), 0);
  for (std::size_t k = 0; k < section.internal.size(); ++k) {
    if (section.internal[TriangleId(k)] == 0) continue;
    const auto& [a, b, c] = section.triangulation.triangles[TriangleId(k)];
    const TriangleId t = result.find_triangle(number[a], number[b], number[c]);
    TETLOFT_CHECK(t.valid());
    result.internal[t] = 1;
  }
  sections::classify_edges(result);
  return result;
}

Pits::Pits(const ConformingSection& lower, const ConformingSection& upper) {
  side_[0].section = &lower;
  side_[1].section = &upper;
  for (Side& side : side_) {
    const Nesting& nesting = side.section->nesting;
    for (const std::uint32_t depth : nesting.depth) {
      side.to_open.push_back(static_cast<std::uint8_t>(depth % 2));
    }
  }
}

std::vector<ContourId> Pits::sealed_holes(const Slab& slab, const SlabClasses& classes,
                                          const Complex& complex, bool upper) const {
  const ConformingSection& section = slab.section(upper);
  const Side& side = side_[upper ? 1 : 0];
  std::vector<ContourId> holes;
  for (std::size_t c = 0; c < side.to_open.size(); ++c) {
    if (side.to_open[ContourId(c)] != 0) holes.emplace_back(c);
  }
  if (holes.empty()) return holes;

  // Parts of the exterior: triangles joined across external edges; not sealed if one is not.
  UnionFind parts(section.internal.size());
  for (const ConformingSection::Edge& edge : section.edges) {
    if (edge.kind != EdgeKind::external || !edge.left.valid() || !edge.right.valid()) continue;
    parts.unite(edge.left.index(), edge.right.index());
  }
  std::vector<std::uint8_t> open(section.internal.size(), 0);
  for (const TriangleId triangle : section.internal.ids()) {
    if (section.internal[triangle] != 0) continue;
    const TetId t = slab.tet_on(upper, triangle);
    std::array<SlabVertexId, 3> corner;
    std::size_t corners = 0;
    bool attached = true;
    for (int i = 0; i < 4; ++i) {
      if (has_corner(slab.upper_corners(t), i) != upper) continue;
      corner[corners++] = slab.vertex(t, i);
      attached = attached && complex.is_attached(t, i);
    }
    const auto& [a, b, c] = corner;
    if (attached && classes.of(a) == classes.of(b) && classes.of(a) == classes.of(c)) continue;
    open[parts.find(triangle.index())] = 1;
  }
  const IdVector<ContourId, PlaneVertexId> first = first_vertices(section);
  std::erase_if(holes, [&](ContourId c) {
    const PlaneVertexId v = first[c];
    const ConformingSection::Edge& edge = section.edges[section.find_edge(v, section.next[v])];
    const TriangleId outside = edge.a == v ? edge.right : edge.left;
    return open[parts.find(outside.index())] != 0;
  });
  return holes;
}

bool Pits::open_sealed(const Slab& slab, const SlabClasses& classes, const Complex& complex) {
  if (given_up_) return false;
  const std::size_t before = opened_;
  for (const bool upper : {false, true}) {
    for (const ContourId hole : sealed_holes(slab, classes, complex, upper)) open(hole, upper);
  }
  if (opened_ == before) return false;
  extend();
  return true;
}

void Pits::extend() {
  for (Side& side : side_) {
    std::vector<Point2> exterior = side.exterior;
    exterior.insert(exterior.end(), pairs_.begin(), pairs_.end());
    side.extended.reset();
    if (!exterior.empty()) side.extended = with_exterior_vertices(*side.section, exterior);
  }
}

bool Pits::has_room(const Point2& p) {
  for (Side& side : side_) {
    if (!side.contours) side.contours.emplace(*side.section);
    if (side.contours->locate(p) != sections::ContourEdges::Where::outside) return false;
    if (in_internal_circle(*side.section, p)) return false;
  }
  return true;
}

bool Pits::open_at(const Point2& p) {
  if (std::find(pairs_.begin(), pairs_.end(), p) != pairs_.end()) return false;
  for (const Side& side : side_) {
    if (std::find(side.exterior.begin(), side.exterior.end(), p) != side.exterior.end()) {
      return false;
    }
  }
  pairs_.push_back(p);
  extend();
  return true;
}

void Pits::close_pairs() {
  pairs_.clear();
  extend();
}

void Pits::open(ContourId hole, bool upper) {
  Side& side = side_[upper ? 1 : 0];
  Side& across = side_[upper ? 0 : 1];
  side.to_open[hole] = 0;
  const std::size_t before = across.exterior.size();
  if (!across.contours) across.contours.emplace(*across.section);
  const ConformingSection& section = *side.section;
  for (const PlaneVertexId v : section.contour.ids()) {
    if (section.contour[v] != hole) continue;
    const Point2& p = section.point(v);
    if (across.contours->locate(p) != sections::ContourEdges::Where::outside) continue;
    if (in_internal_circle(*across.section, p)) continue;
    across.exterior.push_back(p);
  }
  if (across.exterior.size() > before) ++opened_;
}

void Pits::give_up() {
  given_up_ = true;
  opened_ = 0;
  pairs_.clear();
  for (Side& side : side_) {
    side.exterior.clear();
    side.extended.reset();
  }
}

IdVector<SlabVertexId, SlabVertexId> Pits::original_numbers() const {
  IdVector<SlabVertexId, SlabVertexId> numbers;
  std::uint32_t next = 0;
  for (const Side& side : side_) {
    for (const RegionId r : side.current().region) {
      numbers.raw().push_back(r.valid() ? SlabVertexId(next++) : SlabVertexId());
    }
  }
  return numbers;
}

}  // namespace tetloft::internal
