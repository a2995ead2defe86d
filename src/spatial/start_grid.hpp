// Where a search without a hint starts: grids over the points, each cell with a vertex in it, the
// finest of about half as many cells as vertices, each next one half as fine along every axis.
//
// Whatever a cell holds is a start, at worst a long walk away: nothing but time depends on it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

namespace tetloft::internal {

class StartGrid {
 public:
  /// Is it time for a new grid, for so many vertices?
  [[nodiscard]] bool is_outgrown(std::size_t vertices) const { return vertices > most_vertices_; }
  /// A grid for up to some times as many vertices in a box, empty.
  void start_again(const std::array<Point3, 2>& box, std::size_t vertices);
  void add(const Point3& p, VertexId v);

  /// The vertex of the finest cell about p that has a live one; invalid where there is none.
  template <class IsLive>
  [[nodiscard]] VertexId near(const Point3& p, const IsLive& is_live) const {
    Cell at = cell(p);
    for (const Level& level : levels_) {
      const VertexId v = vertices_[level.place(at)];
      if (v.valid() && is_live(v)) return v;
      at = at.halved();
    }
    return {};
  }

 private:
  struct Cell {
    std::array<std::uint32_t, 3> at{};
    [[nodiscard]] Cell halved() const { return {{at[0] / 2, at[1] / 2, at[2] / 2}}; }
  };
  struct Level {
    std::array<std::uint32_t, 3> cells{};
    std::size_t begin = 0;  // in vertices_
    [[nodiscard]] std::size_t place(const Cell& c) const {
      return begin + (std::size_t{c.at[2]} * cells[1] + c.at[1]) * cells[0] + c.at[0];
    }
  };
  [[nodiscard]] Cell cell(const Point3& p) const;

  Point3 low_;
  std::array<double, 3> cells_of_unit_{};
  std::vector<Level> levels_;  // the finest first
  std::vector<VertexId> vertices_;
  std::size_t most_vertices_ = 0;
};

}  // namespace tetloft::internal
