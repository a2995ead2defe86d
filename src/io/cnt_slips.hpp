// What is told of a .cnt and mended in it, whether all of it is in memory or some sections are.
#pragma once

#include <cstddef>
#include <string>

#include <tetloft/result.hpp>

#include "io/cnt_contents.hpp"
#include "io/cnt_parser.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

/// Tells of each section that announces another number of vertices than it has.
void tell_vertex_counts(const CntContents& contents, WarningList& warnings);
/// The same of the header, where the file has `found` sections.
void tell_section_count(const CntParser::Header& header, std::size_t found, WarningList& warnings);

/// mend() of each contour, which is told.
void mend_contours(CntContents& contents, WarningList& warnings);

/// `where` with the line of the contour that it names, or else of its section, if that is one of
/// these and no line is known.
[[nodiscard]] Place with_line(Place where, const CntContents& contents);

/// What validate() refuses of these sections (its first is contents.first), with file and line;
/// where the contour may be an open line, that is why.
[[nodiscard]] Error cnt_refusal(Error error, const CntContents& contents, const std::string& name);

}  // namespace tetloft::internal::io
