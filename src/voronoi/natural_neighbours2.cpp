// Natural neighbours in the plane: the cell that a point would have, and what it would take from
// whom.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/voronoi2.hpp>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/sort_distinct.hpp"
#include "core/vector.hpp"
#include "voronoi/cut_polygon.hpp"
#include "voronoi/many_neighbours.hpp"
#include "voronoi/moderate.hpp"

namespace tetloft {

using namespace internal;
using voronoi::CutPolygon;

namespace {

Point3 without_z(const Point2& p) { return {p.x, p.y, 0}; }

// The neighbours of a point that is no vertex, relative to it, and in a unit near the largest: of
// weights only ratios count.
struct PlaneSurroundings {
  std::vector<DelaunayVertex> vertices;
  std::vector<Point3> points;   // as they are
  std::vector<Point3> offsets;  // relative, scaled
};

PlaneSurroundings plane_surroundings(const DelaunayTriangulation2& triangulation,
                                     const std::vector<DelaunayVertex>& neighbours,
                                     const Point3& p) {
  using namespace vectors;
  PlaneSurroundings around{neighbours, {}, {}};
  double largest = 0;
  for (const DelaunayVertex v : neighbours) {
    around.points.push_back(without_z(triangulation.point(v)));
    around.offsets.push_back(around.points.back() - p);
    largest =
        std::max({largest, std::abs(around.offsets.back().x), std::abs(around.offsets.back().y)});
  }
  const int exponent = std::ilogb(largest);
  for (Point3& q : around.offsets) q = voronoi::times_power_of_two(q, -exponent);
  return around;
}

// The cell of the origin among points, in a square that holds it; so near the hull that the cell is
// more than 2^18 times as large as the distances, what is in the square of that size: what is
// missing changes the weights by some 2^-18, and in larger cells rounding of the bisectors'
// directions tells.
CutPolygon plane_cell_among(const PlaneSurroundings& around) {
  constexpr double kFirst = 0x1p2, kLarger = 0x1p8, kLast = 0x1p18;
  for (double half = kFirst;; half *= kLarger) {
    CutPolygon cell({-half, -half}, {half, half});
    for (const Point3& offset : around.offsets) cell.cut(voronoi::nearer_to_origin(offset));
    const auto is_cut = [](const CutPolygon::Corner& c) { return c.edge >= CutPolygon::kSides; };
    if (half >= kLast || std::all_of(cell.corners().begin(), cell.corners().end(), is_cut)) {
      return cell;
    }
  }
}

// Neighbours whose old cells meet in the new one, each pair both ways, sorted. They have an edge of
// a triangle in conflict: on their common edge the squared distance from one of them less that from
// the point is affine, and does not grow along a ray, which is normal to a hull edge; so where it
// is positive somewhere it is so at an end, which is the centre of such a triangle.
std::vector<std::array<std::uint32_t, 2>> pairs_that_meet(
    const DelaunayTriangulation2& triangulation, const std::vector<TriangleId>& zone,
    const std::vector<DelaunayVertex>& neighbours) {
  const auto place = [&](DelaunayVertex v) {
    const auto at = std::lower_bound(neighbours.begin(), neighbours.end(), v);
    return static_cast<std::uint32_t>(at - neighbours.begin());
  };
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const TriangleId t : zone) {
    const std::array<DelaunayVertex, 3> v = triangulation.vertices(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = place(v[i]), b = place(v[(i + 1) % 3]);
      pairs.push_back({a, b});
      pairs.push_back({b, a});
    }
  }
  sort_distinct(pairs);
  return pairs;
}

// What of the cell is nearest to each neighbour. A part is convex, so of a segment that leaves it
// within the cell the first thing met is a cell that meets it there: no others have to be cut by.
std::vector<double> areas_taken(const CutPolygon& cell, const PlaneSurroundings& around,
                                const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  using namespace vectors;
  std::vector<double> areas;
  auto pair = pairs.begin();
  for (std::uint32_t i = 0; i < around.points.size(); ++i) {
    CutPolygon part = cell;
    for (; pair != pairs.end() && (*pair)[0] == i; ++pair) {
      const std::uint32_t j = (*pair)[1];
      part.cut(voronoi::nearer_to_first(around.offsets[i], around.offsets[j],
                                        around.points[j] - around.points[i]));
    }
    areas.push_back(part.area());
  }
  return areas;
}

// The lengths of the cell's edges over the distances.
std::vector<double> lengths_over_distances(const CutPolygon& cell,
                                           const PlaneSurroundings& around) {
  std::vector<double> weights(around.offsets.size());
  const std::vector<CutPolygon::Corner>& corners = cell.corners();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (corners[k].edge < CutPolygon::kSides) continue;
    const std::size_t i = corners[k].edge - CutPolygon::kSides;
    const Point2& from = corners[k].point;
    const Point2& to = corners[(k + 1) % corners.size()].point;
    weights[i] = std::hypot(to.x - from.x, to.y - from.y) /
                 (2 * voronoi::nearer_to_origin(around.offsets[i]).offset);
  }
  return weights;
}

// To sum 1. Among vertices within ulps nothing may be left of the cell: the nearest has all.
void make_sum_one(const std::vector<Point3>& offsets, std::vector<double>& weights) {
  double sum = 0;
  for (const double w : weights) sum += w;
  if (!(sum > 0 && std::isfinite(sum))) {
    const auto nearest = std::min_element(
        offsets.begin(), offsets.end(),
        [](const Point3& a, const Point3& b) { return vectors::dot(a, a) < vectors::dot(b, b); });
    weights.assign(offsets.size(), 0);
    weights[static_cast<std::size_t>(nearest - offsets.begin())] = sum = 1;
  }
  for (double& w : weights) w /= sum;
}

Error refused_in_plane(const char* why, const Point2& p) {
  Error error{ErrorCode::invalid_input, why, {}};
  error.where.point = without_z(p);
  return error;
}

// On an edge of the hull its ends alone: those of `at`.
bool is_on_hull_edge(const DelaunayTriangulation2& triangulation, const Location2& at) {
  if (at.kind != LocationKind::edge) return false;
  const auto sides = triangulation.triangles(at.vertices[0], at.vertices[1]);
  return !sides[0].valid() || !sides[1].valid();
}

Result<NaturalNeighbours> weighted_in_plane(const DelaunayTriangulation2& triangulation,
                                            const Location2& at, const Point2& p,
                                            NaturalWeights kind) {
  const bool on_hull = is_on_hull_edge(triangulation, at);
  ConflictZone2 zone;
  if (on_hull) {
    zone.neighbours = {at.vertices[0], at.vertices[1]};
  } else {
    Result<ConflictZone2> found = triangulation.conflict_zone(p, at.vertices[0]);
    if (!found) return found.error();
    zone = *std::move(found);
  }
  for (const DelaunayVertex v : zone.neighbours) {
    const Point2& q = triangulation.point(v);
    if (!voronoi::is_moderate(without_z(q))) {
      return refused_in_plane("a neighbour's coordinate is beyond 2^300", q);
    }
  }
  const PlaneSurroundings around = plane_surroundings(triangulation, zone.neighbours, without_z(p));
  NaturalNeighbours result{around.vertices, {}};
  if (on_hull) {
    for (const std::size_t other : {std::size_t{1}, std::size_t{0}}) {
      result.weights.push_back(voronoi::nearer_to_origin(around.offsets[other]).offset);
    }
  } else {
    const CutPolygon cell = plane_cell_among(around);
    result.weights =
        kind == NaturalWeights::sibson
            ? areas_taken(cell, around,
                          pairs_that_meet(triangulation, zone.triangles, around.vertices))
            : lengths_over_distances(cell, around);
  }
  make_sum_one(around.offsets, result.weights);
  return result;
}

Result<void> check_natural_in_plane(const DelaunayTriangulation2& triangulation,
                                    NaturalWeights weights, std::span<const Point2> points) {
  if (!is_enumerator(weights, NaturalWeights::laplace)) {
    return Error{ErrorCode::usage, "there are no such weights of natural neighbours", {}};
  }
  for (const Point2& p : points) {
    if (!voronoi::is_moderate(without_z(p))) {
      return refused_in_plane("a coordinate is not finite, or beyond 2^300", p);
    }
  }
  if (triangulation.constraint_count() == 0) return {};
  return Error{ErrorCode::invalid_input, "among constraints there are no natural neighbours", {}};
}

// Of a point that is not outside.
Result<NaturalNeighbours> neighbours_in_plane(const DelaunayTriangulation2& triangulation,
                                              const Location2& at, const Point2& point,
                                              NaturalWeights weights) {
  if (at.kind == LocationKind::vertex) return NaturalNeighbours{{at.vertices[0]}, {1}};
  return weighted_in_plane(triangulation, at, point, weights);
}

}  // namespace

Result<NaturalNeighbours> natural_neighbours(const DelaunayTriangulation2& triangulation,
                                             const Point2& point, NaturalWeights weights,
                                             DelaunayVertex near) {
  return guard_internal([&]() -> Result<NaturalNeighbours> {
    if (Result<void> fine = check_natural_in_plane(triangulation, weights, {&point, 1}); !fine) {
      return fine.error();
    }
    if (triangulation.dimension() < 2) {
      return refused_in_plane("the vertices span no plane", point);
    }
    const Result<Location2> at = triangulation.locate(point, near);
    if (!at) return at.error();
    if (at->kind == LocationKind::outside) {
      return refused_in_plane("the point is outside of the hull", point);
    }
    return neighbours_in_plane(triangulation, *at, point, weights);
  });
}

Result<NaturalNeighboursOfMany> natural_neighbours_of_many(
    const DelaunayTriangulation2& triangulation, std::span<const Point2> points,
    NaturalWeights weights, const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<NaturalNeighboursOfMany> {
    if (Result<void> fine = check_natural_in_plane(triangulation, weights, points); !fine) {
      return fine.error();
    }
    if (triangulation.dimension() < 2) return voronoi::no_neighbours(points.size());
    return voronoi::neighbours_of_each(
        triangulation, points, own, [&](const Location2& at, const Point2& point) {
          return neighbours_in_plane(triangulation, at, point, weights);
        });
  });
}

}  // namespace tetloft
