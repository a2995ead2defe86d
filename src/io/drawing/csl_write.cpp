#include "io/drawing/csl_write.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <tetloft/nesting.hpp>

#include "io/drawing/written_stack.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// Of unit length; the axis itself where it is that of the planes' own coordinates.
Point3 normal_of(const Frame& frame) {
  const Point3& a = frame.axes[0];
  const Point3& b = frame.axes[1];
  const Point3 n{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  return {n.x / length, n.y / length, n.z / length};
}

void append_section(Pieces& pieces, std::size_t id, const Section& section, const Frame& frame) {
  std::string& text = pieces.text();
  std::size_t vertices = 0;
  for (const Contour& contour : section.contours) vertices += contour.vertices.size();
  const Point2& first = section.contours[ContourId(0)].vertices.front();
  const Point3 p = place(frame, {first.x, first.y, section.z});
  const Point3 normal = normal_of(frame);
  text += '\n';
  append_number(text, id);
  text += ' ';
  append_number(text, vertices);
  text += ' ';
  append_number(text, section.contours.size());
  text += ' ';
  append_point(text, normal);
  text += ' ';
  append_number(text, -(normal.x * p.x + normal.y * p.y + normal.z * p.z));
  text += "\n\n";
  for (const Contour& contour : section.contours) {
    for (const Point2& v : contour.vertices) {
      append_point(text, place(frame, {v.x, v.y, section.z}));
      text += '\n';
      pieces.next();
    }
  }
  text += '\n';
  const Nesting nesting = nest(section);
  std::size_t vertex = 0;
  for (const ContourId c : section.contours.ids()) {
    const std::size_t n = section.contours[c].vertices.size();
    append_number(text, n);
    if (nesting.depth[c] % 2 == 1) {
      text += 'h';
      append_number(text, nesting.parent[c].index());
    }
    text += " 1";
    for (std::size_t i = 0; i < n; ++i) {
      text += ' ';
      append_number(text, vertex++);
      pieces.next();
    }
    text += '\n';
  }
}

}  // namespace

Written write_csl(Sink& sink, const SectionStack& stack, const Target& target) {
  const Result<std::vector<Warning>> fit = check_written(stack, target);
  if (!fit) return fit.error();
  std::size_t planes = 0;
  for (const Section& section : stack.sections) planes += section.contours.empty() ? 0U : 1U;
  Pieces pieces(sink);
  // Labels are counted with 0, what is outside.
  pieces.text() = "CSLC\n";
  append_number(pieces.text(), planes);
  pieces.text() += " 2\n";
  std::size_t id = 0;
  for (const Section& section : stack.sections) {
    if (!section.contours.empty()) append_section(pieces, ++id, section, stack.frame);
  }
  pieces.finish();
  return *fit;
}

}  // namespace tetloft::internal::io
