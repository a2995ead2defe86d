// The rooms into which gates part what is not region beside a contour, and which of them are
// narrow.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/point.hpp>

#include "sections/gates.hpp"

namespace tetloft::internal::sections {

struct Room {
  std::vector<std::size_t> border;  ///< points of the ring, in its order
  std::vector<std::size_t> gates;
  bool is_outside = false;  ///< it has infinity, and is nothing that a border is around
};

struct Rooms {
  std::vector<Room> rooms;
  std::vector<std::size_t> within;  ///< by gate: the room that the ring passes between its ends
  std::vector<std::size_t> beyond;  ///< and the other one
};

/// Requires gates that do not cross.
[[nodiscard]] Rooms part_by_gates(const Ring& ring, const std::vector<Gate>& gates);

/// Is there no room for a disc wider than this, as far as those tell that circumscribe or inscribe
/// Delaunay triangles of the border, nor another contour?
[[nodiscard]] bool is_narrow(const Ring& ring, const Room& room, const OtherEdges& others,
                             std::size_t self, double width);

}  // namespace tetloft::internal::sections
