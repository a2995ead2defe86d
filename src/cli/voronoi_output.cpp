// See voronoi_output.hpp.
#include "cli/voronoi_output.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/voronoi.hpp>

namespace tetloft::cli {

namespace {

// About the points, and a tenth of its longest side larger; of one point, or equal ones, 2 wide.
ClippingBox box_about(std::span<const Point3> points) {
  ClippingBox box;
  if (points.empty()) return box;
  box = {points.front(), points.front()};
  for (const Point3& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  const double side =
      std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
  const double margin = side > 0 ? side / 10 : 1;
  box.low = {box.low.x - margin, box.low.y - margin, box.low.z - margin};
  box.high = {box.high.x + margin, box.high.y + margin, box.high.z + margin};
  return box;
}

void add_cell(const VoronoiCell3& cell, PolyhedronSet& set) {
  const auto first = static_cast<std::uint32_t>(set.points.size());
  set.points.insert(set.points.end(), cell.corners.begin(), cell.corners.end());
  std::vector<PolyhedronSet::Face> faces;
  double neighbours = 0;
  double clipped = 0;
  for (const VoronoiFace3& face : cell.faces) {
    if (face.corners.size() < 3) continue;
    (face.side == BoxSide::none ? neighbours : clipped) += 1;
    faces.push_back(face.corners);
    for (std::uint32_t& corner : faces.back()) corner += first;
  }
  set.cells.push_back(std::move(faces));
  const std::array<double, 4> values{static_cast<double>(cell.site.index), cell.volume, neighbours,
                                     clipped > 0 ? 1.0 : 0.0};
  for (std::size_t k = 0; k < values.size(); ++k) set.data[k].value.push_back(values[k]);
}

}  // namespace

Option voronoi_option() {
  return {
      "--voronoi", "OUT",
      "write the Voronoi cells as polyhedra (.vtu), with the index of their point, volume and "
      "number of neighbours, clipped to the points' box and a tenth of its longest side about it"};
}

Result<PolyhedronSet> voronoi_polyhedra(TriangulatedOnce& points) {
  const auto triangulation = points.get();
  if (!triangulation) return triangulation.error();
  const auto cells = voronoi_cells(**triangulation, box_about(points.points()), points.execution());
  if (!cells) return cells.error();
  PolyhedronSet set{{}, {}, {{"point", {}}, {"volume", {}}, {"neighbours", {}}, {"clipped", {}}}};
  for (const VoronoiCell3& cell : *cells) add_cell(cell, set);
  return set;
}

}  // namespace tetloft::cli
