#include "io/cnt_slips.hpp"

#include <cmath>
#include <utility>

#include <tetloft/repair.hpp>

namespace tetloft::internal::io {

void tell_vertex_counts(const CntContents& contents, WarningList& warnings) {
  for (const SectionId s : contents.stack.sections.ids()) {
    std::size_t vertices = 0;
    for (const Contour& contour : contents.stack.sections[s].contours.raw()) {
      vertices += contour.vertices.size();
    }
    if (contents.announced[s] == static_cast<double>(vertices)) continue;
    Warning warning{"the section announces " + count_text(contents.announced[s]) +
                        " vertices and has " + std::to_string(vertices),
                    {}};
    warning.where.section = contents.first + s.index();
    warning.where.line = contents.header_lines[s];
    warnings.add(std::move(warning));
  }
}

void tell_section_count(const CntParser::Header& header, std::size_t found, WarningList& warnings) {
  if (header.sections == static_cast<double>(found)) return;
  warnings.add("the header announces " + count_text(header.sections) + " sections, the file has " +
                   std::to_string(found),
               header.line);
}

// One contour after the other: the warnings of a whole file may be larger than the file.
void mend_contours(CntContents& contents, WarningList& warnings) {
  for (const SectionId s : contents.stack.sections.ids()) {
    Section& section = contents.stack.sections[s];
    for (const ContourId c : section.contours.ids()) {
      Contour& contour = section.contours[c];
      if (contour.vertices.size() < 2) continue;
      SectionStack alone;
      alone.sections.push_back({section.z, {}});
      auto& contours = alone.sections[SectionId(0)].contours;
      contours.push_back(std::move(contour));
      for (Warning& warning : mend(alone)) {
        warning.where.section = contents.first + s.index();
        warning.where.contour = c.index();
        warning.where = with_line(std::move(warning.where), contents);
        warnings.add(std::move(warning));
      }
      contour = std::move(contours[ContourId(0)]);
    }
  }
}

Place with_line(Place where, const CntContents& contents) {
  if (where.line || !where.section || *where.section < contents.first) return where;
  const std::size_t index = *where.section - contents.first;
  if (index >= contents.lines.size()) return where;
  where.line = contents.header_lines[SectionId(index)];
  const auto& lines = contents.lines[SectionId(index)];
  if (where.contour && *where.contour < lines.size()) {
    where.line = lines[ContourId(*where.contour)];
  }
  return where;
}

Error cnt_refusal(Error error, const CntContents& contents, const std::string& name) {
  const std::optional<std::size_t> index = error.where.section;
  error.where.file = name;
  if (!index) return error;
  error.where.section = contents.first + *index;
  error.where = with_line(std::move(error.where), contents);
  if (!error.where.contour) return error;
  const auto& contours = contents.stack.sections[SectionId(*index)].contours;
  const auto times = conspicuous_closing(contours[ContourId(*error.where.contour)]);
  if (!times) return error;
  error.message += "; the edge that closes the contour is " + count_text(std::floor(*times)) +
                   " times as long as its longest other: if it is an open line, close it along "
                   "the frame (--close-on-frame)";
  return error;
}

}  // namespace tetloft::internal::io
