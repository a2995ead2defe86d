// Natural neighbours: the cell that a point would have, and what it would take from whom.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/predicates.hpp>
#include <tetloft/voronoi.hpp>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/vector.hpp"
#include "core/watched_work.hpp"
#include "voronoi/cut_polyhedron.hpp"
#include "voronoi/moderate.hpp"

namespace tetloft {

using namespace internal;
using voronoi::CutPolyhedron;

namespace {

// The neighbours of a point that is no vertex, relative to it, and in a unit near the largest: of
// weights only ratios count, and so no volume leaves the range of doubles.
struct Surroundings {
  std::vector<DelaunayVertex> vertices;
  std::vector<Point3> points;    // as they are
  std::vector<Point3> offsets;   // relative, scaled
  std::optional<Point3> normal;  // on the hull: of its plane
};

// The hull's facets among the tets in conflict that the point is in the plane of: of all planes of
// the hull that it is on one at least, as it is in their closure, so in conflict.
std::vector<std::array<Point3, 3>> hull_planes(const DelaunayTriangulation3& triangulation,
                                               const std::vector<TetId>& zone, const Point3& p) {
  std::vector<std::array<Point3, 3>> planes;
  for (const TetId t : zone) {
    for (int i = 0; i < 4; ++i) {
      const HalfFaceId h = TetMesh::half_face(t, i);
      if (triangulation.opposite(h).valid()) continue;
      const std::array<DelaunayVertex, 3> v = triangulation.vertices(h);
      const std::array<Point3, 3> plane{triangulation.point(v[0]), triangulation.point(v[1]),
                                        triangulation.point(v[2])};
      if (orient3d(plane[0], plane[1], plane[2], p) == Sign::zero) planes.push_back(plane);
    }
  }
  return planes;
}

double largest_coordinate(const std::vector<Point3>& points) {
  double largest = 0;
  for (const Point3& p : points) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

void scale_to_unit(std::vector<Point3>& points) {
  const int exponent = std::ilogb(largest_coordinate(points));
  for (Point3& p : points) p = voronoi::times_power_of_two(p, -exponent);
}

Surroundings surroundings_of(const DelaunayTriangulation3& triangulation, const ConflictZone3& zone,
                             const Point3& p) {
  using namespace vectors;
  const std::vector<std::array<Point3, 3>> planes = hull_planes(triangulation, zone.tets, p);
  Surroundings result;
  for (const DelaunayVertex v : zone.neighbours) {
    const Point3& q = triangulation.point(v);
    const bool inside = std::all_of(planes.begin(), planes.end(), [&](const auto& plane) {
      return orient3d(plane[0], plane[1], plane[2], q) == Sign::zero;
    });
    if (!inside) continue;
    result.vertices.push_back(v);
    result.points.push_back(q);
    result.offsets.push_back(q - p);
  }
  scale_to_unit(result.offsets);
  // The normal of the widest facet.
  double widest = -1;
  for (const std::array<Point3, 3>& plane : planes) {
    const Point3 n = cross(voronoi::nearer_to_origin(plane[1] - plane[0]).normal,
                           voronoi::nearer_to_origin(plane[2] - plane[0]).normal);
    if (!(dot(n, n) > widest)) continue;
    widest = dot(n, n);
    result.normal = unit(n);
  }
  return result;
}

// The cell of the origin among points, in a cube that holds it. On the hull it has no end across
// the plane, and a slice of constant thickness is as good. So near the hull that the cell is more
// than 2^18 times as large as the distances, what is in the cube of that size: what is missing
// changes the weights by some 2^-18, and in larger cells rounding of the bisectors' directions
// tells.
CutPolyhedron cell_among(const Surroundings& around) {
  constexpr double kFirst = 0x1p2, kLarger = 0x1p8, kLast = 0x1p18;
  constexpr double kThickness = 1;
  for (double half = kFirst;; half *= kLarger) {
    CutPolyhedron cell({-half, -half, -half}, {half, half, half});
    for (const Point3& offset : around.offsets) cell.cut(voronoi::nearer_to_origin(offset));
    if (around.normal) {
      const Point3& n = *around.normal;
      cell.cut({n, kThickness});
      cell.cut({{-n.x, -n.y, -n.z}, kThickness});
    }
    const std::vector<voronoi::CutFace> faces = cell.faces();
    if (half >= kLast || std::all_of(faces.begin(), faces.begin() + CutPolyhedron::kBoxFaces,
                                     [](const auto& side) { return side.corners.empty(); })) {
      return cell;
    }
  }
}

// What of the cell is nearest to neighbour i.
double taken_from(const CutPolyhedron& cell, const Surroundings& around, std::size_t i) {
  using namespace vectors;
  CutPolyhedron part = cell;
  for (std::size_t j = 0; j < around.points.size() && !part.empty(); ++j) {
    if (j == i) continue;
    part.cut(voronoi::nearer_to_first(around.offsets[i], around.offsets[j],
                                      around.points[j] - around.points[i]));
  }
  return part.volume();
}

std::vector<double> natural_weights(const CutPolyhedron& cell, const Surroundings& around,
                                    NaturalWeights kind) {
  std::vector<double> weights;
  if (kind == NaturalWeights::sibson) {
    for (std::size_t i = 0; i < around.points.size(); ++i) {
      weights.push_back(taken_from(cell, around, i));
    }
    return weights;
  }
  const std::vector<voronoi::CutFace> faces = cell.faces();
  for (std::size_t i = 0; i < around.points.size(); ++i) {
    const double distance = 2 * voronoi::nearer_to_origin(around.offsets[i]).offset;
    weights.push_back(faces[CutPolyhedron::kBoxFaces + i].area / distance);
  }
  return weights;
}

Error refused_at(const char* why, const Point3& p) {
  Error error{ErrorCode::invalid_input, why, {}};
  error.where.point = p;
  return error;
}

Result<NaturalNeighbours> weighted_neighbours(const DelaunayTriangulation3& triangulation,
                                              const ConflictZone3& zone, const Point3& p,
                                              NaturalWeights kind) {
  const Surroundings around = surroundings_of(triangulation, zone, p);
  for (const DelaunayVertex v : around.vertices) {
    if (!voronoi::is_moderate(triangulation.point(v))) {
      return refused_at("a neighbour's coordinate is beyond 2^300", triangulation.point(v));
    }
  }
  NaturalNeighbours result;
  result.vertices = around.vertices;
  if (around.vertices.size() == 2) {  // the ends of an edge of the hull
    for (const std::size_t other : {std::size_t{1}, std::size_t{0}}) {
      result.weights.push_back(voronoi::nearer_to_origin(around.offsets[other]).offset);
    }
  } else {
    result.weights = natural_weights(cell_among(around), around, kind);
  }
  double sum = 0;
  for (const double w : result.weights) sum += w;
  if (!(sum > 0 && std::isfinite(sum))) {  // vertices within ulps: nothing is left of the cell
    const auto nearest = std::min_element(
        around.offsets.begin(), around.offsets.end(),
        [](const Point3& a, const Point3& b) { return vectors::dot(a, a) < vectors::dot(b, b); });
    result.weights.assign(around.offsets.size(), 0);
    result.weights[static_cast<std::size_t>(nearest - around.offsets.begin())] = sum = 1;
  }
  for (double& w : result.weights) w /= sum;
  return result;
}

Result<void> check_natural(NaturalWeights weights, std::span<const Point3> points) {
  if (!is_enumerator(weights, NaturalWeights::laplace)) {
    return Error{ErrorCode::usage, "there are no such weights of natural neighbours", {}};
  }
  for (const Point3& p : points) {
    if (!voronoi::is_moderate(p)) {
      return refused_at("a coordinate is not finite, or beyond 2^300", p);
    }
  }
  return {};
}

// Of a point that is not outside.
Result<NaturalNeighbours> neighbours_at(const DelaunayTriangulation3& triangulation,
                                        const Location3& at, const Point3& point,
                                        NaturalWeights weights) {
  if (at.kind == LocationKind::vertex) return NaturalNeighbours{{at.vertices[0]}, {1}};
  const Result<ConflictZone3> zone = triangulation.conflict_zone(point, at.vertices[0]);
  if (!zone) return zone.error();
  return weighted_neighbours(triangulation, *zone, point, weights);
}

// Of the points first to last, what NaturalNeighboursOfMany has of all; begin without its 0.
NaturalNeighboursOfMany neighbours_of_stretch(const DelaunayTriangulation3& triangulation,
                                              const std::vector<Location3>& locations,
                                              std::span<const Point3> points, std::size_t first,
                                              std::size_t last, NaturalWeights weights) {
  NaturalNeighboursOfMany found;
  for (std::size_t i = first; i < last; ++i) {
    if (locations[i].kind != LocationKind::outside) {
      const Result<NaturalNeighbours> of =
          neighbours_at(triangulation, locations[i], points[i], weights);
      if (!of) throw Failed(of.error());
      found.vertices.insert(found.vertices.end(), of->vertices.begin(), of->vertices.end());
      found.weights.insert(found.weights.end(), of->weights.begin(), of->weights.end());
    }
    found.begin.push_back(found.vertices.size());
  }
  return found;
}

NaturalNeighboursOfMany joined_neighbours(std::vector<NaturalNeighboursOfMany> parts) {
  NaturalNeighboursOfMany all;
  all.begin.push_back(0);
  for (NaturalNeighboursOfMany& part : parts) {
    const std::size_t before = all.vertices.size();
    for (const std::size_t end : part.begin) all.begin.push_back(before + end);
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    all.weights.insert(all.weights.end(), part.weights.begin(), part.weights.end());
    part = {};
  }
  return all;
}

// Locations are found along a curve, each from the one before; from there on each point is by
// itself.
Result<NaturalNeighboursOfMany> neighbours_of_many(const DelaunayTriangulation3& triangulation,
                                                   std::span<const Point3> points,
                                                   NaturalWeights weights,
                                                   const Execution& execution) {
  constexpr std::size_t kStretch = 256;
  NaturalNeighboursOfMany none;
  none.begin.assign(points.size() + 1, 0);
  if (triangulation.dimension() < 3) return none;
  const std::size_t stretches = (points.size() + kStretch - 1) / kStretch;
  WatchedWork work(execution, stretches + 1);
  work.go_on();
  const Result<std::vector<Location3>> locations = triangulation.locate(points, untold(execution));
  if (!locations) return locations.error();
  work.step_done_go_on();
  std::vector<NaturalNeighboursOfMany> parts(stretches);
  parallel_for(stretches, execution.threads, [&](std::size_t k) {
    parts[k] = neighbours_of_stretch(triangulation, *locations, points, k * kStretch,
                                     std::min(points.size(), (k + 1) * kStretch), weights);
    work.step_done_go_on();
  });
  return joined_neighbours(std::move(parts));
}

}  // namespace

const char* name_of(NaturalWeights weights) {
  switch (weights) {
    case NaturalWeights::sibson: return "sibson";
    case NaturalWeights::laplace: return "laplace";
  }
  return "unknown";
}

Result<NaturalNeighbours> natural_neighbours(const DelaunayTriangulation3& triangulation,
                                             const Point3& point, NaturalWeights weights,
                                             DelaunayVertex near) {
  return guard_internal([&]() -> Result<NaturalNeighbours> {
    if (Result<void> fine = check_natural(weights, {&point, 1}); !fine) return fine.error();
    if (triangulation.dimension() < 3) return refused_at("the vertices span no space", point);
    const Result<Location3> at = triangulation.locate(point, near);
    if (!at) return at.error();
    if (at->kind == LocationKind::outside) {
      return refused_at("the point is outside of the hull", point);
    }
    return neighbours_at(triangulation, *at, point, weights);
  });
}

Result<NaturalNeighboursOfMany> natural_neighbours_of_many(
    const DelaunayTriangulation3& triangulation, std::span<const Point3> points,
    NaturalWeights weights, const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<NaturalNeighboursOfMany> {
    if (Result<void> fine = check_natural(weights, points); !fine) return fine.error();
    return neighbours_of_many(triangulation, points, weights, own);
  });
}

}  // namespace tetloft
