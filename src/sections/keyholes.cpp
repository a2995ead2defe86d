#include "sections/keyholes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <tetloft/nesting.hpp>
#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "sections/gates.hpp"
#include "sections/point_segment.hpp"
#include "sections/rooms.hpp"

namespace tetloft::internal::sections {

namespace {

Ring ring_of(const Contour& contour, bool is_hole) {
  Ring ring{contour.vertices, std::vector<bool>(contour.vertices.size(), false)};
  const bool clockwise = area_sign(contour) == Sign::negative;
  if (clockwise != is_hole) std::reverse(ring.points.begin(), ring.points.end());
  const auto low =
      std::min_element(ring.points.begin(), ring.points.end(),
                       [](const Point2& p, const Point2& q) { return canonical_less(p, q); });
  std::rotate(ring.points.begin(), low, ring.points.end());
  return ring;
}

OtherEdges edges_of(const Section& section) {
  OtherEdges all;
  std::vector<Box2> boxes;
  for (const ContourId c : section.contours.ids()) {
    const std::vector<Point2>& v = section.contours[c].vertices;
    for (std::size_t k = 0; k < v.size(); ++k) {
      all.edges.push_back({v[k], v[k + 1 == v.size() ? 0 : k + 1]});
      all.contour.push_back(c.index());
      boxes.push_back(box_of(all.edges.back().a, all.edges.back().b));
    }
  }
  all.tree = BoxTree2(boxes);
  return all;
}

// Narrow rooms that hang together, and the gates to the wide ones around them.
struct NarrowPart {
  std::vector<std::size_t> rooms;
  std::vector<std::size_t> ends;
};

std::vector<NarrowPart> narrow_parts(const Rooms& rooms, const std::vector<bool>& narrow) {
  std::vector<NarrowPart> parts;
  std::vector<bool> seen(rooms.rooms.size(), false);
  for (std::size_t first = 0; first < rooms.rooms.size(); ++first) {
    if (!narrow[first] || seen[first]) continue;
    NarrowPart part;
    part.rooms.push_back(first);
    seen[first] = true;
    for (std::size_t k = 0; k < part.rooms.size(); ++k) {
      const std::size_t room = part.rooms[k];
      for (const std::size_t g : rooms.rooms[room].gates) {
        const std::size_t other = rooms.within[g] == room ? rooms.beyond[g] : rooms.within[g];
        if (!narrow[other]) {
          part.ends.push_back(g);
        } else if (!seen[other]) {
          seen[other] = true;
          part.rooms.push_back(other);
        }
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// Both walls have a length: no two ends share a point.
bool has_length(const NarrowPart& part, const std::vector<Gate>& gates) {
  std::set<std::size_t> points;
  for (const std::size_t g : part.ends) {
    if (!points.insert(gates[g].from).second || !points.insert(gates[g].to).second) return false;
  }
  return true;
}

Channel described(const NarrowPart& part, const std::vector<Gate>& gates, const Ring& ring) {
  Channel channel;
  std::vector<Point2> middles;
  for (const std::size_t g : part.ends) {
    const Point2& p = ring.points[gates[g].from];
    const Point2& q = ring.points[gates[g].to];
    if (middles.empty()) channel.at = p;
    channel.width = std::max(channel.width, std::sqrt(square_distance(p, q)));
    middles.push_back({p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2});
    for (const Point2& other : middles) {
      channel.length = std::max(channel.length, std::sqrt(square_distance(other, middles.back())));
    }
  }
  return channel;
}

// The contours of the rooms that stay, the one around all first; points that were added only
// where a gate ends.
std::vector<Contour> contours_without(const Ring& ring, const std::vector<Gate>& ends,
                                      const std::vector<bool>& filled_within) {
  const Rooms rooms = part_by_gates(ring, ends);
  std::vector<bool> filled(rooms.rooms.size(), false);
  for (std::size_t g = 0; g < ends.size(); ++g) {
    filled[filled_within[g] ? rooms.within[g] : rooms.beyond[g]] = true;
  }
  std::vector<bool> needed(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) needed[k] = !ring.added[k];
  for (const Gate& gate : ends) needed[gate.from] = needed[gate.to] = true;
  std::vector<Contour> contours;
  for (std::size_t r = 0; r < rooms.rooms.size(); ++r) {
    if (filled[r]) continue;
    Contour contour;
    for (const std::size_t k : rooms.rooms[r].border) {
      if (needed[k]) contour.vertices.push_back(ring.points[k]);
    }
    const bool first = rooms.rooms[r].is_outside;
    contours.insert(first ? contours.begin() : contours.end(), std::move(contour));
  }
  return contours;
}

// What becomes of a contour, and how; nothing where it has no channel.
struct Opened {
  std::vector<Contour> contours;
  std::vector<Channel> channels;
};
std::optional<Opened> without_channels_of(const Contour& contour, bool is_hole,
                                          const OtherEdges& all, std::size_t self, double width) {
  Ring ring = ring_of(contour, is_hole);
  add_feet(ring, width);
  const std::vector<Gate> gates = find_gates(ring, all, self, width);
  if (gates.size() < 2) return std::nullopt;
  const Rooms rooms = part_by_gates(ring, gates);
  std::vector<bool> narrow;
  for (const Room& room : rooms.rooms) narrow.push_back(is_narrow(ring, room, all, self, width));
  Opened opened;
  std::vector<Gate> ends;
  std::vector<bool> filled_within;
  for (const NarrowPart& part : narrow_parts(rooms, narrow)) {
    if (part.ends.size() < 2 || !has_length(part, gates)) continue;
    opened.channels.push_back(described(part, gates, ring));
    for (const std::size_t g : part.ends) {
      ends.push_back(gates[g]);
      filled_within.push_back(narrow[rooms.within[g]]);
    }
  }
  if (opened.channels.empty()) return std::nullopt;
  opened.contours = contours_without(ring, ends, filled_within);
  return opened;
}

bool is_valid_section(const Section& section) {
  SectionStack alone;
  alone.sections.push_back(section);
  alone.sections[SectionId(0)].z = 0;
  return accepted(validate(alone, {.threads = 1}));
}

Section with_replaced(const Section& section, const IdVector<ContourId, Opened>& opened) {
  Section result;
  result.z = section.z;
  for (const ContourId c : section.contours.ids()) {
    if (opened[c].contours.empty()) result.contours.push_back(section.contours[c]);
    for (const Contour& contour : opened[c].contours) result.contours.push_back(contour);
  }
  return result;
}

}  // namespace

ClosedChannels close_channels(const Section& section, double width) {
  const Nesting nesting = nest(section);
  const OtherEdges all = edges_of(section);
  IdVector<ContourId, Opened> opened(section.contours.size());
  bool any = false;
  for (const ContourId c : section.contours.ids()) {
    const bool is_hole = nesting.depth[c] % 2 != 0;
    auto found = without_channels_of(section.contours[c], is_hole, all, c.index(), width);
    if (!found) continue;
    opened[c] = *std::move(found);
    any = true;
  }
  ClosedChannels result{with_replaced(section, opened), {}};
  if (!any) return result;
  // Points added on edges are rounded: a contour that they bend onto another keeps its channels.
  if (!is_valid_section(result.section)) {
    for (Opened& one : opened) {
      IdVector<ContourId, Opened> alone(section.contours.size());
      const auto c = static_cast<std::size_t>(&one - &opened[ContourId(0)]);
      alone[ContourId(c)] = one;
      if (!is_valid_section(with_replaced(section, alone))) one = {};
    }
    result.section = with_replaced(section, opened);
    if (!is_valid_section(result.section)) return {section, {}};
  }
  for (const ContourId c : opened.ids()) {
    for (Channel channel : opened[c].channels) {
      channel.contour = c;
      result.channels.push_back(channel);
    }
  }
  return result;
}

}  // namespace tetloft::internal::sections
