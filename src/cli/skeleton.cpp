// tetloft skeleton: the Voronoi skeletons of all sections, as lines.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "cli/stack_input.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

namespace {

Usage usage() {
  Usage usage{
      "skeleton",
      "Internal and external Voronoi skeletons of all sections.",
      {"IN.cnt"},
      {{"--output", "OUT.vtp", "the skeletons, a VTK XML file of lines; required", "-o"},
       {"--kind", "NAME", "internal, external, or both (default)"}},
      "Lines are Voronoi edges, dual to edges of the section's conforming Delaunay triangulation "
      "inside or outside its region. Cell data: section; kind, 0 internal and 1 external; "
      "contour_a "
      "and contour_b, the contours of the dual edge's ends. Lines are clipped to the stack's box, "
      "enlarged by a tenth of its larger side."};
  for (const Option& option : preparation_options()) usage.options.push_back(option);
  for (const Option& option :
       {Option{"--ascii", "", "write numbers as text that reads back exactly"}, kJsonOption,
        kQuietOption, kHelpOption}) {
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

Result<int> run(const Arguments& arguments, Console& console) {
  const auto output = arguments.text("--output");
  if (!output) return usage_error("missing option --output (-o) OUT.vtp");
  const std::string kind = arguments.text("--kind").value_or("both");
  if (kind != "internal" && kind != "external" && kind != "both") {
    return usage_error("option --kind: " + io::in_quotes(kind) +
                       " is neither internal nor external nor both");
  }
  const auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  Result<void> checked = check_output("--output (-o)", *output, {".vtp"}, {arguments.operand(0)});
  if (!checked) return checked.error();
  const auto input = read_stack_input(arguments.operand(0), *prepared, console);
  if (!input) return input.error();

  const Box box = box_of(input->stack);
  LineSet lines{{}, {{"section", {}}, {"kind", {}}, {"contour_a", {}}, {"contour_b", {}}}};
  Counts counts;
  for (std::size_t s = 0; s < input->stack.sections.size(); ++s) {
    const Result<ConformingSection> section =
        conform(input->stack.sections[SectionId(s)], SectionId(s));
    if (!section) {
      Error error = section.error();
      error.where.file = arguments.operand(0);
      return error;
    }
    for (const EdgeKind each : {EdgeKind::internal, EdgeKind::external}) {
      if (kind != "both" && (each == EdgeKind::internal) != (kind == "internal")) continue;
      add_skeleton(*section, s, each, box, lines, counts);
    }
  }
  Result<void> written =
      write_lines(*output, lines, arguments.has("--ascii") ? Encoding::ascii : Encoding::binary);
  if (!written) return written.error();
  if (console.json()) {
    JsonWriter json;
    json.begin_object();
    json.member("slices", input->stack.sections.size());
    json.member("internal", counts.internal);
    json.member("external", counts.external);
    json.member("outside", counts.outside);
    write_preparation(json, *input);
    write_warnings(json, console.warnings());
    json.end_object();
    console.print(json.text());
  } else if (!console.quiet()) {
    console.print(describe_preparation(*input) + counted(input->stack.sections.size(), "section") +
                  ", " + counted(counts.internal, "internal skeleton edge") + ", " +
                  counted(counts.external, "external one") + " (" + std::to_string(counts.outside) +
                  " outside the box)\nwritten: " + *output + '\n');
  }
  return 0;
}

}  // namespace

Command skeleton_command() { return {usage(), run}; }

}  // namespace tetloft::cli
