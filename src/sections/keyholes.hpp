// Channels of a section, by which tools cut holes to the outline, closed: what they are says
// repair() in tetloft/repair.hpp.
#pragma once

#include <vector>

#include <tetloft/section_stack.hpp>

namespace tetloft::internal::sections {

struct Channel {
  ContourId contour;  ///< of the section given
  Point2 at;          ///< an end of its first gate
  double width = 0;   ///< of the widest gate
  double length = 0;  ///< between the middles of the two gates farthest apart
};

struct ClosedChannels {
  Section section;
  std::vector<Channel> channels;
};

/// Requires a valid section and a width above 0. Contours without channel stay as they are; what
/// another becomes stands at its place.
[[nodiscard]] ClosedChannels close_channels(const Section& section, double width);

}  // namespace tetloft::internal::sections
