// tetloft skeleton: the Voronoi skeletons of all sections, as lines, and the contours of
// neighbouring sections that are geometrically well positioned by them.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "cli/signals.hpp"
#include "cli/stack_input.hpp"
#include "core/text.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage skeleton_usage() {
  Usage usage{
      "skeleton",
      "Internal and external Voronoi skeletons of all sections, and which contours they relate.",
      {input_word("IN", Contents::stack)},
      {{"--output", output_word("OUT", Contents::lines),
        "the skeletons, lines: " + described_outputs(Contents::lines) + "; required", "-o"},
       {"--kind",
        "NAME",
        "internal, external, or both (default)",
        {},
        {"both", "internal", "external"}}},
      "Lines are Voronoi edges, dual to edges of the section's conforming Delaunay triangulation "
      "inside or outside its region. Cell data: section; kind, 0 internal and 1 external; "
      "contour_a "
      "and contour_b, the contours of the dual edge's ends. Lines are clipped to the stack's box, "
      "enlarged by a tenth of its larger side. Also counts the pairs of contours of neighbouring "
      "sections that are geometrically well positioned (Definition 1 of Nonato et al. 2000): the "
      "internal skeleton of one crosses the internal or external skeleton of the other in "
      "projection. --json lists them as well_positioned, an array of {slab, below, above, proper}; "
      "proper is false where skeletons only touch, which decides nothing."};
  for (const Option& option : preparation_options()) usage.options.push_back(option);
  for (const Option& option :
       {kAsciiOption, kCompressOption, kJsonOption, kQuietOption, kHelpOption}) {
    usage.options.push_back(option);
  }
  return usage;
}

struct Box {
  Point2 low, high;
};

// The box of all vertices, enlarged.
Box box_of(const SectionStack& stack) {
  std::optional<Box> box;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) {
        if (!box) box = Box{p, p};
        box->low = {std::min(box->low.x, p.x), std::min(box->low.y, p.y)};
        box->high = {std::max(box->high.x, p.x), std::max(box->high.y, p.y)};
      }
    }
  }
  if (!box) return {};
  const double margin = 0.1 * std::max(box->high.x - box->low.x, box->high.y - box->low.y);
  return {{box->low.x - margin, box->low.y - margin}, {box->high.x + margin, box->high.y + margin}};
}

// The part of a segment or ray within the box (Liang and Barsky 1984).
std::optional<std::array<Point2, 2>> clipped(const SkeletonEdge& edge, const Box& box) {
  const Point2& p = edge.from;
  const Point2 d = edge.ray ? edge.to : Point2{edge.to.x - p.x, edge.to.y - p.y};
  double first = 0;
  double last = edge.ray ? std::numeric_limits<double>::infinity() : 1;
  for (const auto& [direction, from, low, high] :
       {std::array{d.x, p.x, box.low.x, box.high.x}, std::array{d.y, p.y, box.low.y, box.high.y}}) {
    if (direction == 0) {
      if (from < low || from > high) return std::nullopt;
      continue;
    }
    const double a = (low - from) / direction;
    const double b = (high - from) / direction;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first < last) || !std::isfinite(last)) return std::nullopt;
  const auto at = [&](double t) { return Point2{p.x + t * d.x, p.y + t * d.y}; };
  return std::array{first == 0 ? p : at(first), !edge.ray && last == 1 ? edge.to : at(last)};
}

struct Counts {
  std::size_t internal = 0;
  std::size_t external = 0;
  std::size_t outside = 0;  // of both: wholly outside the box
};

void add_skeleton(const ConformingSection& section, std::size_t number, EdgeKind kind,
                  const Box& box, LineSet& lines, Counts& counts) {
  for (const SkeletonEdge& edge : voronoi_skeleton(section, kind)) {
    ++(kind == EdgeKind::internal ? counts.internal : counts.external);
    const auto part = clipped(edge, box);
    if (!part) {
      ++counts.outside;
      continue;
    }
    lines.lines.push_back({Point3{(*part)[0].x, (*part)[0].y, section.z},
                           Point3{(*part)[1].x, (*part)[1].y, section.z}});
    const std::array<std::size_t, 4> values{number, kind == EdgeKind::internal ? 0U : 1U,
                                            edge.contour_a.index(), edge.contour_b.index()};
    for (std::size_t k = 0; k < values.size(); ++k) {
      lines.data[k].value.push_back(static_cast<std::int32_t>(values[k]));
    }
  }
}

Result<std::vector<ConformingSection>> conform_all(const SectionStack& stack,
                                                   const std::string& file) {
  std::vector<ConformingSection> sections;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    Result<ConformingSection> section = conform(stack.sections[SectionId(s)], SectionId(s));
    if (!section) {
      Error error = section.error();
      error.where.file = file;
      return error;
    }
    sections.push_back(std::move(section).value());
  }
  return sections;
}

// By slab.
std::vector<std::vector<WellPositioned>> all_well_positioned(
    const std::vector<ConformingSection>& sections) {
  std::vector<std::vector<WellPositioned>> slabs;
  for (std::size_t k = 0; k + 1 < sections.size(); ++k) {
    slabs.push_back(well_positioned(sections[k], sections[k + 1]));
  }
  return slabs;
}

void write_well_positioned(JsonWriter& json,
                           const std::vector<std::vector<WellPositioned>>& slabs) {
  json.key("well_positioned");
  json.begin_array();
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    for (const WellPositioned& pair : slabs[k]) {
      json.begin_object();
      json.member("slab", k);
      json.member("below", pair.below.index());
      json.member("above", pair.above.index());
      json.member("proper", pair.proper);
      json.end_object();
    }
  }
  json.end_array();
}

std::string describe_well_positioned(const std::vector<std::vector<WellPositioned>>& slabs) {
  std::size_t pairs = 0;
  std::size_t touching = 0;
  for (const std::vector<WellPositioned>& slab : slabs) {
    pairs += slab.size();
    for (const WellPositioned& pair : slab) touching += pair.proper ? 0U : 1U;
  }
  return counted(pairs, "well positioned pair") + " of contours (" + std::to_string(touching) +
         " whose skeletons only touch)\n";
}

Result<int> run_skeleton(const Arguments& arguments, Console& console) {
  const auto output = arguments.text("--output");
  if (!output)
    return usage_error("missing option --output (-o) " + output_word("OUT", Contents::lines));
  const auto kind = arguments.choice("--kind");
  if (!kind) return kind.error();
  const Result<Encoding> encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  const auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  Result<void> checked = check_output("--output (-o)", *output, output_extensions(Contents::lines),
                                      {arguments.operand(0)});
  if (!checked) return checked.error();
  const auto input = read_stack_input(arguments.operand(0), *prepared, console);
  if (!input) return input.error();

  const Box box = box_of(input->stack());
  LineSet lines{{}, {{"section", {}}, {"kind", {}}, {"contour_a", {}}, {"contour_b", {}}}};
  Counts counts;
  const auto sections = conform_all(input->stack(), arguments.operand(0));
  if (!sections) return sections.error();
  for (std::size_t s = 0; s < sections->size(); ++s) {
    for (const EdgeKind each : {EdgeKind::internal, EdgeKind::external}) {
      const std::size_t number = each == EdgeKind::internal ? 1 : 2;
      if (kind->value_or(0) != 0 && **kind != number) continue;
      add_skeleton((*sections)[s], s, each, box, lines, counts);
    }
  }
  StagedFiles files;
  Result<void> staged = take_staged(
      io::stage_lines(*output, lines, {*encoding, {}}, temporary_watcher()), files, console);
  if (!staged) return staged.error();
  std::string told;
  const auto positions = all_well_positioned(*sections);
  if (console.json()) {
    JsonWriter json;
    json.begin_object();
    json.member("slices", input->stack().sections.size());
    json.member("internal", counts.internal);
    json.member("external", counts.external);
    json.member("outside", counts.outside);
    write_well_positioned(json, positions);
    write_preparation(json, *input);
    write_warnings(json, console.warnings());
    json.end_object();
    told = json.text();
  } else if (!console.quiet()) {
    told = describe_preparation(*input) + counted(input->stack().sections.size(), "section") +
           ", " + counted(counts.internal, "internal skeleton edge") + ", " +
           counted(counts.external, "external one") + " (" + std::to_string(counts.outside) +
           " outside the box)\n" + describe_well_positioned(positions) +
           "written: " + printable(*output) + '\n';
  }
  const Result<void> done = deliver_with(files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command skeleton_command() { return {skeleton_usage(), run_skeleton}; }

}  // namespace tetloft::cli
