// Where regions and voids of two sections touch, and how regions meet.
#pragma once

#include <array>
#include <vector>

#include "sections/face_overlay.hpp"
#include "sections/overlay_graph.hpp"

namespace tetloft::internal::sections {

struct OverlayTouches {
  std::vector<RegionMeeting> meetings;  ///< sorted
  std::vector<VoidTouch> voids;         ///< sorted, each once
};

/// `face_of_cycle` says which face a cycle of the graph bounds.
[[nodiscard]] OverlayTouches touches_of(const OverlayGraph& graph, const TwoCurves& curves,
                                        const IdVector<FaceId, OverlayFace>& faces,
                                        const std::vector<FaceId>& face_of_cycle,
                                        const std::array<const Nesting*, 2>& nestings);

}  // namespace tetloft::internal::sections
