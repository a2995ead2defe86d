// NUAGES .cnt, written with digits that read back exactly.
#include <string>

#include "io/cnt_read.hpp"
#include "io/cnt_sections.hpp"
#include "io/cursor.hpp"
#include "io/drawing/written_stack.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// "S" and what may follow it: a number, space or a comment. Words that begin with s are not this.
bool is_cnt(std::string_view bytes) {
  TextCursor cursor(bytes);
  for (cursor.skip_white(); cursor.peek() == '#'; cursor.skip_white()) cursor.skip_line();
  if (cursor.peek() != 'S' && cursor.peek() != 's') return false;
  cursor.advance();
  const char next = cursor.peek();
  return is_white(next) || next == '#' || (next >= '0' && next <= '9');
}

std::string section_text(const Section& section) {
  std::size_t vertices = 0;
  for (const Contour& contour : section.contours) vertices += contour.vertices.size();
  std::string text = "v ";
  append_number(text, vertices);
  text += " z ";
  append_number(text, section.z);
  text += '\n';
  for (const Contour& contour : section.contours) {
    text += "{\n";
    for (const Point2& p : contour.vertices) {
      append_number(text, p.x);
      text += ' ';
      append_number(text, p.y);
      text += '\n';
    }
    text += "}\n";
  }
  return text;
}

Written write_sections(Sink& sink, const SectionStack& stack, const Target& target) {
  sink.append("S " + std::to_string(stack.sections.size()) + '\n');
  for (const Section& section : stack.sections) sink.append(section_text(section));
  return warnings_of_turned(stack, target, ".cnt");
}

}  // namespace

extern constinit const Format cnt_format{.name = "cnt",
                                         .summary = "NUAGES contours",
                                         .extensions = {".cnt"},
                                         .recognise = is_cnt,
                                         .takes_text = true,
                                         .read_stack = read_cnt_source,
                                         .open_sections = open_cnt_sections,
                                         .write_stack = write_sections};

}  // namespace tetloft::internal::io
