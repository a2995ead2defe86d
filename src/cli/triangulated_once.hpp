// The points of `delaunay` as a triangulation that answers questions, made when one is asked first.
#pragma once

#include <optional>
#include <span>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

#include "cli/console.hpp"

namespace tetloft::cli {

class TriangulatedOnce {
 public:
  /// The points last as long.
  TriangulatedOnce(std::span<const Point3> points, unsigned threads)
      : points_(points), execution_{.threads = threads} {}

  [[nodiscard]] Result<const DelaunayTriangulation3*> get() {
    if (!made_) {
      const Stopwatch triangulating;
      auto made = DelaunayTriangulation3::of(points_, execution_);
      if (!made) return made.error();
      seconds_ = triangulating.seconds();
      made_ = *std::move(made);
    }
    return &*made_;
  }
  [[nodiscard]] std::span<const Point3> points() const { return points_; }
  [[nodiscard]] const Execution& execution() const { return execution_; }
  /// That it took.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  std::span<const Point3> points_;
  Execution execution_;
  std::optional<DelaunayTriangulation3> made_;
  double seconds_ = 0;
};

}  // namespace tetloft::cli
