// The API boundary of periodic sets: cells and tets out of a cover, with shifts as the caller
// counts them.
#include <tetloft/periodic.hpp>

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/vector.hpp"
#include "core/watched_work.hpp"
#include "periodic/cover.hpp"
#include "periodic/lattice.hpp"
#include "voronoi/cut_polyhedron.hpp"

namespace tetloft {

using namespace internal;
using periodic::Cover;
using periodic::Integers;
using periodic::Lattice;
using periodic::WrappedPoints;
using voronoi::CutPolyhedron;

namespace {

struct PeriodicSet {
  Lattice lattice;
  WrappedPoints wrapped;
  Cover cover;
};

Result<PeriodicSet> periodic_set(std::span<const Point3> points, const PeriodicBox& box,
                                 const Execution& execution) {
  if (Result<void> fit = fp_self_check(); !fit) return fit.error();
  if (points.size() >= std::size_t{1} << 26) {
    return Error{ErrorCode::work_limit, "2^26 points or more", {}};
  }
  PeriodicSet set;
  Result<Lattice> lattice = periodic::reduced_lattice(box);
  if (!lattice) return lattice.error();
  set.lattice = *std::move(lattice);
  Result<WrappedPoints> wrapped = periodic::wrapped(set.lattice, points);
  if (!wrapped) return wrapped.error();
  set.wrapped = *std::move(wrapped);
  if (points.empty()) return set;
  Result<Cover> cover = periodic::covered(set.lattice, set.wrapped, execution);
  if (!cover) return cover.error();
  set.cover = *std::move(cover);
  return set;
}

// Where the image v of the cover is, in boxes from the point as it was given.
Integers shift_of(const PeriodicSet& set, VertexId v) {
  const std::array<std::int32_t, 3>& reduced = set.cover.shift[v.index()];
  Integers shift{};
  for (std::size_t k = 0; k < 3; ++k) {
    shift[k] = -set.wrapped.subtracted[set.cover.point_of[v.index()]][k];
    for (std::size_t i = 0; i < 3; ++i) shift[k] += reduced[i] * set.lattice.in_box[i][k];
  }
  return shift;
}

LatticeShift difference_of(const Integers& to, const Integers& from) {
  LatticeShift result{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t d = to[k] - from[k];
    if (d < -std::numeric_limits<std::int32_t>::max() ||
        d > std::numeric_limits<std::int32_t>::max()) {
      throw Failed({ErrorCode::unrepresentable, "a shift of neighbours is beyond 2^31 boxes", {}});
    }
    result[k] = static_cast<std::int32_t>(d);
  }
  return result;
}
LatticeShift opposite(const LatticeShift& s) { return {-s[0], -s[1], -s[2]}; }

// The images around a point in the cell, each once.
std::vector<VertexId> images_around(const TetMesh& mesh, VertexId v) {
  std::vector<VertexId> around;
  for (const HalfFaceId corner : mesh.corners(v)) {
    for (const VertexId u : mesh.vertices(TetMesh::tet_of(corner))) {
      if (u != v) around.push_back(u);
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

bool face_before(const PeriodicFace& f, const PeriodicFace& g) {
  return std::tie(f.neighbour, f.shift) < std::tie(g.neighbour, g.shift);
}

// The cell is in the ball of the covering radius, so that no side of the first cube is left.
PeriodicCell cell_of(const PeriodicSet& set, VertexId v, CutPolyhedron& polyhedron) {
  using namespace vectors;
  struct Neighbour {
    Point3 offset;  // exact: both are on the grid
    double squared = 0;
    std::size_t point = 0;
    LatticeShift shift{};
  };
  std::vector<Neighbour> neighbours;
  const Integers own = shift_of(set, v);
  const std::vector<VertexId> around = images_around(set.cover.mesh, v);
  neighbours.reserve(around.size());
  for (const VertexId u : around) {
    const Point3 offset = set.cover.points[u.index()] - set.cover.points[v.index()];
    neighbours.push_back({offset, dot(offset, offset), set.cover.point_of[u.index()],
                          difference_of(shift_of(set, u), own)});
  }
  std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::tie(a.squared, a.point, a.shift) < std::tie(b.squared, b.point, b.shift);
  });
  const double half = 1.25 * set.lattice.covering_radius;
  polyhedron.start_again({-half, -half, -half}, {half, half, half});
  PeriodicCell cell;
  cell.faces.resize(neighbours.size());
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const voronoi::HalfSpace half_space = voronoi::nearer_to_origin(neighbours[i].offset);
    polyhedron.cut(half_space);
    cell.faces[i].neighbour = neighbours[i].point;
    cell.faces[i].shift = neighbours[i].shift;
    cell.faces[i].normal = half_space.normal;
  }
  std::vector<voronoi::CutFace> cut_faces = polyhedron.faces();
  for (std::size_t i = 0; i < cell.faces.size(); ++i) {
    voronoi::CutFace& cut = cut_faces[CutPolyhedron::kBoxFaces + i];
    cell.faces[i].area = cut.area;
    cell.faces[i].corners = std::move(cut.corners);
  }
  std::sort(cell.faces.begin(), cell.faces.end(), face_before);
  cell.volume = polyhedron.volume();
  cell.corners = polyhedron.corners();
  return cell;
}

// Of a face and its mirror one is measured: that of the lower point, and of a point and its own
// image that with the lower shift.
void share_areas(std::vector<PeriodicCell>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (PeriodicFace& face : cells[i].faces) {
      PeriodicFace mirror;
      mirror.neighbour = i;
      mirror.shift = opposite(face.shift);
      if (std::tie(i, face.shift) < std::tie(face.neighbour, mirror.shift)) continue;
      const std::vector<PeriodicFace>& across = cells[face.neighbour].faces;
      const auto found = std::lower_bound(across.begin(), across.end(), mirror, face_before);
      TETLOFT_CHECK(found != across.end() && !face_before(mirror, *found));
      face.area = found->area;
      face.normal = {-found->normal.x, -found->normal.y, -found->normal.z};
    }
  }
}

Result<PeriodicVoronoi3> voronoi_of(std::span<const Point3> points, const PeriodicBox& box,
                                    const Execution& execution) {
  constexpr std::size_t kStretch = 256;
  const std::size_t stretches = (points.size() + kStretch - 1) / kStretch;
  WatchedWork work(execution, stretches + 1);
  work.go_on();
  Result<PeriodicSet> set = periodic_set(points, box, execution);
  if (!set) return set.error();
  work.step_done_go_on();
  if (!points.empty()) (void)set->cover.mesh.any_tet(VertexId(0));  // makes the lists of corners
  PeriodicVoronoi3 result;
  result.cells.resize(points.size());
  parallel_for(stretches, execution.threads, [&](std::size_t stretch) {
    const std::size_t end = std::min(points.size(), (stretch + 1) * kStretch);
    CutPolyhedron polyhedron({}, {});
    for (std::size_t i = stretch * kStretch; i < end; ++i) {
      result.cells[i] = cell_of(*set, VertexId(i), polyhedron);
    }
    work.step_done_go_on();
  });
  share_areas(result.cells);
  return result;
}

// The tet as named from its lowest vertex, which is this image of that point: nothing where it is
// another image, of which this one's tet is a translate.
bool name_tet(const PeriodicSet& set, const TetVertices& tet, PeriodicTet& named) {
  std::array<Integers, 4> at{};
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    at[i] = shift_of(set, tet[i]);
    named.points[i] = set.cover.point_of[tet[i].index()];
    if (std::tie(named.points[i], at[i]) < std::tie(named.points[lowest], at[lowest])) lowest = i;
  }
  if (tet[lowest].index() >= set.cover.in_cell) return false;
  for (std::size_t i = 0; i < 4; ++i) named.shifts[i] = difference_of(at[i], at[lowest]);
  return true;
}

// Puts the vertices in order, by an even permutation but for the last two.
void order_vertices(PeriodicTet& tet) {
  std::size_t swaps = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t j = i; j > 0; --j) {
      if (std::tie(tet.points[j - 1], tet.shifts[j - 1]) < std::tie(tet.points[j], tet.shifts[j])) {
        break;
      }
      std::swap(tet.points[j - 1], tet.points[j]);
      std::swap(tet.shifts[j - 1], tet.shifts[j]);
      ++swaps;
    }
  }
  if (swaps % 2 == 0) return;
  std::swap(tet.points[2], tet.points[3]);
  std::swap(tet.shifts[2], tet.shifts[3]);
}

Result<PeriodicDelaunay3> delaunay_of(std::span<const Point3> points, const PeriodicBox& box,
                                      const Execution& execution) {
  WatchedWork work(execution, 1);
  work.go_on();
  const Result<PeriodicSet> set = periodic_set(points, box, execution);
  if (!set) return set.error();
  PeriodicDelaunay3 result;
  for (const TetVertices& tet : set->cover.mesh.tets()) {
    PeriodicTet named;
    if (!name_tet(*set, tet, named)) continue;
    order_vertices(named);
    result.tets.push_back(named);
  }
  std::sort(result.tets.begin(), result.tets.end());
  work.step_done_go_on();
  return result;
}

}  // namespace

Result<PeriodicVoronoi3> periodic_voronoi(std::span<const Point3> points, const PeriodicBox& box,
                                          const Execution& execution) {
  return guard_threads(execution,
                       [&](const Execution& own) { return voronoi_of(points, box, own); });
}

Result<PeriodicDelaunay3> periodic_delaunay(std::span<const Point3> points, const PeriodicBox& box,
                                            const Execution& execution) {
  return guard_threads(execution,
                       [&](const Execution& own) { return delaunay_of(points, box, own); });
}

}  // namespace tetloft
