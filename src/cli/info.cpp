// tetloft info: what a file holds, and the stack that is made of it.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/file_summary.hpp"
#include "cli/plan_info.hpp"
#include "cli/progress.hpp"
#include "cli/read_options.hpp"
#include "io/files.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage info_usage() {
  std::vector<Option> options = read_option_list();
  for (const Option& option : {kJsonOption, kQuietOption, kHelpOption}) options.push_back(option);
  return {
      "info",
      "What a file holds: structures, labels, voxels; sections, contours, nesting, areas.",
      {input_word("IN", Contents::stack)},
      std::move(options),
      "Depth counts the contours around a contour: even for outer contours, odd for holes. "
      "A region is an outer contour with its immediate holes; areas are those of regions. IN may "
      "also be a plan (tetloft plan), or a piece of a planned stack: all of it is read and "
      "checked; or an index over pieces (.pvtu): what it lists, and whether all are there."};
}

struct SectionInfo {
  Nesting nesting;
  std::vector<double> region_area;  // by region
  double area = 0;
  std::size_t vertices = 0;
  std::uint32_t depth = 0;  // the largest; 0 without contours
};

struct Extents {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  bool known = false;  // false without vertices

  void include(const std::array<double, 3>& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = known ? std::min(low[i], p[i]) : p[i];
      high[i] = known ? std::max(high[i], p[i]) : p[i];
    }
    known = true;
  }
};

SectionInfo section_info(const Section& section) {
  SectionInfo info;
  info.nesting = nest(section);
  for (std::size_t r = 0; r < info.nesting.outer.size(); ++r) {
    info.region_area.push_back(area(outline(section, info.nesting, RegionId(r))));
    info.area += info.region_area.back();
  }
  for (const Contour& contour : section.contours) info.vertices += contour.vertices.size();
  for (const std::uint32_t depth : info.nesting.depth) info.depth = std::max(info.depth, depth);
  return info;
}

struct StackInfo {
  std::vector<SectionInfo> sections;
  Extents extents;
  std::size_t regions = 0;
  std::uint32_t depth = 0;
};

StackInfo stack_info(const SectionStack& stack) {
  StackInfo info;
  for (const Section& section : stack.sections) {
    info.sections.push_back(section_info(section));
    info.regions += info.sections.back().nesting.outer.size();
    info.depth = std::max(info.depth, info.sections.back().depth);
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) info.extents.include({p.x, p.y, section.z});
    }
  }
  return info;
}

void write_section(JsonWriter& json, const Section& section, const SectionInfo& info) {
  json.begin_object();
  json.member("z", section.z);
  json.member("vertices", info.vertices);
  json.member("regions", info.nesting.outer.size());
  json.member("depth", info.depth);
  json.member("area", info.area);
  json.member("region_areas", info.region_area);
  json.key("contours");
  json.begin_array();
  for (std::size_t c = 0; c < section.contours.size(); ++c) {
    const ContourId id(c);
    const Contour& contour = section.contours[id];
    json.begin_object();
    json.member("vertices", contour.vertices.size());
    json.member("depth", info.nesting.depth[id]);
    json.key("parent");
    const ContourId parent = info.nesting.parent[id];
    if (parent.valid()) {
      json.value(parent.index());
    } else {
      json.value(std::numeric_limits<double>::quiet_NaN());  // null
    }
    json.member("region", info.nesting.region[id].index());
    json.member("signed_area", twice_area(contour) / 2);
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

void write_stack(JsonWriter& json, const SectionStack& stack, const StackInfo& info) {
  json.member("slices", stack.sections.size());
  json.member("regions", info.regions);
  json.member("vertices", stack.vertex_count());
  json.member("depth", info.depth);
  if (info.extents.known) {
    json.key("extents");
    json.begin_object();
    constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
      json.key(kAxes[i]);
      json.begin_array();
      json.value(info.extents.low[i]);
      json.value(info.extents.high[i]);
      json.end_array();
    }
    json.end_object();
  }
  json.key("sections");
  json.begin_array();
  for (std::size_t s = 0; s < info.sections.size(); ++s) {
    write_section(json, stack.sections[SectionId(s)], info.sections[s]);
  }
  json.end_array();
}

std::string to_json(const FileSummary& file, const SectionStack* stack, const Console& console) {
  JsonWriter json;
  json.begin_object();
  write_summary(json, file, stack);
  if (stack != nullptr) write_stack(json, *stack, stack_info(*stack));
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const SectionStack& stack, const StackInfo& info) {
  std::string text = counted(stack.sections.size(), "section") + ", " +
                     counted(stack.contour_count(), "contour") + " bounding " +
                     counted(info.regions, "region") + ", nested " + std::to_string(info.depth) +
                     " deep, " + std::to_string(stack.vertex_count()) + " vertices\n";
  if (info.extents.known) {
    text += "extents";
    constexpr std::array<const char*, 3> kAxes{" x ", ", y ", ", z "};
    for (std::size_t i = 0; i < 3; ++i) {
      text += kAxes[i] + readable(info.extents.low[i]) + " to " + readable(info.extents.high[i]);
    }
    text += '\n';
  }
  text += "section            z  contours  regions  depth  vertices          area\n";
  for (std::size_t s = 0; s < info.sections.size(); ++s) {
    const SectionInfo& section = info.sections[s];
    const Section& input = stack.sections[SectionId(s)];
    char line[160];
    std::snprintf(line, sizeof line, "%7zu %12s %9zu %8zu %6u %9zu %13s\n", s,
                  readable(input.z).c_str(), input.contours.size(), section.nesting.outer.size(),
                  static_cast<unsigned>(section.depth), section.vertices,
                  readable(section.area).c_str());
    text += line;
  }
  return text;
}

// A file is looked at twice, a stream once.
struct File {
  std::string path;
  std::optional<std::string> bytes;  // of a stream
};

Result<File> open_file(const Arguments& arguments) {
  File file{input_path(arguments.operand(0)), {}};
  std::error_code code;
  if (std::filesystem::is_regular_file(file.path, code)) return file;
  Result<std::string> bytes = io::read_file(file.path);
  if (!bytes) return bytes.error();
  file.bytes = *std::move(bytes);
  return file;
}

// The stack that would be made of the file, where it is clear of what; a warning says why there is
// none.
Result<std::optional<SectionStack>> stack_of(const File& file, const FileSummary& summary,
                                             const ReadOptions& options, Console& console) {
  const bool chosen = !options.structure.empty() || options.iso.has_value();
  if (!chosen && (summary.volume || summary.structures.size() > 1)) {
    return std::optional<SectionStack>();
  }
  Result<ReadStack> read =
      file.bytes ? parse_stack(*file.bytes, file.path, options) : read_stack(file.path, options);
  if (!read) {
    if (read.error().code != ErrorCode::invalid_input) return read.error();
    console.warn(
        {"no solid can be made of this as it stands: " + read.error().message, read.error().where});
    return std::optional<SectionStack>();
  }
  for (const Warning& warning : read->warnings) {
    // What the file itself is odd in has been told.
    const auto same = [&](const Warning& told) {
      return told.message == warning.message && told.where.line == warning.where.line &&
             told.where.section == warning.where.section;
    };
    const bool told = std::any_of(summary.warnings.begin(), summary.warnings.end(), same);
    if (!told) console.warn_of(file.path, {warning});
  }
  return std::optional(std::move(read->stack));
}

Result<int> delivered(const std::string& text, Console& console) {
  if (text.empty()) return 0;
  const Result<void> told = console.deliver(text);
  if (!told) return told.error();
  return 0;
}

Result<int> run_info(const Arguments& arguments, Console& console) {
  auto options = read_options(arguments);
  if (!options) return options.error();
  if (options->structure == kAllStructures) options->structure.clear();  // all are listed anyway
  const Result<File> file = open_file(arguments);
  if (!file) return file.error();
  if (!file->bytes) {
    const Result<std::optional<std::string>> part = plan_or_piece_info(file->path, console);
    if (!part) return part.error();
    if (*part)
      return delivered(console.quiet() && !console.json() ? std::string() : **part, console);
  }
  Progress progress(!console.quiet());
  options->execution.progress = progress.callback();
  const Result<FileSummary> summary = file->bytes
                                          ? inspect_bytes(*file->bytes, file->path, *options)
                                          : inspect(file->path, *options);
  if (!summary) return summary.error();
  console.warn_of(file->path, summary->warnings);
  const auto stack = stack_of(*file, *summary, *options, console);
  if (!stack) return stack.error();
  const SectionStack* const made = stack->has_value() ? &**stack : nullptr;
  std::string told;
  if (console.json()) {
    told = to_json(*summary, made, console);
  } else if (!console.quiet()) {
    told = describe_summary(*summary) + (made == nullptr ? "" : to_text(*made, stack_info(*made)));
  }
  return delivered(told, console);
}

}  // namespace

Command info_command() { return {info_usage(), run_info}; }

}  // namespace tetloft::cli
