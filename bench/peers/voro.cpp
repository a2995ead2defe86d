// Voro++: cells of periodic sets, with all that ours have, and with their volumes alone. Its blocks
// hold about as many points as its own guess has it.
#include "engines.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <voro++/voro++.hh>

#include "measure.hpp"

namespace tetloft::bench {

namespace {

constexpr double kPointsOfBlock = 5.6;
constexpr int kPlacesOfBlock = 8;

// What is asked for of a cell by someone who wants faces, areas and corners.
void read_all(voro::voronoicell_neighbor& cell, const Point3& p) {
  std::vector<int> neighbours, corners_of_faces;
  std::vector<double> areas, normals, corners;
  cell.neighbors(neighbours);
  cell.face_areas(areas);
  cell.normals(normals);
  cell.face_vertices(corners_of_faces);
  cell.vertices(p.x, p.y, p.z, corners);
}
void read_all(voro::voronoicell&, const Point3&) {}

template <class Cell, class Container, class Loop>
void visit_cells(Container& container, Loop loop, const std::vector<Point3>& points,
                 std::vector<double>& volumes) {
  volumes.resize(points.size());
  if (!loop.start()) return;
  do {
    Cell cell;
    if (!container.compute_cell(cell, loop)) throw std::runtime_error("a cell is lost");
    const auto i = static_cast<std::size_t>(loop.pid());
    volumes[i] = cell.volume();
    read_all(cell, points[i]);
  } while (loop.inc());
}

template <class Cell, class Loop, class Container>
void fill_and_visit(Container& container, const std::vector<Point3>& points,
                    std::vector<double>& volumes) {
  int id = 0;
  for (const Point3& p : points) container.put(id++, p.x, p.y, p.z);
  visit_cells<Cell>(container, Loop(container), points, volumes);
}

template <class Cell>
Run cells(const PeriodicWork& work, std::vector<double>& volumes) {
  const Clock clock;
  const auto& [a, b, c] = work.box;
  const double block =
      std::cbrt(a.x * b.y * c.z * kPointsOfBlock / static_cast<double>(work.points.size()));
  const auto blocks = [&](double length) { return std::max(1, static_cast<int>(length / block)); };
  const bool straight = b.x == 0 && c.x == 0 && c.y == 0;
  if (straight) {
    voro::container container(0, a.x, 0, b.y, 0, c.z, blocks(a.x), blocks(b.y), blocks(c.z), true,
                              true, true, kPlacesOfBlock);
    fill_and_visit<Cell, voro::c_loop_all>(container, work.points, volumes);
  } else {
    voro::container_periodic container(a.x, b.x, b.y, c.x, c.y, c.z, blocks(a.x), blocks(b.y),
                                       blocks(c.z), kPlacesOfBlock);
    fill_and_visit<Cell, voro::c_loop_all_periodic>(container, work.points, volumes);
  }
  return {clock.seconds(), volumes.size()};
}

}  // namespace

Peer voro() {
  Peer peer{"Voro++", "", {}, {}};
  peer.periodic = {{"Voro++", cells<voro::voronoicell_neighbor>},
                   {"Voro++, volumes only", cells<voro::voronoicell>}};
  return peer;
}

}  // namespace tetloft::bench
