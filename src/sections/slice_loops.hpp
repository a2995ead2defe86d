// The loops in which planes of constant z cross a closed mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "sections/closed_mesh.hpp"

namespace tetloft::internal::sections {

/// Goes through planes from the lowest up. A vertex in a plane counts as above it.
class LoopSweep {
 public:
  /// `heights` increase. Both must outlive the sweep.
  LoopSweep(const ClosedMesh& mesh, const std::vector<double>& heights);

  /// How often planes cross triangles, in all.
  [[nodiscard]] std::uint64_t crossings() const { return crossings_; }

  struct Loops {
    std::vector<Contour> contours;  ///< no vertex follows an equal one
    std::size_t without_area = 0;   ///< that were left out
  };
  /// Of the next plane. Inside is left of a loop where triangles turn counter-clockwise as seen
  /// from outside.
  [[nodiscard]] Loops next();

 private:
  [[nodiscard]] bool above(std::uint32_t vertex) const {
    return mesh_.points[vertex].z >= heights_[plane_];
  }
  /// Whether the half-edge is crossed, and upwards or downwards.
  [[nodiscard]] bool climbs(std::uint32_t half_edge, bool upwards) const {
    return above(mesh_.to(half_edge)) == upwards && above(mesh_.from(half_edge)) != upwards;
  }
  /// The half-edge of the triangle that is crossed so; each triangle crossed has one of either
  /// kind.
  [[nodiscard]] std::uint32_t crossed(std::uint32_t triangle, bool upwards) const;
  [[nodiscard]] Contour follow(std::uint32_t triangle);

  const ClosedMesh& mesh_;
  const std::vector<double>& heights_;
  std::uint64_t crossings_ = 0;
  std::size_t plane_ = 0;
  // Triangles by the first plane that crosses them: those of plane k from begin_[k] on.
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> starting_;
  std::vector<std::uint32_t> active_;  // ascending
  std::vector<std::uint32_t> seen_;    // by triangle: the last plane whose loops passed it, plus 1
};

}  // namespace tetloft::internal::sections
