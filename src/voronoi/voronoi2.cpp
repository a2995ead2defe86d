// The API boundary of Voronoi cells in the plane: checks at entry; cells clipped, as polygons that
// bisectors cut.
#include <tetloft/voronoi2.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/guard.hpp"
#include "core/vertex_places.hpp"
#include "voronoi/cut_polygon.hpp"
#include "voronoi/dual_cell2.hpp"
#include "voronoi/moderate.hpp"
#include "voronoi/sites.hpp"

namespace tetloft {

using namespace internal;
using voronoi::CutPolygon;

namespace {

bool is_moderate_in_plane(const Point2& p) { return voronoi::is_moderate({p.x, p.y, 0}); }

Result<void> check_rectangle(const ClippingRectangle& rectangle) {
  if (!is_moderate_in_plane(rectangle.low) || !is_moderate_in_plane(rectangle.high)) {
    return Error{
        ErrorCode::invalid_input, "a corner of the rectangle is not finite, or beyond 2^300", {}};
  }
  if (rectangle.low.x <= rectangle.high.x && rectangle.low.y <= rectangle.high.y) return {};
  return Error{
      ErrorCode::invalid_input, "the low corner of the rectangle is above the high one", {}};
}

// Each edge of the polygon is that of its number; `place` tells which of the cell's that is.
void put_edges(const CutPolygon& polygon, const std::vector<std::size_t>& place,
               VoronoiCell2& cell) {
  const std::vector<CutPolygon::Corner>& corners = polygon.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    VoronoiEdge2& edge = cell.edges[place[corners[i].edge]];
    edge.inside = true;
    edge.ends = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(next)};
    edge.length = std::hypot(corners[next].point.x - corners[i].point.x,
                             corners[next].point.y - corners[i].point.y);
  }
}

// Among constraints neighbours are not those of the cells.
Result<void> check_cells(const DelaunayTriangulation2& triangulation) {
  if (triangulation.constraint_count() == 0) return {};
  return Error{
      ErrorCode::invalid_input, "a triangulation with constraints has no Voronoi cells", {}};
}

Result<void> check_cells(const DelaunayTriangulation2& triangulation,
                         const ClippingRectangle& rectangle) {
  if (Result<void> fine = check_cells(triangulation); !fine) return fine;
  return check_rectangle(rectangle);
}

Result<void> check_sites_of_plane(const DelaunayTriangulation2& triangulation, DelaunayVertex site,
                                  const std::vector<DelaunayVertex>& neighbours) {
  if (!is_moderate_in_plane(triangulation.point(site))) return voronoi::immoderate_site(site);
  for (const DelaunayVertex v : neighbours) {
    if (!is_moderate_in_plane(triangulation.point(v))) return voronoi::immoderate_site(v);
  }
  return {};
}

Result<VoronoiCell2> cell_in_rectangle(const DelaunayTriangulation2& triangulation,
                                       DelaunayVertex site, const ClippingRectangle& rectangle) {
  const std::vector<DelaunayVertex> neighbours = triangulation.neighbours(site);
  if (Result<void> fine = check_sites_of_plane(triangulation, site, neighbours); !fine) {
    return fine.error();
  }
  const Point2& at = triangulation.point(site);
  CutPolygon polygon({rectangle.low.x - at.x, rectangle.low.y - at.y},
                     {rectangle.high.x - at.x, rectangle.high.y - at.y});
  VoronoiCell2 cell;
  cell.site = site;
  cell.bounded = triangulation.dimension() == 2 && !triangulation.is_on_hull(site);
  std::vector<std::size_t> place(CutPolygon::kSides + neighbours.size());
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const Point2& p = triangulation.point(neighbours[i]);
    polygon.cut(voronoi::nearer_to_origin({p.x - at.x, p.y - at.y, 0}));
    place[CutPolygon::kSides + i] = i;
    cell.edges.push_back({.neighbour = neighbours[i],
                          .side = BoxSide::none,
                          .inside = false,
                          .ends = {},
                          .length = 0});
  }
  for (std::uint8_t side = 0; side < CutPolygon::kSides; ++side) {
    const auto on_side = [&](const CutPolygon::Corner& c) { return c.edge == side; };
    if (std::none_of(polygon.corners().begin(), polygon.corners().end(), on_side)) continue;
    place[side] = cell.edges.size();
    cell.edges.push_back({.neighbour = {},
                          .side = static_cast<BoxSide>(side + 1),
                          .inside = false,
                          .ends = {},
                          .length = 0});
  }
  put_edges(polygon, place, cell);
  cell.area = polygon.area();
  for (const CutPolygon::Corner& c : polygon.corners()) {
    cell.corners.push_back({c.point.x + at.x, c.point.y + at.y});
  }
  return cell;
}

Result<VoronoiCell2> whole_cell_of_plane(const DelaunayTriangulation2& triangulation,
                                         DelaunayVertex site) {
  const std::vector<DelaunayVertex> neighbours = triangulation.neighbours(site);
  if (Result<void> fine = check_sites_of_plane(triangulation, site, neighbours); !fine) {
    return fine.error();
  }
  return voronoi::dual_cell(triangulation, site, neighbours);
}

// That a thread makes at a time.
constexpr std::size_t kPlaneCellsAtOnce = 1024;

}  // namespace

Result<VoronoiCell2> voronoi_cell(const DelaunayTriangulation2& triangulation,
                                  DelaunayVertex site) {
  return guard_internal([&]() -> Result<VoronoiCell2> {
    if (!triangulation.is_live(site)) return no_such_vertex(site);
    if (Result<void> fine = check_cells(triangulation); !fine) return fine.error();
    return whole_cell_of_plane(triangulation, site);
  });
}

Result<std::vector<VoronoiCell2>> voronoi_cells(const DelaunayTriangulation2& triangulation,
                                                const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<VoronoiCell2>> {
    if (Result<void> fine = check_cells(triangulation); !fine) return fine.error();
    return voronoi::all_cells(triangulation, kPlaneCellsAtOnce, own, [&](DelaunayVertex site) {
      return whole_cell_of_plane(triangulation, site);
    });
  });
}

Result<VoronoiCell2> voronoi_cell(const DelaunayTriangulation2& triangulation, DelaunayVertex site,
                                  const ClippingRectangle& rectangle) {
  return guard_internal([&]() -> Result<VoronoiCell2> {
    if (!triangulation.is_live(site)) return no_such_vertex(site);
    if (Result<void> fine = check_cells(triangulation, rectangle); !fine) return fine.error();
    return cell_in_rectangle(triangulation, site, rectangle);
  });
}

Result<std::vector<double>> voronoi_areas(const DelaunayTriangulation2& triangulation,
                                          const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<double>> {
    if (Result<void> fine = check_cells(triangulation); !fine) return fine.error();
    const auto area_of = [&](DelaunayVertex site) -> Result<double> {
      const Result<VoronoiCell2> cell = whole_cell_of_plane(triangulation, site);
      if (!cell) return cell.error();
      return cell->area;
    };
    const std::vector<double> of_live =
        voronoi::all_cells(triangulation, kPlaneCellsAtOnce, own, area_of);
    std::vector<double> areas(triangulation.vertex_slots());
    std::size_t at = 0;
    for (const DelaunayVertex v : triangulation.vertices()) areas[v.index] = of_live[at++];
    return areas;
  });
}

Result<std::vector<VoronoiCell2>> voronoi_cells(const DelaunayTriangulation2& triangulation,
                                                const ClippingRectangle& rectangle,
                                                const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<VoronoiCell2>> {
    if (Result<void> fine = check_cells(triangulation, rectangle); !fine) return fine.error();
    return voronoi::all_cells(triangulation, kPlaneCellsAtOnce, own, [&](DelaunayVertex site) {
      return cell_in_rectangle(triangulation, site, rectangle);
    });
  });
}

}  // namespace tetloft
