// One section's conforming Delaunay triangulation with all its labels.
//
// Split vertices bend the contours by rounding. What has to be validated again is little,
// because every piece of a bent contour is an edge of one planar triangulation, and such
// edges meet at common ends only. Contours stay simple and disjoint iff every vertex lies
// on exactly one of them, once; their nesting is unchanged iff across every piece of
// contour c the innermost contour changes between c and its parent, across no other edge,
// and outside the hull there is none; and none turned inside out iff its interior is on
// the same side as before. All of this is combinatorial. See README.md.
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <tetloft/conforming_section.hpp>

#include "core/guard.hpp"
#include "delaunay2/conforming.hpp"
#include "delaunay2/start.hpp"
#include "sections/conforming_section.hpp"
#include "sections/equal_parts.hpp"
#include "sections/nesting.hpp"
#include "sections/scaling.hpp"

namespace tetloft {

using namespace internal;

namespace {

// Contour vertices, and those that divide edges, numbered through; segment i starts at vertex i.
struct Flat {
  std::vector<Point2> points;
  std::vector<Segment> segments;
  std::vector<ContourId> contour;
  std::vector<std::size_t> vertex;  // index in its contour, or that of the edge it divides
  std::vector<bool> divides;        // is not of the contour
};

// Points of the interior come last, on no segment.
Flat flatten(const Section& section, std::span<const EdgeDivision> divided,
             std::span<const Point2> interior) {
  Flat flat;
  auto division = divided.begin();
  for (const ContourId c : section.contours.ids()) {
    const std::vector<Point2>& vertices = section.contours[c].vertices;
    const std::size_t first = flat.points.size();
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const std::size_t start = flat.points.size();
      const bool is_divided =
          division != divided.end() && division->contour == c && division->edge == v;
      sections::append_parts(vertices[v], vertices[(v + 1) % vertices.size()],
                             is_divided ? (division++)->parts : 1, flat.points);
      flat.contour.resize(flat.points.size(), c);
      flat.vertex.resize(flat.points.size(), v);
      flat.divides.resize(flat.points.size(), true);
      flat.divides[start] = false;
    }
    const std::size_t end = flat.points.size();
    for (std::size_t v = first; v < end; ++v) {
      flat.segments.push_back({PlaneVertexId(v), PlaneVertexId(v + 1 < end ? v + 1 : first)});
    }
  }
  flat.points.insert(flat.points.end(), interior.begin(), interior.end());
  return flat;
}

bool are_divisions_of(const Section& section, std::span<const EdgeDivision> divided) {
  const EdgeDivision* before = nullptr;
  for (const EdgeDivision& division : divided) {
    const bool is_edge = division.contour.index() < section.contours.size() &&
                         division.edge < section.contours[division.contour].vertices.size() &&
                         division.parts > 0;
    if (!is_edge) return false;
    if (before != nullptr &&
        std::tie(division.contour, division.edge) <= std::tie(before->contour, before->edge)) {
      return false;
    }
    before = &division;
  }
  return true;
}

using delaunay2_detail::ConformedPlane;

class Conformer {
 public:
  Conformer(const Section& section, SectionId id, const Nesting& nesting,
            std::span<const EdgeDivision> divided, std::span<const Point2> interior,
            std::span<const Point2> apart)
      : section_(section), id_(id), apart_(apart) {
    result_.z = section.z;
    result_.nesting = nesting;
    flat_ = flatten(section, divided, interior);
  }

  Result<ConformingSection> run(const ConformOptions& asked) {
    if (flat_.points.empty()) {
      result_.first_edge = {0};
      return std::move(result_);
    }
    ConformingOptions options;
    options.most_inserted = asked.most_inserted;
    options.execution = asked.execution;
    if (!asked.gabriel.empty()) {
      for (const ContourId c : flat_.contour) options.gabriel.push_back(asked.gabriel[c]);
    }
    const Result<ConformedPlane> conforming = conform_apart(options);
    if (!conforming) return placed(conforming.error());
    number_ = sections::adopt(*conforming, result_);
    if (Result<void> walked = walk_chains(conforming->chains); !walked) return walked.error();
    label_triangles();
    if (Result<void> valid = check_labels(); !valid) return valid.error();
    label_vertices_and_edges();
    if (Result<void> inside = label_interior(); !inside) return inside.error();
    return std::move(result_);
  }

 private:
  // With the points that are to lie apart as vertices triangles inside the region have empty
  // circles; without them these are triangles still, and splits what they were.
  [[nodiscard]] Result<ConformedPlane> conform_apart(const ConformingOptions& options) const {
    if (apart_.empty()) {
      return delaunay2_detail::conformed_plane(flat_.points, flat_.segments, options);
    }
    std::vector<Point2> points = flat_.points;
    points.insert(points.end(), apart_.begin(), apart_.end());
    Result<ConformedPlane> result =
        delaunay2_detail::conformed_plane(points, flat_.segments, options);
    if (!result) return result;
    const auto first = static_cast<std::ptrdiff_t>(flat_.points.size());
    const auto apart = static_cast<std::ptrdiff_t>(apart_.size());
    std::vector<Point2>& all = result->points;
    all.erase(all.begin() + first, all.begin() + first + apart);
    for (PlaneVertexId& v : result->chains.vertices()) {
      if (v.index() >= flat_.points.size()) v = PlaneVertexId(v.index() - apart_.size());
    }
    const Execution alone;
    WatchedWork unwatched(alone, 0);
    result->start = delaunay2_detail::triangulate(all, unwatched);
    return result;
  }

  // The error of the triangulation, whose vertices are numbered through, in our terms.
  [[nodiscard]] Error placed(Error error) const {
    if (error.where.vertex && *error.where.vertex < flat_.contour.size()) {
      const std::size_t v = *error.where.vertex;
      error.where.contour = flat_.contour[v].index();
      error.where.vertex = flat_.vertex[v];
      if (error.code == ErrorCode::unrepresentable) {
        error.message = "rounding leaves no room to split the contour's edge that starts here";
      } else if (error.code == ErrorCode::work_limit) {
        error.message =
            "contours that are nearly parallel, or meet at angles, much closer than their edges "
            "are "
            "long have to be split further than the work limit allows, last at the edge that "
            "starts "
            "here; move them apart, divide the edges (--refine), drop the last bits (--snap), or "
            "raise the limit";
      }
    }
    error.where.section = id_.index();
    if (error.where.point) error.where.point->z = section_.z;
    return error;
  }

  [[nodiscard]] Error unrepresentable(PlaneVertexId v, const char* reason) const {
    Error error{ErrorCode::unrepresentable, reason, {}};
    error.where.section = id_.index();
    if (result_.contour[v].valid()) {
      error.where.contour = result_.contour[v].index();
      error.where.vertex = result_.edge_of[v];
    }
    error.where.point = result_.point3(v);
    return error;
  }

  // Enters every chain into contour, next, input_vertex and edge_of, and marks its edges.
  // Fails where points coincide; the chains then share no vertex and leave none out.
  Result<void> walk_chains(const delaunay2_detail::Chains& chains) {
    const std::size_t n = result_.triangulation.points.size();
    result_.contour.resize(n);
    result_.region.resize(n);
    result_.next.resize(n);
    result_.previous.resize(n);
    result_.input_vertex.assign(n, ConformingSection::kNotInput);
    result_.edge_of.assign(n, ConformingSection::kNotInput);
    contour_of_edge_.resize(result_.edges.size());
    edge_along_.resize(n);
    TETLOFT_CHECK(chains.size() == flat_.segments.size());
    for (std::size_t s = 0; s < chains.size(); ++s) {
      const std::span<const PlaneVertexId> chain = chains[s];
      TETLOFT_CHECK(chain.size() >= 2);
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const PlaneVertexId from = number_[chain[k]];
        const PlaneVertexId to = number_[chain[k + 1]];
        TETLOFT_CHECK(!result_.contour[from].valid());
        result_.contour[from] = flat_.contour[s];
        result_.next[from] = to;
        result_.edge_of[from] = flat_.vertex[s];
        if (k == 0 && !flat_.divides[s]) result_.input_vertex[from] = flat_.vertex[s];
      }
    }
    IdVector<PlaneVertexId, std::uint8_t> interior(n, 0);
    for (std::size_t k = flat_.segments.size(); k < flat_.points.size(); ++k) {
      interior[number_[PlaneVertexId(k)]] = 1;
    }
    for (std::size_t v = 0; v < n; ++v) {
      const PlaneVertexId from(v);
      if (interior[from] != 0) continue;
      const EdgeId edge =
          result_.contour[from].valid() ? result_.find_edge(from, result_.next[from]) : EdgeId();
      // Of coinciding points the triangulation uses one only.
      if (!edge.valid()) {
        return unrepresentable(from, "rounding brings two points of contours together");
      }
      contour_of_edge_[edge] = result_.contour[from];
      edge_along_[from] = edge;
    }
    return {};
  }

  // The innermost contour around each triangle, by flood fill from outside: entering a
  // contour at its pieces, leaving it for its parent.
  void label_triangles() {
    const Triangulation2& t = result_.triangulation;
    const IdVector<TriangleId, std::array<EdgeId, 3>> edges = sections::edges_of_sides(result_);
    around_.resize(t.triangles.size());
    result_.internal.assign(t.triangles.size(), 0);
    std::vector<bool> reached(t.triangles.size(), false);
    std::vector<TriangleId> front;
    const auto reach = [&](TriangleId triangle, ContourId outside, ContourId crossed) {
      if (!triangle.valid() || reached[triangle.index()]) return;
      reached[triangle.index()] = true;
      around_[triangle] = !crossed.valid()     ? outside
                          : outside == crossed ? result_.nesting.parent[crossed]
                                               : crossed;
      front.push_back(triangle);
    };
    for (std::size_t e = 0; e < result_.edges.size(); ++e) {
      const ConformingSection::Edge& edge = result_.edges[EdgeId(e)];
      if (edge.left.valid() && edge.right.valid()) continue;
      reach(edge.left.valid() ? edge.left : edge.right, ContourId(), contour_of_edge_[EdgeId(e)]);
    }
    while (!front.empty()) {
      const TriangleId triangle = front.back();
      front.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const EdgeId edge = edges[triangle][i];
        reach(t.neighbours[triangle][i], around_[triangle], contour_of_edge_[edge]);
      }
    }
    for (std::size_t k = 0; k < around_.size(); ++k) {
      const ContourId c = around_[TriangleId(k)];
      result_.internal[TriangleId(k)] = c.valid() && result_.nesting.depth[c] % 2 == 0 ? 1 : 0;
    }
  }

  // Is the nesting of the bent contours that of the input, and is no contour inside out?
  [[nodiscard]] Result<void> check_labels() const {
    std::vector<bool> ccw;
    for (const Contour& contour : section_.contours) {
      ccw.push_back(sections::is_counter_clockwise(contour));
    }
    for (std::size_t e = 0; e < result_.edges.size(); ++e) {
      const ConformingSection::Edge& edge = result_.edges[EdgeId(e)];
      const ContourId left = edge.left.valid() ? around_[edge.left] : ContourId();
      const ContourId right = edge.right.valid() ? around_[edge.right] : ContourId();
      const ContourId c = contour_of_edge_[EdgeId(e)];
      if (!c.valid()) {
        if (left != right) return unrepresentable(edge.a, "rounding changes how contours nest");
        continue;
      }
      const bool forward = result_.next[edge.a] == edge.b;
      const bool inside_left = ccw[c.index()] == forward;
      const ContourId inside = inside_left ? left : right;
      const ContourId outside = inside_left ? right : left;
      if (inside != c || outside != result_.nesting.parent[c]) {
        return unrepresentable(edge.a, "rounding turns a contour or changes how contours nest");
      }
    }
    return {};
  }

  // Regions, directions along the contours, kinds of edges.
  void label_vertices_and_edges() {
    for (std::size_t e = 0; e < result_.edges.size(); ++e) {
      ConformingSection::Edge& edge = result_.edges[EdgeId(e)];
      if (contour_of_edge_[EdgeId(e)].valid()) {
        edge.kind = EdgeKind::contour;
      } else if (edge.left.valid() && result_.internal[edge.left] != 0) {
        edge.kind = EdgeKind::internal;
      }
    }
    const IdVector<PlaneVertexId, PlaneVertexId> along = result_.next;
    for (std::size_t v = 0; v < along.size(); ++v) {
      const PlaneVertexId a(v);
      const PlaneVertexId b = along[a];
      if (!b.valid()) continue;
      result_.region[a] = result_.nesting.region[result_.contour[a]];
      const ConformingSection::Edge& edge = result_.edges[edge_along_[a]];
      const TriangleId left = a < b ? edge.left : edge.right;
      const bool region_left = left.valid() && result_.internal[left] != 0;
      result_.next[region_left ? a : b] = region_left ? b : a;
      result_.previous[region_left ? b : a] = region_left ? a : b;
    }
  }

  // Vertices of the interior have the region of their triangles, all of which must be inside.
  Result<void> label_interior() {
    for (std::size_t k = 0; k < around_.size(); ++k) {
      for (const PlaneVertexId v : result_.triangulation.triangles[TriangleId(k)]) {
        if (result_.contour[v].valid()) continue;
        if (result_.internal[TriangleId(k)] == 0) {
          Error error{ErrorCode::invalid_input, "a vertex of the interior is not inside", {}};
          error.where.section = id_.index();
          error.where.point = result_.point3(v);
          return error;
        }
        result_.region[v] = result_.nesting.region[around_[TriangleId(k)]];
      }
    }
    return {};
  }

  const Section& section_;
  SectionId id_;
  std::span<const Point2> apart_;
  Flat flat_;
  IdVector<PlaneVertexId, PlaneVertexId> number_;  // of the triangulation's vertices
  IdVector<EdgeId, ContourId> contour_of_edge_;    // invalid: not on a contour
  IdVector<PlaneVertexId, EdgeId> edge_along_;     // from a vertex to the next of its contour
  IdVector<TriangleId, ContourId> around_;         // the innermost contour around it
  ConformingSection result_;
};

// The same in a unit of the section's own. Nothing where points have finer bits than fit in the
// unit given.
std::optional<Result<ConformingSection>> conform_in_unit(const Section& section, SectionId id,
                                                         const Nesting& nesting,
                                                         const ConformOptions& options) {
  UnitOfLength unit;
  for (const Contour& contour : section.contours) {
    for (const Point2& p : contour.vertices) unit.include(p);
  }
  for (const Point2& p : options.interior) unit.include(p);
  for (const Point2& p : options.apart) unit.include(p);
  const int exponent = unit.exponent();
  std::vector<Point2> inside = options.interior;
  for (Point2& p : inside) p = scaled(p, exponent);
  std::vector<Point2> apart = options.apart;
  for (Point2& p : apart) p = scaled(p, exponent);
  const Section in_unit = sections::scaled_in_plane(section, exponent);
  Result<ConformingSection> result =
      Conformer(in_unit, id, nesting, options.divided, inside, apart).run(options);
  if (!result) {
    Error error = result.error();
    if (error.where.point) {
      const Point2 at = scaled(Point2{error.where.point->x, error.where.point->y}, -exponent);
      error.where.point = Point3{at.x, at.y, section.z};
    }
    return error;
  }
  for (Point2& p : result->triangulation.points) {
    if (!is_scaled_exactly(p, -exponent)) return std::nullopt;
    p = scaled(p, -exponent);
  }
  return result;
}

}  // namespace

Result<ConformingSection> sections::conform_nested(const Section& section, SectionId id,
                                                   const Nesting& nesting,
                                                   const ConformOptions& options) {
  auto in_unit = conform_in_unit(section, id, nesting, options);
  // What has been told of the work is not told again.
  ConformOptions again = options;
  again.execution.progress = nullptr;
  Result<ConformingSection> result =
      in_unit
          ? *std::move(in_unit)
          : Conformer(section, id, nesting, again.divided, again.interior, again.apart).run(again);
  if (result) result->gabriel = options.gabriel;
  return result;
}

Result<ConformingSection> conform(const Section& section, SectionId id,
                                  const ConformOptions& options) {
  return guard_internal([&]() -> Result<ConformingSection> {
    if (!options.gabriel.empty() && options.gabriel.size() != section.contours.size()) {
      return Error{ErrorCode::usage, "gabriel needs one flag for each contour", {}};
    }
    if (!are_divisions_of(section, options.divided)) {
      return Error{
          ErrorCode::usage, "divisions need edges of the section, in order, each once", {}};
    }
    if (!sections::has_contours(section)) {
      Error error{ErrorCode::invalid_input, "contours of fewer than three finite vertices", {}};
      error.where.section = id.index();
      return error;
    }
    return sections::conform_nested(section, id, nest(section), options);
  });
}

}  // namespace tetloft
