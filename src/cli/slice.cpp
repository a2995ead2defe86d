// tetloft slice: a stack of a surface mesh, cut by parallel planes.
#include <cstdint>
#include <string>
#include <utility>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/read_options.hpp"
#include "cli/signals.hpp"
#include "core/option_rules.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage slice_usage() {
  return {"slice",
          "A stack of sections from a closed surface mesh.",
          {input_word("MESH", Contents::surface)},
          {{"--planes", "N", "so many planes, evenly over the mesh's extent"},
           {"--step", "DZ", "planes so far apart, the lowest half of it above the mesh's low end"},
           {"--axis",
            "AXIS",
            "planes of constant x, y or z (default); the stack's frame says which, so that what is "
            "made of it lies where the mesh lies",
            {},
            {"x", "y", "z"}},
           {"--output", output_word("OUT", Contents::stack),
            "the stack: " + described_outputs(Contents::stack) + "; required", "-o"},
           {"--fill",
            "RULE",
            "what is inside where bodies overlap: odd (default: points inside an odd number of "
            "loops), union, or winding (that the surface winds around; its triangles turn "
            "counter-clockwise as seen from outside)",
            {},
            {"odd", "union", "winding"}},
           format_option("--format", input_word("MESH", Contents::surface), Contents::surface),
           kJsonOption,
           kQuietOption,
           kHelpOption},
          "Needs --planes or --step. A vertex exactly in a plane counts as above it. Corners of "
          "equal coordinates are one vertex; every edge must have an even number of triangles. "
          "Loops that touch are repaired, and every change is told."};
}

struct SliceRequest {
  SliceOptions options;
  std::string output;
  std::string format;
};

Result<SliceOptions> slice_options_of(const Arguments& arguments) {
  SliceOptions options;
  const auto planes = arguments.integer("--planes", 1, std::int64_t{kMostSlicePlanes});
  if (!planes) return planes.error();
  const auto step = arguments.number("--step");
  if (!step) return step.error();
  if (planes->has_value() == step->has_value()) {
    return usage_error(planes->has_value() ? "--planes and --step both place the planes; give one"
                                           : "missing option --planes N or --step DZ");
  }
  options.planes = static_cast<std::size_t>(planes->value_or(0));
  options.step = *step;
  if (options.step && !is_length(*options.step)) {
    return usage_error("option --step: " + io::in_quotes(*arguments.text("--step")) +
                       " is not above 0");
  }
  const auto axis = arguments.choice("--axis");
  if (!axis) return axis.error();
  options.axis = static_cast<int>(axis->value_or(2));
  const auto fill = arguments.choice("--fill");
  if (!fill) return fill.error();
  options.fill = static_cast<FillRule>(fill->value_or(0));
  return options;
}

Result<SliceRequest> slice_request_of(const Arguments& arguments) {
  auto options = slice_options_of(arguments);
  if (!options) return options.error();
  const auto output = arguments.text("--output");
  if (!output) {
    return usage_error("missing option --output (-o) " + output_word("OUT", Contents::stack));
  }
  const Result<void> checked = check_output(
      "--output (-o)", *output, output_extensions(Contents::stack), {arguments.operand(0)});
  if (!checked) return checked.error();
  auto format = chosen_format(arguments, "--format", Contents::surface);
  if (!format) return format.error();
  return SliceRequest{*std::move(options), *output, *std::move(format)};
}

std::string to_json(const Sliced& sliced, const SliceRequest& request, const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("slices", sliced.stack.sections.size());
  json.member("contours", sliced.stack.contour_count());
  json.member("vertices", sliced.stack.vertex_count());
  json.key("mesh");
  json.begin_object();
  json.member("vertices", sliced.vertices);
  json.member("triangles", sliced.triangles);
  json.end_object();
  json.member("repaired", sliced.repaired);
  json.member("written", request.output);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const Sliced& sliced, const SliceRequest& request) {
  std::string text = counted(sliced.triangles, "triangle") + " of " +
                     std::to_string(sliced.vertices) +
                     " vertices: " + counted(sliced.stack.sections.size(), "section") + ", " +
                     counted(sliced.stack.contour_count(), "contour") + ", " +
                     std::to_string(sliced.stack.vertex_count()) + " vertices\n";
  if (sliced.repaired > 0) text += counted(sliced.repaired, "change") + " by repair\n";
  return text + "written: " + printable(request.output) + '\n';
}

Result<Sliced> sliced_input(const std::string& path, const SliceRequest& request,
                            Console& console) {
  ReadOptions reading;
  reading.format = request.format;
  const Result<ReadTriangles> read = read_triangles(path, reading);
  if (!read) return read.error();
  console.warn_of(path, read->warnings);
  SliceOptions options = request.options;
  Progress progress(!console.quiet());
  options.execution.progress = progress.callback();
  Result<Sliced> sliced = slice(read->mesh, options);
  if (!sliced) return in_file(sliced.error(), path);
  console.warn_of(path, sliced->warnings);
  return sliced;
}

Result<int> run_slice(const Arguments& arguments, Console& console) {
  const auto request = slice_request_of(arguments);
  if (!request) return request.error();
  const auto sliced = sliced_input(input_path(arguments.operand(0)), *request, console);
  if (!sliced) return sliced.error();
  StagedFiles files;
  Result<void> staged = take_staged(
      io::stage_stack(request->output, sliced->stack, {}, temporary_watcher()), files, console);
  if (!staged) return staged.error();
  std::string told;
  if (console.json()) {
    told = to_json(*sliced, *request, console);
  } else if (!console.quiet()) {
    told = to_text(*sliced, *request);
  }
  const Result<void> done = deliver_with(files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command slice_command() { return {slice_usage(), run_slice}; }

}  // namespace tetloft::cli
