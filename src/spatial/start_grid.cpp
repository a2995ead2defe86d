#include "spatial/start_grid.hpp"

#include <algorithm>
#include <cmath>

namespace tetloft::internal {

namespace {

// A grid serves until it has so many times the vertices it was made for.
constexpr std::size_t kGrowth = 4;
// Vertices to a cell, when it is made.
constexpr double kVerticesOfCell = 2;

// How many cells along each axis, so that cells are about cubes and so many in all.
std::array<std::uint32_t, 3> grid_for(const std::array<double, 3>& extent, double cells) {
  std::array<std::uint32_t, 3> result{1, 1, 1};
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](std::size_t a, std::size_t b) { return extent[a] < extent[b]; });
  // The shortest first: where it is too short for a second cell, the others share all.
  for (std::size_t k = 0; k < 3; ++k) {
    double side = 1;
    for (std::size_t j = k; j < 3; ++j) side *= extent[axes[j]];
    side = std::pow(side / cells, 1.0 / static_cast<double>(3 - k));
    const double most = std::pow(cells, 1.0 / static_cast<double>(3 - k));
    double along = side > 0 ? extent[axes[k]] / side : 1;
    if (!(along < 2 * most)) along = most;
    result[axes[k]] = static_cast<std::uint32_t>(std::max(1.0, along));
    cells = std::max(1.0, cells / result[axes[k]]);
  }
  return result;
}

}  // namespace

void StartGrid::start_again(const std::array<Point3, 2>& box, std::size_t vertices) {
  const Point3& low = box[0];
  const Point3& high = box[1];
  most_vertices_ = kGrowth * std::max<std::size_t>(vertices, 16);
  low_ = low;
  const std::array<double, 3> extent{high.x - low.x, high.y - low.y, high.z - low.z};
  levels_.clear();
  std::array<std::uint32_t, 3> cells =
      grid_for(extent, std::max(1.0, static_cast<double>(vertices) / kVerticesOfCell));
  for (std::size_t k = 0; k < 3; ++k) {
    const double all = cells[k];
    cells_of_unit_[k] = extent[k] > 0 && std::isfinite(all / extent[k]) ? all / extent[k] : 0;
  }
  std::size_t end = 0;
  for (;;) {
    levels_.push_back({cells, end});
    end += std::size_t{cells[0]} * cells[1] * cells[2];
    if (cells[0] == 1 && cells[1] == 1 && cells[2] == 1) break;
    for (std::uint32_t& n : cells) n = (n + 1) / 2;
  }
  vertices_.assign(end, VertexId());
}

StartGrid::Cell StartGrid::cell(const Point3& p) const {
  const std::array<double, 3> from{p.x - low_.x, p.y - low_.y, p.z - low_.z};
  Cell result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = from[k] * cells_of_unit_[k];
    const std::uint32_t last = levels_.empty() ? 0 : levels_.front().cells[k] - 1;
    result.at[k] = along > 0 ? static_cast<std::uint32_t>(std::min<double>(along, last)) : 0;
  }
  return result;
}

void StartGrid::add(const Point3& p, VertexId v) {
  Cell at = cell(p);
  for (const Level& level : levels_) {
    vertices_[level.place(at)] = v;
    at = at.halved();
  }
}

}  // namespace tetloft::internal
