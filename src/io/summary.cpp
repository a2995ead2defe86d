// Telling what a file holds: of a drawing, a volume, or a stack.
#include "io/summary.hpp"

#include <algorithm>
#include <memory>

#include "io/drawing/stack_of_drawing.hpp"
#include "io/volume/stack_of_volume.hpp"

namespace tetloft::internal::io {

namespace {

FileSummary summary_of_stack(ReadStack read) {
  LinesSummary lines;
  lines.planes = read.stack.sections.size();
  lines.contours = read.stack.contour_count();
  lines.closed = lines.contours;
  lines.points = read.stack.vertex_count();
  FileSummary summary;
  summary.lines = std::move(lines);
  summary.unit = std::move(read.stack.about.unit);
  summary.warnings = std::move(read.warnings);
  return summary;
}

}  // namespace

Result<FileSummary> summary_of(const Format& format, const Source& source,
                               const ReadOptions& options) {
  if (format.open_volume != nullptr) {
    Result<std::unique_ptr<Volume>> volume = format.open_volume(source, options);
    if (!volume) return volume.error();
    return summary_of_volume(**volume, options);
  }
  if (format.read_drawing != nullptr) {
    Result<Drawing> drawing = format.read_drawing(source, options);
    if (!drawing) return drawing.error();
    return summary_of_drawing(*std::move(drawing));
  }
  Result<StackOfFile> file = format.read_stack(source, options);
  if (!file) return file.error();
  return summary_of_stack(std::move(file->read));
}

}  // namespace tetloft::internal::io
