// What guarantee 5 is recomputed from, in the stack's unit of length: regions, voids, and the faces
// of each slab.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "check/regions.hpp"
#include "sections/face_overlay.hpp"

namespace tetloft::internal::checking {

/// What an overlay says of one slab.
struct Faces {
  IdVector<sections::FaceId, sections::OverlayFace> faces;
  std::vector<sections::RegionMeeting> meetings;
  std::vector<sections::VoidTouch> touching_voids;
};

/// Voids are the regions of the complement: of each section with a square around it, whose contour
/// comes last. The first of a section is its exterior; the others are named by their outer
/// contours there, which are the section's holes.
class StackVoids {
 public:
  /// Requires a valid stack.
  explicit StackVoids(const SectionStack& given);
  StackVoids(const StackVoids&) = delete;
  StackVoids& operator=(const StackVoids&) = delete;
  StackVoids(StackVoids&&) = default;  // regions point to contours, which stay where they are
  StackVoids& operator=(StackVoids&&) = default;
  ~StackVoids() = default;

  [[nodiscard]] const Regions& regions() const { return regions_; }
  [[nodiscard]] const Regions& voids() const { return voids_; }
  [[nodiscard]] const SectionStack& complement() const { return complement_; }
  /// Per slab. Made anew by each call.
  [[nodiscard]] std::vector<Faces> faces() const;
  [[nodiscard]] std::size_t section_count() const { return regions_.section_count(); }

  [[nodiscard]] bool is_exterior(std::size_t of_void) const {
    return of_void == voids_.first[voids_.section[of_void]];
  }
  /// The hole that names a void which is no exterior.
  [[nodiscard]] ContourId hole(std::size_t of_void) const;
  /// The region around a void that is no exterior.
  [[nodiscard]] std::size_t region_around(std::size_t of_void) const;
  /// The void of this name in section s, the exterior's being invalid; none if it is no hole.
  [[nodiscard]] std::optional<std::size_t> find_void(std::size_t s, ContourId name) const;

 private:
  SectionStack stack_, complement_;
  Regions regions_, voids_;
};

}  // namespace tetloft::internal::checking
