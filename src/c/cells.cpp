// Voronoi cells, of changing triangulations and of periodic sets, and what goes with them.
#include <tetloft/voronoi.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <tetloft/periodic.hpp>

#include "c/arrays.hpp"
#include "c/changing.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"

namespace tetloft::internal::c {

namespace {

static_assert(TETLOFT_SIDE_NONE == static_cast<int>(BoxSide::none) &&
              TETLOFT_SIDE_LOW_X == static_cast<int>(BoxSide::low_x) &&
              TETLOFT_SIDE_HIGH_Z == static_cast<int>(BoxSide::high_z));

ClippingBox clipping_box(const double* box) {
  return {{box[0], box[1], box[2]}, {box[3], box[4], box[5]}};
}

// Puts the corners of a face, which are places among its cell's, behind the others.
void append_face_corners(const std::vector<std::uint32_t>& corners, CellsValue& all) {
  const std::size_t before = all.corner_begin.back();
  for (const std::uint32_t corner : corners) {
    all.face_corners.push_back(static_cast<std::uint32_t>(before + corner));
  }
  all.face_corner_begin.push_back(all.face_corners.size());
}

// Puts what all kinds of cells have behind the others; its faces are there already.
void append_cell(VertexNumber site, bool bounded, double volume, const std::vector<Point3>& corners,
                 CellsValue& all) {
  all.sites.push_back(site);
  all.bounded.push_back(bounded ? 1 : 0);
  all.volumes.push_back(volume);
  all.corners.insert(all.corners.end(), corners.begin(), corners.end());
  require_countable(all.corners.size());
  all.corner_begin.push_back(all.corners.size());
  all.face_begin.push_back(all.areas.size());
}

void append(const VoronoiCell3& cell, CellsValue& all) {
  for (const VoronoiFace3& face : cell.faces) {
    all.neighbours.push_back(vertex_number(face.neighbour));
    all.sides.push_back(static_cast<std::uint8_t>(face.side));
    all.faces_bounded.push_back(face.bounded ? 1 : 0);
    all.areas.push_back(face.area);
    append_face_corners(face.corners, all);
  }
  append_cell(vertex_number(cell.site), cell.bounded, cell.volume, cell.corners, all);
}

void append(std::size_t site, const PeriodicCell& cell, CellsValue& all) {
  for (const PeriodicFace& face : cell.faces) {
    all.neighbours.push_back(face.neighbour);
    all.sides.push_back(TETLOFT_SIDE_NONE);
    all.faces_bounded.push_back(1);
    all.areas.push_back(face.area);
    all.shifts.push_back(face.shift);
    all.normals.push_back(face.normal);
    append_face_corners(face.corners, all);
  }
  append_cell(site, true, cell.volume, cell.corners, all);
}

// Each cell is gone once it is flat: there are never two copies of all.
CellsValue flat(std::vector<VoronoiCell3> cells) {
  CellsValue all;
  for (VoronoiCell3& cell : cells) append(std::exchange(cell, {}), all);
  return all;
}

CellsValue flat(PeriodicVoronoi3 voronoi) {
  CellsValue all;
  for (std::size_t i = 0; i < voronoi.cells.size(); ++i) {
    append(i, std::exchange(voronoi.cells[i], {}), all);
  }
  return all;
}

// Centre and radius.
using SphereNumbers = std::array<double, 4>;
SphereNumbers sphere_through(const std::array<Point3, 4>& p) {
  const Sphere3 sphere = circumsphere(p[0], p[1], p[2], p[3]);
  return {sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius};
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;
using tetloft::DelaunayTriangulation3;

tetloft_status tetloft_delaunay_cells(const tetloft_delaunay* delaunay, const double* box,
                                      const tetloft_execution* execution, tetloft_cells** cells) {
  clear(cells);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(cells, "cells");
    const tetloft::Execution how = execution_of(execution);
    hand_out(cells, flat(value_of(value->ask([&](const DelaunayTriangulation3& t) {
               return box == nullptr ? tetloft::voronoi_cells(t, how)
                                     : tetloft::voronoi_cells(t, clipping_box(box), how);
             }))));
  });
}

tetloft_status tetloft_delaunay_cell(const tetloft_delaunay* delaunay, uint64_t vertex,
                                     const double* box, tetloft_cells** cells) {
  clear(cells);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(cells, "cells");
    CellsValue one;
    append(value_of(value->ask([&](const DelaunayTriangulation3& t) {
             const tetloft::DelaunayVertex site = live_vertex(t, vertex);
             return box == nullptr ? tetloft::voronoi_cell(t, site)
                                   : tetloft::voronoi_cell(t, site, clipping_box(box));
           })),
           one);
    hand_out(cells, std::move(one));
  });
}

tetloft_status tetloft_periodic_voronoi(const double* xyz, size_t point_count, const double* box,
                                        const tetloft_execution* execution, tetloft_cells** cells) {
  clear(cells);
  return answer([&] {
    require_output(cells, "cells");
    const tetloft::Execution how = execution_of(execution);
    const tetloft::PeriodicBox vectors = periodic_box(box);
    hand_out(
        cells,
        flat(value_of(tetloft::periodic_voronoi(space_points(xyz, point_count), vectors, how))));
  });
}

tetloft_status tetloft_cells_sites(const tetloft_cells* cells, const uint64_t** sites,
                                   size_t* count) {
  return answer_array(cells, "cells", &CellsValue::sites, sites, count);
}

tetloft_status tetloft_cells_bounded(const tetloft_cells* cells, const uint8_t** bounded,
                                     size_t* count) {
  return answer_array(cells, "cells", &CellsValue::bounded, bounded, count);
}

tetloft_status tetloft_cells_volumes(const tetloft_cells* cells, const double** volumes,
                                     size_t* count) {
  return answer_array(cells, "cells", &CellsValue::volumes, volumes, count);
}

tetloft_status tetloft_cells_corner_begin(const tetloft_cells* cells, const size_t** begin,
                                          size_t* count) {
  return answer_array(cells, "cells", &CellsValue::corner_begin, begin, count);
}

tetloft_status tetloft_cells_corners(const tetloft_cells* cells, const double** xyz,
                                     size_t* count) {
  return answer_array(cells, "cells", &CellsValue::corners, xyz, count);
}

tetloft_status tetloft_cells_face_begin(const tetloft_cells* cells, const size_t** begin,
                                        size_t* count) {
  return answer_array(cells, "cells", &CellsValue::face_begin, begin, count);
}

tetloft_status tetloft_cells_neighbours(const tetloft_cells* cells, const uint64_t** neighbours,
                                        size_t* count) {
  return answer_array(cells, "cells", &CellsValue::neighbours, neighbours, count);
}

tetloft_status tetloft_cells_sides(const tetloft_cells* cells, const uint8_t** sides,
                                   size_t* count) {
  return answer_array(cells, "cells", &CellsValue::sides, sides, count);
}

tetloft_status tetloft_cells_faces_bounded(const tetloft_cells* cells, const uint8_t** bounded,
                                           size_t* count) {
  return answer_array(cells, "cells", &CellsValue::faces_bounded, bounded, count);
}

tetloft_status tetloft_cells_areas(const tetloft_cells* cells, const double** areas,
                                   size_t* count) {
  return answer_array(cells, "cells", &CellsValue::areas, areas, count);
}

tetloft_status tetloft_cells_face_corner_begin(const tetloft_cells* cells, const size_t** begin,
                                               size_t* count) {
  return answer_array(cells, "cells", &CellsValue::face_corner_begin, begin, count);
}

tetloft_status tetloft_cells_face_corners(const tetloft_cells* cells, const uint32_t** corners,
                                          size_t* count) {
  return answer_array(cells, "cells", &CellsValue::face_corners, corners, count);
}

tetloft_status tetloft_cells_shifts(const tetloft_cells* cells, const int32_t** shifts,
                                    size_t* count) {
  return answer_array(cells, "cells", &CellsValue::shifts, shifts, count);
}

tetloft_status tetloft_cells_normals(const tetloft_cells* cells, const double** normals,
                                     size_t* count) {
  return answer_array(cells, "cells", &CellsValue::normals, normals, count);
}

tetloft_status tetloft_cells_free(tetloft_cells* cells) { return free_handle(cells); }

tetloft_status tetloft_delaunay_volumes(const tetloft_delaunay* delaunay,
                                        const tetloft_execution* execution, double* volumes,
                                        size_t capacity, size_t* count) {
  return ChangingSpace::measured(
      delaunay, execution, volumes, capacity, count, "volumes",
      [](const DelaunayTriangulation3& t, const tetloft::Execution& how) {
        return tetloft::voronoi_volumes(t, how);
      });
}

tetloft_status tetloft_delaunay_circumspheres(const tetloft_delaunay* delaunay, double* spheres,
                                              size_t capacity, size_t* count) {
  return ChangingSpace::counted(
      delaunay, spheres, capacity, count, "spheres",
      [](const DelaunayTriangulation3& t) { return t.tet_count(); },
      [](const DelaunayTriangulation3& t, double* to) {
        for (const tetloft::TetId tet : t.tets()) {
          const auto v = t.vertices(tet);
          const SphereNumbers sphere =
              sphere_through({t.point(v[0]), t.point(v[1]), t.point(v[2]), t.point(v[3])});
          to = std::copy(sphere.begin(), sphere.end(), to);
        }
      });
}

tetloft_status tetloft_circumsphere(const double* xyz, double* sphere) {
  if (sphere != nullptr) std::fill_n(sphere, 4, 0.0);
  return answer([&] {
    require_output(sphere, "sphere");
    require_array(xyz, 4, sizeof(tetloft::Point3), "xyz");
    const std::vector<tetloft::Point3> p = space_points(xyz, 4);
    const SphereNumbers found = sphere_through({p[0], p[1], p[2], p[3]});
    std::copy_n(found.begin(), 4, sphere);
  });
}
