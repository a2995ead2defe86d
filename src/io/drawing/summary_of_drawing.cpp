// A drawing as it stands in the file, counted.
#include <algorithm>
#include <map>
#include <set>

#include "io/drawing/planes.hpp"
#include "io/drawing/stack_of_drawing.hpp"

namespace tetloft::internal::io {

namespace {

// Of lines that are in parallel planes; 0 where they are not.
std::size_t plane_count(const std::vector<PointsOfLine>& lines, const Drawing& drawing) {
  if (lines.empty()) return 0;
  const PlanesOfLines planes = planes_of(lines, plane_tolerance(drawing, {}));
  return off_plane(planes) ? 0 : planes.height.size();
}

const char* type_of(const DrawnLine& line) {
  switch (line.kind) {
    case LineKind::closed: return "closed";
    case LineKind::open: return "open";
    case LineKind::points: break;
  }
  return "points";
}

// Shorter ones are left out of any stack.
bool bounds_area(const DrawnLine& line) {
  return line.kind == LineKind::closed && !line.left_out && line.points.size() >= 3;
}

StructureSummary summary_of_structure(const DrawnStructure& structure, const Drawing& drawing) {
  StructureSummary summary;
  summary.number = structure.number;
  summary.name = structure.name;
  std::map<std::string, std::size_t> types;
  std::vector<PointsOfLine> closed;
  for (const DrawnLine& line : structure.lines) {
    ++types[line.type.empty() ? type_of(line) : line.type];
    ++summary.contours;
    summary.points += line.points.size();
    if (bounds_area(line)) closed.push_back(&line.points);
  }
  summary.types = {types.begin(), types.end()};
  summary.closed = closed.size();
  summary.planes = plane_count(closed, drawing);
  return summary;
}

LinesSummary summary_of_lines(const Drawing& drawing) {
  LinesSummary summary;
  std::vector<PointsOfLine> lines;
  std::set<std::int64_t> labels;
  for (const DrawnStructure& structure : drawing.structures) {
    for (const DrawnLine& line : structure.lines) {
      ++summary.contours;
      summary.points += line.points.size();
      if (line.kind == LineKind::open) ++summary.open;
      if (line.kind == LineKind::closed) ++summary.closed;
      if (drawing.labelled) labels.insert(line.label);
      if (line.left_out || line.points.empty()) continue;
      if (line.kind != LineKind::points) lines.push_back(&line.points);
    }
  }
  summary.planes = drawing.planes != 0 ? drawing.planes : plane_count(lines, drawing);
  summary.labels = {labels.begin(), labels.end()};
  return summary;
}

}  // namespace

FileSummary summary_of_drawing(Drawing drawing) {
  FileSummary summary;
  summary.lines = summary_of_lines(drawing);
  if (drawing.apart || drawing.structures.size() > 1) {
    summary.structures.reserve(drawing.structures.size());
    for (const DrawnStructure& structure : drawing.structures) {
      summary.structures.push_back(summary_of_structure(structure, drawing));
    }
  }
  summary.unit = std::move(drawing.unit);
  summary.warnings = std::move(drawing.warnings);
  return summary;
}

}  // namespace tetloft::internal::io
