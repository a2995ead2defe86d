// The API boundary of Voronoi cells: checks at entry; cells clipped, as polyhedra that bisectors
// cut.
#include <tetloft/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/vector.hpp"
#include "core/vertex_places.hpp"
#include "voronoi/cut_polyhedron.hpp"
#include "voronoi/dual_cell.hpp"
#include "voronoi/moderate.hpp"
#include "voronoi/sites.hpp"

namespace tetloft {

using namespace internal;
using voronoi::CutPolyhedron;
using voronoi::is_moderate;

namespace {

Result<void> check_clipping(const ClippingBox& box) {
  Error error{ErrorCode::invalid_input, {}, {}};
  if (!is_moderate(box.low) || !is_moderate(box.high)) {
    error.message = "a corner of the box is not finite, or beyond 2^300";
    error.where.point = is_moderate(box.low) ? box.high : box.low;
    return error;
  }
  if (box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z) return {};
  error.message = "the low corner of the box is above the high one";
  error.where.point = box.low;
  return error;
}

Result<void> check_sites(const DelaunayTriangulation3& triangulation, DelaunayVertex site,
                         const std::vector<DelaunayVertex>& neighbours) {
  Error error;
  const auto fits = [&](DelaunayVertex v) {
    if (is_moderate(triangulation.point(v))) return true;
    error = voronoi::immoderate_site(v);
    error.where.point = triangulation.point(v);
    return false;
  };
  if (fits(site) && std::all_of(neighbours.begin(), neighbours.end(), fits)) return {};
  return error;
}

// Cut by the nearest first, which leaves less to be cut.
std::vector<std::size_t> by_distance(const std::vector<Point3>& points) {
  std::vector<std::size_t> order(points.size());
  std::vector<double> distance(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    order[i] = i;
    distance[i] = vectors::dot(points[i], points[i]);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return distance[i] != distance[j] ? distance[i] < distance[j] : i < j;
  });
  return order;
}

Result<VoronoiCell3> clipped_cell(const DelaunayTriangulation3& triangulation, DelaunayVertex site,
                                  const ClippingBox& box) {
  using namespace vectors;
  const std::vector<DelaunayVertex> neighbours = triangulation.neighbours(site);
  if (Result<void> fine = check_sites(triangulation, site, neighbours); !fine) return fine.error();
  const Point3& at = triangulation.point(site);
  std::vector<Point3> offsets;
  offsets.reserve(neighbours.size());
  for (const DelaunayVertex v : neighbours) offsets.push_back(triangulation.point(v) - at);

  CutPolyhedron polyhedron(box.low - at, box.high - at);
  const std::vector<std::size_t> order = by_distance(offsets);
  for (const std::size_t i : order) polyhedron.cut(voronoi::nearer_to_origin(offsets[i]));
  VoronoiCell3 cell;
  cell.site = site;
  cell.volume = polyhedron.volume();
  cell.corners = polyhedron.corners();
  for (Point3& corner : cell.corners) corner = corner + at;
  std::vector<voronoi::CutFace> cut_faces = polyhedron.faces();
  cell.faces.resize(neighbours.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    voronoi::CutFace& face = cut_faces[CutPolyhedron::kBoxFaces + k];
    cell.faces[order[k]] = {.neighbour = neighbours[order[k]],
                            .side = BoxSide::none,
                            .bounded = true,
                            .corners = std::move(face.corners),
                            .area = face.area};
  }
  for (std::uint8_t side = 0; side < CutPolyhedron::kBoxFaces; ++side) {
    voronoi::CutFace& face = cut_faces[side];
    if (face.corners.empty()) continue;
    cell.faces.push_back({.neighbour = {},
                          .side = static_cast<BoxSide>(side + 1),
                          .bounded = true,
                          .corners = std::move(face.corners),
                          .area = face.area});
  }
  return cell;
}

Result<VoronoiCell3> whole_cell(const DelaunayTriangulation3& triangulation, DelaunayVertex site) {
  const std::vector<DelaunayVertex> neighbours = triangulation.neighbours(site);
  if (Result<void> fine = check_sites(triangulation, site, neighbours); !fine) return fine.error();
  return voronoi::dual_cell(triangulation, site, neighbours);
}

// That a thread makes at a time.
constexpr std::size_t kCellsAtOnce = 256;

}  // namespace

const char* name_of(BoxSide side) {
  switch (side) {
    case BoxSide::none: return "none";
    case BoxSide::low_x: return "low x";
    case BoxSide::high_x: return "high x";
    case BoxSide::low_y: return "low y";
    case BoxSide::high_y: return "high y";
    case BoxSide::low_z: return "low z";
    case BoxSide::high_z: return "high z";
  }
  return "unknown";
}

Result<VoronoiCell3> voronoi_cell(const DelaunayTriangulation3& triangulation,
                                  DelaunayVertex site) {
  return guard_internal([&]() -> Result<VoronoiCell3> {
    if (!triangulation.is_live(site)) return no_such_vertex(site);
    return whole_cell(triangulation, site);
  });
}

Result<VoronoiCell3> voronoi_cell(const DelaunayTriangulation3& triangulation, DelaunayVertex site,
                                  const ClippingBox& box) {
  return guard_internal([&]() -> Result<VoronoiCell3> {
    if (!triangulation.is_live(site)) return no_such_vertex(site);
    if (Result<void> fine = check_clipping(box); !fine) return fine.error();
    return clipped_cell(triangulation, site, box);
  });
}

Result<std::vector<VoronoiCell3>> voronoi_cells(const DelaunayTriangulation3& triangulation,
                                                const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<VoronoiCell3>> {
    return voronoi::all_cells(triangulation, kCellsAtOnce, own,
                              [&](DelaunayVertex site) { return whole_cell(triangulation, site); });
  });
}

Result<std::vector<VoronoiCell3>> voronoi_cells(const DelaunayTriangulation3& triangulation,
                                                const ClippingBox& box,
                                                const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<VoronoiCell3>> {
    if (Result<void> fine = check_clipping(box); !fine) return fine.error();
    return voronoi::all_cells(triangulation, kCellsAtOnce, own, [&](DelaunayVertex site) {
      return clipped_cell(triangulation, site, box);
    });
  });
}

}  // namespace tetloft
