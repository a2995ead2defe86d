// Stacks from bytes.
#pragma once

#include <tetloft/reconstruct.hpp>
#include <tetloft/sections.hpp>

#include "fuzz/target.hpp"

namespace tetloft::fuzz {

struct DecodedStack {
  SectionStack stack;
  ReconstructOptions options;
  [[nodiscard]] bool is_labelled() const { return !options.correspondence.labels.empty(); }
};

/// One to four sections of up to seven contours, vertices on a grid of 16 × 16 in steps of one
/// byte each. A contour's first byte is its number of vertices, or names a rectangle, of which
/// two bytes tell opposite corners: else few random contours would be simple. With a frame around
/// each section that has contours, which are holes then.
inline DecodedStack decode_stack(Bytes& bytes) {
  DecodedStack decoded;
  const std::uint8_t flags = bytes.byte();
  decoded.options.execution.threads = 1;
  if ((flags & 1) != 0) decoded.options.correspondence.criterion = Criterion::reverse;
  if ((flags & 2) != 0) decoded.options.ends = Ends::half;
  if ((flags & 4) != 0) decoded.options.correspondence.tau = 0.25;
  if ((flags & 24) == 8) decoded.options.between = 0;
  if ((flags & 24) == 16) decoded.options.between = 3;
  const auto vertex = [&] {
    const std::uint8_t b = bytes.byte();
    return Point2{static_cast<double>(b & 15), static_cast<double>(b >> 4)};
  };
  double z = 0;
  for (std::size_t sections = 1 + (flags >> 6); sections > 0; --sections) {
    Section section;
    section.z = z;
    const std::uint8_t shape = bytes.byte();
    z += static_cast<double>(1 + (shape >> 4));
    for (std::size_t contours = shape & 7; contours > 0; --contours) {
      const std::size_t form = bytes.below(16);
      Contour contour;
      if (form < 8) {
        const Point2 a = vertex();
        const Point2 b = vertex();
        contour.vertices = {a, {b.x, a.y}, b, {a.x, b.y}};
      } else {
        for (std::size_t k = form - 5; k > 0; --k) contour.vertices.push_back(vertex());
      }
      section.contours.push_back(contour);
    }
    if ((flags & 32) != 0 && !section.contours.empty()) {
      section.contours.push_back({{{-1, -1}, {17, -1}, {17, 17}, {-1, 17}}});
    }
    decoded.stack.sections.push_back(section);
  }
  if ((flags & 24) == 24) {
    while (!bytes.empty()) {
      const std::uint8_t b = bytes.byte();
      decoded.options.correspondence.labels.push_back(
          {SectionId(b & 3), ContourId((b >> 2) & 3), static_cast<std::uint32_t>(b >> 6)});
    }
  }
  return decoded;
}

}  // namespace tetloft::fuzz
