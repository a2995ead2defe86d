// NUAGES .cnt, written with digits that read back exactly.
#include <string>

#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/numbers.hpp"
#include "io/pending_file.hpp"

namespace tetloft {

namespace {

std::string section_text(const Section& section) {
  std::size_t vertices = 0;
  for (const Contour& contour : section.contours) vertices += contour.vertices.size();
  std::string text = "v ";
  io::append_number(text, vertices);
  text += " z ";
  io::append_number(text, section.z);
  text += '\n';
  for (const Contour& contour : section.contours) {
    text += "{\n";
    for (const Point2& p : contour.vertices) {
      io::append_number(text, p.x);
      text += ' ';
      io::append_number(text, p.y);
      text += '\n';
    }
    text += "}\n";
  }
  return text;
}

}  // namespace

Result<void> write_cnt(const std::string& path, const SectionStack& stack) {
  return guard_internal([&]() -> Result<void> {
    io::PendingFile file(path);
    file.append("S " + std::to_string(stack.sections.size()) + '\n');
    for (const Section& section : stack.sections) file.append(section_text(section));
    return file.commit();
  });
}

}  // namespace tetloft
