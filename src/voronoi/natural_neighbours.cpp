// Natural neighbours: the cell that a point would have, and what it would take from whom.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/predicates.hpp>
#include <tetloft/voronoi.hpp>

#include "core/guard.hpp"
#include "core/vector.hpp"
#include "voronoi/cut_polyhedron.hpp"
#include "voronoi/flag_volumes.hpp"
#include "voronoi/moderate.hpp"
#include "voronoi/natural_of_many.hpp"
#include "voronoi/natural_weights.hpp"

namespace tetloft {

using namespace internal;
using voronoi::CutPolyhedron;
using voronoi::Surroundings;

namespace {

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
  }
  result.put_offsets_from(p);
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

// The cell of the origin among points. On the hull it has no end across the plane, and a slice of
// constant thickness is as good.
CutPolyhedron cell_in_space(const Surroundings& around) {
  constexpr double kThickness = 1;
  return voronoi::cell_among<CutPolyhedron>([&](CutPolyhedron& cell) {
    for (const Point3& offset : around.offsets) cell.cut(voronoi::nearer_to_origin(offset));
    if (!around.normal) return;
    const Point3& n = *around.normal;
    cell.cut({n, kThickness});
    cell.cut({{-n.x, -n.y, -n.z}, kThickness});
  });
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
  const CutPolyhedron cell = cell_in_space(around);
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

Result<NaturalNeighbours> weighted_neighbours(const DelaunayTriangulation3& triangulation,
                                              const ConflictZone3& zone, const Point3& p,
                                              NaturalWeights kind) {
  const Surroundings around = surroundings_of(triangulation, zone, p);
  if (Result<void> fine = voronoi::check_neighbours(around); !fine) return fine.error();
  return voronoi::of_sum_one(around, around.vertices.size() == 2  // the ends of an edge of the hull
                                         ? voronoi::weights_between(around)
                                         : natural_weights(triangulation, zone, around, p, kind));
}

Result<void> check_natural(NaturalWeights weights, std::span<const Point3> points) {
  if (Result<void> fine = voronoi::check_weights(weights); !fine) return fine;
  for (const Point3& p : points) {
    if (Result<void> fine = voronoi::check_asked(p); !fine) return fine;
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
    if (triangulation.dimension() < 3)
      return voronoi::refused_at("the vertices span no space", point);
    const Result<Location3> at = triangulation.locate(point, near);
    if (!at) return at.error();
    if (at->kind == LocationKind::outside) {
      return voronoi::refused_at("the point is outside of the hull", point);
    }
    return neighbours_at(triangulation, *at, point, weights);
  });
}

Result<NaturalNeighboursOfMany> natural_neighbours_of_many(
    const DelaunayTriangulation3& triangulation, std::span<const Point3> points,
    NaturalWeights weights, const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<NaturalNeighboursOfMany> {
    if (Result<void> fine = check_natural(weights, points); !fine) return fine.error();
    if (triangulation.dimension() < 3) return voronoi::natural_of_none(points.size());
    return voronoi::natural_of_many(triangulation, points, own,
                                    [&](const Location3& at, const Point3& p) {
                                      return neighbours_at(triangulation, at, p, weights);
                                    });
  });
}

}  // namespace tetloft
