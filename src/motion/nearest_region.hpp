// Where an edge of a contour may be the nearest one. Beyond one of its ends it is as far away as
// that end; the edge that follows there is nearer wherever its own foot lies past that end, too. So
// an edge is measured between the normals at its ends, and beyond an end only where the next edge
// has its foot behind that end.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <tetloft/point.hpp>

#include "motion/distance_samples.hpp"
#include "motion/lattice_window.hpp"

namespace tetloft::internal::motion {

/// Indices first ≤ k < end.
struct IndexRange {
  std::int64_t first = 0, end = 0;
  [[nodiscard]] bool empty() const { return first >= end; }
  [[nodiscard]] IndexRange common(const IndexRange& r) const {
    return {std::max(first, r.first), std::min(end, r.end)};
  }
  /// All from the first of both to the last.
  [[nodiscard]] IndexRange joined(const IndexRange& r) const {
    if (empty()) return r;
    return r.empty() ? *this : IndexRange{std::min(first, r.first), std::max(end, r.end)};
  }
};

/// Rows and columns are counted from the first of the window on.
class NearestRegion {
 public:
  /// Edges and `reach` together may be as long, along each axis: the proof counts on it.
  static constexpr double kLongest = 0x1p11;

  /// Among the samples of the window, which are within reach of the edge along each axis.
  NearestRegion(const LatticeEdges::Edge& edge, const LatticeWindow& window);

  /// The rows that have samples of the region; maybe some more.
  [[nodiscard]] IndexRange rows() const;
  /// Its samples in a row, from the first to the last; maybe some more.
  [[nodiscard]] IndexRange in_row(std::int64_t row) const {
    const auto y = static_cast<double>(row);
    const auto size = static_cast<double>(columns_);
    std::array<std::int32_t, 4> cut;
    for (std::size_t k = 0; k < 4; ++k) {
      double at = cuts_.at_0[k] + cuts_.slope[k] * y;
      at = at > 0 ? at : 0;
      at = at < size ? at : size;
      cut[k] = static_cast<std::int32_t>(at);
    }
    return at_end(sides_[0], cut[0], cut[1]).common(at_end(sides_[1], cut[2], cut[3]));
  }

 private:
  /// One coordinate of a line by the other one, and the side of it that counts.
  struct Line {
    double at_0, slope;
    bool upwards;
    [[nodiscard]] IndexRange behind(double other, std::int64_t size) const {
      const double limit = at_0 + slope * other;
      const std::int64_t whole = !(limit >= 0) ? -1
                                 : limit < static_cast<double>(size)
                                     ? static_cast<std::int64_t>(limit)
                                     : size;
      if (upwards) return {std::max(whole, std::int64_t{0}), size};
      return {0, std::min(whole + 1, size)};
    }
  };
  struct HalfPlane {
    Line along_x, along_y;
  };
  /// Which sides of the two lines at an end count; of two different ones `above` comes first.
  enum class Sides : std::uint8_t { above, below, either };
  /// Where a row is cut, by the lines at a, then those at b. A cut is the number of samples not
  /// above the line: the whole part of where the line is, and 1.
  struct Cuts {
    std::array<double, 4> at_0, slope;
  };

  [[nodiscard]] static HalfPlane half_plane(const Point2& vertex, const Point2& direction);

  /// What counts of a row with these cuts.
  [[nodiscard]] IndexRange at_end(Sides sides, std::int64_t first, std::int64_t second) const {
    if (sides == Sides::above) return {std::min(first, second), columns_};
    if (sides == Sides::below) return {0, std::max(first, second)};
    if (second == 0) return {first, columns_};
    return {0, first == columns_ ? second : columns_};
  }

  std::int64_t columns_, rows_;
  /// At a and b, by column: what lies behind them on the edge, and on the next one, turned away.
  std::array<std::array<Line, 2>, 2> ends_;
  /// The same by row.
  std::array<Sides, 2> sides_{};
  Cuts cuts_{};
};

}  // namespace tetloft::internal::motion
