// Summaries of files as JSON and as lines.
#include "cli/file_summary.hpp"

#include <array>
#include <cstdio>

#include "cli/console.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

void write_structure(JsonWriter& json, const StructureSummary& structure) {
  json.begin_object();
  json.member("number", structure.number);
  json.member("name", structure.name);
  json.key("types");
  json.begin_object();
  for (const auto& [type, count] : structure.types) json.member(type, count);
  json.end_object();
  json.member("contours", structure.contours);
  json.member("points", structure.points);
  json.member("planes", structure.planes);
  json.end_object();
}

void write_volume(JsonWriter& json, const VolumeSummary& volume) {
  json.member("size", volume.size);
  json.member("spacing", volume.spacing);
  json.member("matrix", volume.matrix);
  json.member("space", volume.space);
  json.member("type", volume.type);
  json.member("range", std::array{volume.least, volume.largest});
  json.key("labels");
  json.begin_array();
  for (const LabelSummary& label : volume.labels) {
    json.begin_object();
    json.member("value", label.value);
    json.member("voxels", label.voxels);
    json.member("name", label.name);
    json.end_object();
  }
  json.end_array();
}

std::string described(const VolumeSummary& volume) {
  std::string text;
  for (const std::size_t n : volume.size) {
    text += (text.empty() ? "" : " x ") + std::to_string(n);
  }
  text += " voxels of type " + printable(volume.type) + ", " + readable(volume.spacing[0]) + " x " +
          readable(volume.spacing[1]) + " x " + readable(volume.spacing[2]) +
          (volume.unit.empty() ? "" : ' ' + printable(volume.unit)) + " apart, in " +
          printable(volume.space) + ", values " + readable(volume.least) + " to " +
          readable(volume.largest) + '\n';
  if (volume.labels.empty()) return text;
  text += "     label       voxels  name\n";
  for (const LabelSummary& label : volume.labels) {
    char line[64];
    std::snprintf(line, sizeof line, "%10s %12zu  ", readable(label.value).c_str(), label.voxels);
    text += line + printable(label.name) + '\n';
  }
  return text;
}

std::string described(const std::vector<StructureSummary>& structures) {
  std::string text = "    number  contours    points  planes  name\n";
  for (const StructureSummary& structure : structures) {
    char line[96];
    std::snprintf(line, sizeof line, "%10lld %9zu %9zu %7zu  ",
                  static_cast<long long>(structure.number), structure.contours, structure.points,
                  structure.planes);
    text += line + printable(structure.name);
    for (const auto& [type, count] : structure.types) {
      text += (&type == &structure.types.front().first ? " (" : ", ") + std::to_string(count) +
              ' ' + printable(type);
    }
    text += structure.types.empty() ? "\n" : ")\n";
  }
  return text;
}

std::string described(const LinesSummary& lines) {
  std::string text = counted(lines.contours, "contour") + " in " + counted(lines.planes, "plane") +
                     ", " + counted(lines.points, "point");
  if (lines.open > 0) text += ", " + std::to_string(lines.open) + " of the contours open";
  if (!lines.labels.empty()) {
    text += lines.labels.size() == 1 ? ", label" : ", labels";
    for (const std::int64_t label : lines.labels) text += ' ' + std::to_string(label);
  }
  return text + '\n';
}

}  // namespace

void write_summary(JsonWriter& json, const FileSummary& file, const SectionStack* stack) {
  json.member("format", file.format);
  if (!file.unit.empty()) json.member("unit", file.unit);
  if (!file.structures.empty()) {
    json.key("structures");
    json.begin_array();
    for (const StructureSummary& structure : file.structures) write_structure(json, structure);
    json.end_array();
  }
  if (file.volume) write_volume(json, *file.volume);
  if (file.lines) {
    json.member("planes", file.lines->planes);
    json.member("contours", file.lines->contours);
    json.member("points", file.lines->points);
    json.member("open", file.lines->open);
    json.member("closed", file.lines->closed);
    if (!file.lines->labels.empty()) json.member("labels", file.lines->labels);
  } else if (stack != nullptr) {
    json.member("contours", stack->contour_count());
  }
}

std::string describe_summary(const FileSummary& file) {
  std::string text = "format " + file.format;
  if (!file.unit.empty()) text += ", in " + printable(file.unit);
  text += '\n';
  if (file.volume) text += described(*file.volume);
  if (!file.structures.empty()) text += described(file.structures);
  if (file.lines) text += described(*file.lines);
  return text;
}

}  // namespace tetloft::cli
