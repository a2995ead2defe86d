// Tets, volume, area, genus and sections: of all and of each component. In plain doubles.
#pragma once

#include <array>
#include <vector>

#include <tetloft/report_page.hpp>

#include "report/subject.hpp"

namespace tetloft::internal::report {

/// Corners as they lie in the space of the model's file, times a power of two that makes the
/// largest coordinate about 1: products of them stay in range.
class MeasuringPoints {
 public:
  explicit MeasuringPoints(const Subject& subject);
  [[nodiscard]] const Point3& operator[](VertexId v) const { return points_[v.index()]; }
  [[nodiscard]] std::array<Point3, 4> corners(const TetVertices& tet) const {
    return {(*this)[tet[0]], (*this)[tet[1]], (*this)[tet[2]], (*this)[tet[3]]};
  }
  /// A length, area or volume (power 1 to 3) of these points, in the unit of the file.
  [[nodiscard]] double back(double measure, int power) const;

 private:
  std::vector<Point3> points_;
  int exponent_ = 0;
};

/// Positive where the tet is.
[[nodiscard]] double tet_volume(const std::array<Point3, 4>& corners);

/// Fills `all`, `components`, `vertices`, `boundary_triangles` and `kinds`.
void measure(const Subject& subject, const MeasuringPoints& points, ReportFigures& figures);

}  // namespace tetloft::internal::report
