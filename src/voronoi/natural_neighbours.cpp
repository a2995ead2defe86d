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
#include "voronoi/cut_polyhedron.hpp"
#include "voronoi/flag_volumes.hpp"
#include "voronoi/many_neighbours.hpp"
#include "voronoi/moderate.hpp"

namespace tetloft {

using namespace internal;
using voronoi::CutPolyhedron;

namespace {

// The neighbours of a point that is no vertex, relative to it, and in a unit near the largest: of
// weights only ratios count, and so no volume leaves the range of doubles.
struct Surroundings {
  std::vector<DelaunayVertex> vertices;
  std::vector<Point3> points;   // as they are
  std::vector<Point3> offsets;  // relative, divided by 2^exponent
  int exponent = 0;
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

// Divides by a power of two near the largest; its exponent.
int scale_to_unit(std::vector<Point3>& points) {
  const int exponent = std::ilogb(largest_coordinate(points));
  for (Point3& p : points) p = voronoi::times_power_of_two(p, -exponent);
  return exponent;
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
  result.exponent = scale_to_unit(result.offsets);
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

// What the new cell takes from each: the parts of the old cells in the tets that go, less those of
// the cells that stay in the tets that come. Nothing where what cancels is so much larger than the
// cell, as in tets that are flat, that rounding might tell.
class TakenByTets {
 public:
  TakenByTets(const DelaunayTriangulation3& triangulation, const Surroundings& around,
              const Point3& p)
      : triangulation_(triangulation),
        around_(around),
        point_(voronoi::times_power_of_two(p, -around.exponent)),
        taken_(around.vertices.size()) {
    for (const Point3& q : around.points) {
      points_.push_back(voronoi::times_power_of_two(q, -around.exponent));
    }
  }

  std::vector<double> of(const ConflictZone3& zone) {
    for (const TetId t : zone.tets) {
      const std::array<std::size_t, 4> v = places(triangulation_.vertices(t));
      add({points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]}, v, 1);
    }
    for (const HalfFaceId h : zone.horizon) {
      const std::array<std::size_t, 3> v = places(triangulation_.vertices(h));
      add({points_[v[0]], points_[v[1]], points_[v[2]], point_}, v, -1);
    }
    double sum = 0;
    for (double& volume : taken_) sum += volume = std::max(volume, 0.0);
    constexpr double kMostCancelled = 0x1p10;
    if (!(terms_ < kMostCancelled * sum)) taken_.clear();
    return std::move(taken_);
  }

 private:
  template <std::size_t n>
  std::array<std::size_t, n> places(const std::array<DelaunayVertex, n>& vertices) const {
    std::array<std::size_t, n> result{};
    std::transform(vertices.begin(), vertices.end(), result.begin(), [&](DelaunayVertex v) {
      const auto found = std::lower_bound(around_.vertices.begin(), around_.vertices.end(), v);
      return static_cast<std::size_t>(found - around_.vertices.begin());
    });
    return result;
  }

  // The new vertex, if it is one of the tet's, is the last.
  template <std::size_t n>
  void add(const std::array<Point3, 4>& tet, const std::array<std::size_t, n>& vertices, int sign) {
    voronoi::for_each_corner(
        tet, [&](std::size_t i, const voronoi::CornerOfTet& corner, int exponent) {
          if (i >= n) return;
          taken_[vertices[i]] += std::ldexp(sign * voronoi::flag_volume(corner), 3 * exponent);
          terms_ += std::ldexp(voronoi::flag_volume_terms(corner), 3 * exponent);
        });
  }

  const DelaunayTriangulation3& triangulation_;
  const Surroundings& around_;
  Point3 point_;
  std::vector<Point3> points_;
  std::vector<double> taken_;
  double terms_ = 0;
};

std::vector<double> natural_weights(const DelaunayTriangulation3& triangulation,
                                    const ConflictZone3& zone, const Surroundings& around,
                                    const Point3& p, NaturalWeights kind) {
  std::vector<double> weights;
  if (kind == NaturalWeights::sibson && !around.normal) {
    weights = TakenByTets(triangulation, around, p).of(zone);
    if (!weights.empty()) return weights;
  }
  const CutPolyhedron cell = cell_among(around);
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
    result.weights = natural_weights(triangulation, zone, around, p, kind);
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
    if (triangulation.dimension() < 3) return voronoi::no_neighbours(points.size());
    return voronoi::neighbours_of_each(triangulation, points, own,
                                       [&](const Location3& at, const Point3& point) {
                                         return neighbours_at(triangulation, at, point, weights);
                                       });
  });
}

}  // namespace tetloft
