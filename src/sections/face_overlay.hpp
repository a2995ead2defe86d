// The contours of two sections laid over each other: the faces into which they part the plane.
// Exact: by predicates on the vertices alone, whatever touches, coincides or runs along.
//
// A face is a connected open set off all contours. It lies over a region or a void of the lower
// section, and under one of the upper: SS, SV, VS or VV. Faces that share a point only are two.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::sections {

using FaceId = Id<struct OverlayFaceTag>;

/// What lies in one of the two planes.
struct FaceSide {
  bool solid = false;
  RegionId id;  ///< the region, or the void as complement.hpp numbers them (0 the exterior)
  friend auto operator<=>(const FaceSide&, const FaceSide&) = default;
};

/// A region of either section.
struct BorderRegion {
  bool upper = false;
  RegionId region;
  friend auto operator<=>(const BorderRegion&, const BorderRegion&) = default;
};

struct OverlayFace {
  FaceSide lower, upper;
  /// 1 − its holes, of the face as an open set; of the unbounded one, as if it ended far outside.
  std::int32_t chi = 1;
  /// The regions on whose contours some edge of its border lies, sorted, each once.
  std::vector<BorderRegion> border;
};

class FaceOverlay {
 public:
  /// Requires valid sections and their nestings. Near-linear in vertices and crossings.
  FaceOverlay(const Section& lower, const Nesting& lower_nesting, const Section& upper,
              const Nesting& upper_nesting);

  /// Numbered by (lower, upper), then by their lowest vertex or crossing, as the order of contours
  /// does not matter to. The unbounded face is the first with both exteriors.
  [[nodiscard]] const IdVector<FaceId, OverlayFace>& faces() const { return faces_; }

 private:
  IdVector<FaceId, OverlayFace> faces_;
};

}  // namespace tetloft::internal::sections
