// Voronoi cells in the plane.
#include <tetloft/voronoi2.hpp>

#include <utility>
#include <vector>

#include "c/arrays.hpp"
#include "c/changing.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"

namespace tetloft::internal::c {

namespace {

static_assert(VoronoiEdge2::kEndless == TETLOFT_NO_ID);

ClippingRectangle clipping_rectangle(const double* rectangle) {
  return {{rectangle[0], rectangle[1]}, {rectangle[2], rectangle[3]}};
}

void append_plane_cell(const VoronoiCell2& cell, PlaneCellsValue& all) {
  const std::size_t before = all.corners.size();
  all.corners.insert(all.corners.end(), cell.corners.begin(), cell.corners.end());
  require_countable(all.corners.size());
  for (const VoronoiEdge2& edge : cell.edges) {
    const auto end = [&](std::uint32_t corner) {
      if (!edge.inside || corner == VoronoiEdge2::kEndless) return TETLOFT_NO_ID;
      return static_cast<std::uint32_t>(before + corner);
    };
    all.neighbours.push_back(vertex_number(edge.neighbour));
    all.sides.push_back(static_cast<std::uint8_t>(edge.side));
    all.inside.push_back(edge.inside ? 1 : 0);
    all.ends.push_back({end(edge.ends[0]), end(edge.ends[1])});
    all.lengths.push_back(edge.length);
  }
  all.sites.push_back(vertex_number(cell.site));
  all.bounded.push_back(cell.bounded ? 1 : 0);
  all.areas.push_back(cell.area);
  all.corner_begin.push_back(all.corners.size());
  all.edge_begin.push_back(all.lengths.size());
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;
using tetloft::DelaunayTriangulation2;

tetloft_status tetloft_delaunay_plane_cells(const tetloft_delaunay_plane* delaunay,
                                            const double* rectangle,
                                            const tetloft_execution* execution,
                                            tetloft_plane_cells** cells) {
  clear(cells);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(cells, "cells");
    const tetloft::Execution how = execution_of(execution);
    std::vector<tetloft::VoronoiCell2> made =
        value_of(value->ask([&](const DelaunayTriangulation2& t) {
          return rectangle == nullptr
                     ? tetloft::voronoi_cells(t, how)
                     : tetloft::voronoi_cells(t, clipping_rectangle(rectangle), how);
        }));
    PlaneCellsValue all;
    for (tetloft::VoronoiCell2& cell : made) append_plane_cell(std::exchange(cell, {}), all);
    hand_out(cells, std::move(all));
  });
}

tetloft_status tetloft_delaunay_plane_cell(const tetloft_delaunay_plane* delaunay, uint64_t vertex,
                                           const double* rectangle, tetloft_plane_cells** cells) {
  clear(cells);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(cells, "cells");
    PlaneCellsValue one;
    append_plane_cell(value_of(value->ask([&](const DelaunayTriangulation2& t) {
                        const tetloft::DelaunayVertex site = live_vertex(t, vertex);
                        return rectangle == nullptr
                                   ? tetloft::voronoi_cell(t, site)
                                   : tetloft::voronoi_cell(t, site, clipping_rectangle(rectangle));
                      })),
                      one);
    hand_out(cells, std::move(one));
  });
}

tetloft_status tetloft_plane_cells_sites(const tetloft_plane_cells* cells, const uint64_t** sites,
                                         size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::sites, sites, count);
}

tetloft_status tetloft_plane_cells_bounded(const tetloft_plane_cells* cells,
                                           const uint8_t** bounded, size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::bounded, bounded, count);
}

tetloft_status tetloft_plane_cells_areas(const tetloft_plane_cells* cells, const double** areas,
                                         size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::areas, areas, count);
}

tetloft_status tetloft_plane_cells_corner_begin(const tetloft_plane_cells* cells,
                                                const size_t** begin, size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::corner_begin, begin, count);
}

tetloft_status tetloft_plane_cells_corners(const tetloft_plane_cells* cells, const double** xy,
                                           size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::corners, xy, count);
}

tetloft_status tetloft_plane_cells_edge_begin(const tetloft_plane_cells* cells,
                                              const size_t** begin, size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::edge_begin, begin, count);
}

tetloft_status tetloft_plane_cells_neighbours(const tetloft_plane_cells* cells,
                                              const uint64_t** neighbours, size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::neighbours, neighbours, count);
}

tetloft_status tetloft_plane_cells_sides(const tetloft_plane_cells* cells, const uint8_t** sides,
                                         size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::sides, sides, count);
}

tetloft_status tetloft_plane_cells_inside(const tetloft_plane_cells* cells, const uint8_t** inside,
                                          size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::inside, inside, count);
}

tetloft_status tetloft_plane_cells_ends(const tetloft_plane_cells* cells, const uint32_t** ends,
                                        size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::ends, ends, count);
}

tetloft_status tetloft_plane_cells_lengths(const tetloft_plane_cells* cells, const double** lengths,
                                           size_t* count) {
  return answer_array(cells, "cells", &PlaneCellsValue::lengths, lengths, count);
}

tetloft_status tetloft_plane_cells_free(tetloft_plane_cells* cells) { return free_handle(cells); }

tetloft_status tetloft_delaunay_plane_areas(const tetloft_delaunay_plane* delaunay,
                                            const tetloft_execution* execution, double* areas,
                                            size_t capacity, size_t* count) {
  return ChangingPlane::measured(
      delaunay, execution, areas, capacity, count, "areas",
      [](const DelaunayTriangulation2& t, const tetloft::Execution& how) {
        return tetloft::voronoi_areas(t, how);
      });
}
