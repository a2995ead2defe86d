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

#include "core/guard.hpp"
#include "core/sort_distinct.hpp"
#include "core/vector.hpp"
#include "voronoi/cut_polygon.hpp"
#include "voronoi/natural_of_many.hpp"
#include "voronoi/natural_weights.hpp"

namespace tetloft {

using namespace internal;
using voronoi::CutPolygon;
using voronoi::Surroundings;

namespace {

Point3 without_z(const Point2& p) { return {p.x, p.y, 0}; }

Surroundings surroundings_in_plane(const DelaunayTriangulation2& triangulation,
                                   const std::vector<DelaunayVertex>& neighbours, const Point2& p) {
  Surroundings around;
  around.vertices = neighbours;
  for (const DelaunayVertex v : neighbours) {
    around.points.push_back(without_z(triangulation.point(v)));
  }
  around.put_offsets_from(without_z(p));
  return around;
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
std::vector<double> areas_taken(const CutPolygon& cell, const Surroundings& around,
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
std::vector<double> lengths_over_distances(const CutPolygon& cell, const Surroundings& around) {
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

// On an edge of the hull its ends alone: those of `at`.
bool is_on_hull_edge(const DelaunayTriangulation2& triangulation, const Location2& at) {
  if (at.kind != LocationKind::edge) return false;
  const auto sides = triangulation.triangles(at.vertices[0], at.vertices[1]);
  return !sides[0].valid() || !sides[1].valid();
}

Result<NaturalNeighbours> weighted_in_plane(const DelaunayTriangulation2& triangulation,
                                            const Location2& at, const Point2& p,
                                            NaturalWeights kind) {
  std::vector<TriangleId> zone;
  Surroundings around;
  const bool on_hull = is_on_hull_edge(triangulation, at);
  if (on_hull) {
    around = surroundings_in_plane(triangulation, {at.vertices[0], at.vertices[1]}, p);
  } else {
    const Result<ConflictZone2> found = triangulation.conflict_zone(p, at.vertices[0]);
    if (!found) return found.error();
    zone = found->triangles;
    around = surroundings_in_plane(triangulation, found->neighbours, p);
  }
  if (Result<void> fine = voronoi::check_neighbours(around); !fine) return fine.error();
  if (on_hull) return voronoi::of_sum_one(around, voronoi::weights_between(around));
  const auto cell = voronoi::cell_among<CutPolygon>([&](CutPolygon& shape) {
    for (const Point3& offset : around.offsets) shape.cut(voronoi::nearer_to_origin(offset));
  });
  if (kind == NaturalWeights::laplace) {
    return voronoi::of_sum_one(around, lengths_over_distances(cell, around));
  }
  const auto pairs = pairs_that_meet(triangulation, zone, around.vertices);
  return voronoi::of_sum_one(around, areas_taken(cell, around, pairs));
}

// Of a point that is not outside.
Result<NaturalNeighbours> plane_neighbours_at(const DelaunayTriangulation2& triangulation,
                                              const Location2& at, const Point2& point,
                                              NaturalWeights weights) {
  if (at.kind == LocationKind::vertex) return NaturalNeighbours{{at.vertices[0]}, {1}};
  return weighted_in_plane(triangulation, at, point, weights);
}

Result<void> check_natural_in_plane(const DelaunayTriangulation2& triangulation,
                                    NaturalWeights weights, std::span<const Point2> points) {
  if (Result<void> fine = voronoi::check_weights(weights); !fine) return fine;
  for (const Point2& p : points) {
    if (Result<void> fine = voronoi::check_asked(without_z(p)); !fine) return fine;
  }
  if (triangulation.constraint_count() == 0) return {};
  return Error{ErrorCode::invalid_input, "among constraints there are no natural neighbours", {}};
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
      return voronoi::refused_at("the vertices span no plane", without_z(point));
    }
    const Result<Location2> at = triangulation.locate(point, near);
    if (!at) return at.error();
    if (at->kind == LocationKind::outside) {
      return voronoi::refused_at("the point is outside of the hull", without_z(point));
    }
    return plane_neighbours_at(triangulation, *at, point, weights);
  });
}

Result<NaturalNeighboursOfMany> natural_neighbours_of_many(
    const DelaunayTriangulation2& triangulation, std::span<const Point2> points,
    NaturalWeights weights, const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<NaturalNeighboursOfMany> {
    if (Result<void> fine = check_natural_in_plane(triangulation, weights, points); !fine) {
      return fine.error();
    }
    if (triangulation.dimension() < 2) return voronoi::natural_of_none(points.size());
    return voronoi::natural_of_many(triangulation, points, own,
                                    [&](const Location2& at, const Point2& p) {
                                      return plane_neighbours_at(triangulation, at, p, weights);
                                    });
  });
}

}  // namespace tetloft
