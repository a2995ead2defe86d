// tetloft links: what belongs together, and how surely, without making a solid.
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/engine_option.hpp"
#include "cli/file_formats.hpp"
#include "cli/label_input.hpp"
#include "cli/link_report.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/repaired_output.hpp"
#include "cli/signals.hpp"
#include "cli/stack_input.hpp"
#include "core/text.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Usage links_usage() {
  Usage usage{
      "links",
      "Which regions of neighbouring sections belong together, and which holes, why, and how "
      "surely.",
      {input_word("IN", Contents::stack)},
      {{"--output", output_word("OUT", Contents::labels),
        "where the lines go; default: standard output", "-o"},
       {"--first", "N", "only the N least sure links, and as many of voids; default: all"}},
      "Prints a line for each link that is made, and each that nearly was, the least sure "
      "first: join or part, the lower section, its contour, the contour of the section "
      "above; behind # the evidence and its measures. Then, likewise, of voids: open or "
      "close, with holes or the word outside. --labels takes these lines back, as they are "
      "or changed. No solid is made: a link that turns out to be unrealisable is told by "
      "reconstruct. --json: links by slab, least_sure (their order of doubt), made and "
      "not_made (counts), components, motions; voids: the same of voids, and cavities."};
  for (const Option& option : stack_options()) usage.options.push_back(option);
  usage.options.push_back(repaired_option());
  for (const Option& option : {kThreadsOption, kJsonOption, kQuietOption, kHelpOption}) {
    usage.options.push_back(option);
  }
  return usage;
}

struct LinksRequest {
  std::string input;
  std::optional<std::string> output;
  std::optional<std::string> repaired;
  std::optional<std::size_t> first;
  LinkOptions options;
  Preparation preparation;
};

Result<LinksRequest> links_request_of(const Arguments& arguments, Console& console) {
  LinksRequest request;
  request.input = arguments.operand(0);
  request.output = arguments.text("--output");
  std::vector<std::string> taken{request.input};
  if (const auto labels = arguments.text("--labels")) taken.push_back(*labels);
  if (request.output) {
    Result<void> checked =
        check_output("--output (-o)", *request.output, output_extensions(Contents::labels), taken);
    if (!checked) return checked.error();
    taken.push_back(*request.output);
  }
  auto repaired = repaired_output(arguments, taken);
  if (!repaired) return repaired.error();
  request.repaired = *std::move(repaired);
  const auto first = arguments.integer("--first", 1, std::numeric_limits<std::uint32_t>::max());
  if (!first) return first.error();
  if (first->has_value()) request.first = static_cast<std::size_t>(**first);
  const auto correspondence = correspondence_options(arguments, console);
  if (!correspondence) return correspondence.error();
  request.options.correspondence = *correspondence;
  const auto prepared = preparation(arguments);
  if (!prepared) return prepared.error();
  request.preparation = *prepared;
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  request.options.execution.threads = *threads;
  return request;
}

void write_motions(JsonWriter& json, const std::vector<RegionMotion>& motions) {
  json.key("motions");
  json.begin_array();
  for (const RegionMotion& motion : motions) {
    json.begin_object();
    json.member("slab", motion.slab.index());
    json.member("section", motion.slab.index() + (motion.upper ? 1U : 0U));
    json.member("contour", motion.contour.index());
    json.member("by", std::array{motion.by.x, motion.by.y});
    json.end_object();
  }
  json.end_array();
}

std::string to_json(const LinkListing& listing, const StackInput& input, const Console& console) {
  const StackLinks& found = listing.links;
  JsonWriter json;
  json.begin_object();
  json.member("slices", listing.sections);
  json.member("contours", input.stack().contour_count());
  json.member("components", found.components);
  write_links(json, listing);
  write_motions(json, found.motions);
  write_preparation(json, input);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

Result<StagedFiles> stage_lines_of(const LinksRequest& request, const LinkListing& listing,
                                   Console& console) {
  StagedFiles files;
  if (!request.output) return files;
  Result<void> staged =
      take_staged(io::stage_file(*request.output, link_lines(listing, true), temporary_watcher()),
                  files, console);
  if (!staged) return staged.error();
  return files;
}

Result<int> run_links(const Arguments& arguments, Console& console) {
  Result<LinksRequest> request = links_request_of(arguments, console);
  if (!request) return request.error();
  const auto input = read_stack_input(request->input, request->preparation, console);
  if (!input) return input.error();
  const Result<void> labelled =
      read_label_option(arguments, *input, request->options.correspondence);
  if (!labelled) return labelled.error();
  Result<StackLinks> found = [&] {
    Progress progress(!console.quiet());
    request->options.execution.progress = progress.callback();
    return find_links(input->stack(), request->options);
  }();
  if (!found) return in_file(found.error(), request->input);
  console.warn_of(request->input, found->warnings);
  const CorrespondenceOptions& asked = request->options.correspondence;
  const LinkListing listing{input->stack().sections.size(), asked.labels, asked.voids.labels,
                            *std::move(found), request->first};
  auto files = stage_lines_of(*request, listing, console);
  if (!files) return files.error();
  const Result<void> mended = stage_repaired(request->repaired, input->stack(), *files, console);
  if (!mended) return mended.error();
  std::string told;
  if (console.json()) {
    told = to_json(listing, *input, console);
  } else if (!request->output) {
    told = link_lines(listing, !console.quiet());
  } else if (!console.quiet()) {
    told = describe_preparation(*input) + counted(listing.links.components, "component") + '\n' +
           describe_links(listing.links.links, listing.links.void_links) +
           "written: " + printable(*request->output) + '\n';
  }
  const Result<void> done = deliver_with(*files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command links_command() { return {links_usage(), run_links}; }

}  // namespace tetloft::cli
