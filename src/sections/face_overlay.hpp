// The contours of two sections laid over each other: the faces into which they part the plane.
// Exact: by predicates on the vertices alone, whatever touches, coincides or runs along.
//
// A face is a connected open set off all contours. It lies over a region or a void of the lower
// section, and under one of the upper: SS, SV, VS or VV. Faces that share a point only are two.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::sections {

using FaceId = Id<struct OverlayFaceTag>;
inline constexpr FaceId kUnboundedFace{0U};

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

/// A region of the lower section and one of the upper that have a point in common.
///
/// They *touch* where common points lie on no border of an SS face: at a node, or along arcs that
/// have one of the regions on either side; and at a node where two SS faces end that lie apart
/// there. So do voids. What is small enough to be seen neither as solid nor as void may be either:
/// taken for solid, a touch adds its Euler characteristic to that of the SS faces.
struct RegionMeeting {
  RegionId lower, upper;
  bool overlap = false;          ///< there are SS faces
  std::int32_t chi = 0;          ///< of these, in sum
  std::int32_t touches = 0;      ///< the sum of touches that add to it
  std::int32_t connections = 0;  ///< the sum of those that take from it: between faces
};

/// A void of the lower section and one of the upper that touch, and the regions that do so there.
struct VoidTouch {
  RegionId lower, upper;
  RegionId lower_region, upper_region;
  friend auto operator<=>(const VoidTouch&, const VoidTouch&) = default;
};

class FaceOverlay {
 public:
  /// Requires valid sections and their nestings. Near-linear in vertices and crossings.
  FaceOverlay(const Section& lower, const Nesting& lower_nesting, const Section& upper,
              const Nesting& upper_nesting);

  /// Numbered by (lower, upper), then by the least node of their outer cycle as the ends of its
  /// edges tell it, or the lowest vertex: whatever the order and direction of contours. The
  /// first is the unbounded one.
  [[nodiscard]] const IdVector<FaceId, OverlayFace>& faces() const { return faces_; }
  /// Sorted by (lower, upper).
  [[nodiscard]] const std::vector<RegionMeeting>& meetings() const { return meetings_; }
  /// Sorted, each once.
  [[nodiscard]] const std::vector<VoidTouch>& touching_voids() const { return touching_voids_; }

  /// The face that contains p; invalid for a point of a contour. Exact; by a search tree.
  [[nodiscard]] FaceId locate(const Point2& p) const;

  /// The vertices and nodes on the face's border, in no order of meaning, some of them several
  /// times; crossings are rounded.
  [[nodiscard]] std::vector<Point2> border_points(FaceId face) const;

  /// Forgets where faces lie, which is nearly all that an overlay holds: locate() and
  /// border_points() may not be asked any more.
  void forget_plane() { plane_.reset(); }

 private:
  struct Plane;
  IdVector<FaceId, OverlayFace> faces_;
  std::vector<RegionMeeting> meetings_;
  std::vector<VoidTouch> touching_voids_;
  std::shared_ptr<const Plane> plane_;  // copies of an overlay share it
};

}  // namespace tetloft::internal::sections
