// See label_input.hpp.
#include "cli/label_input.hpp"

#include <optional>
#include <string>
#include <utility>

namespace tetloft::cli {

namespace {

bool is_contour(const SectionStack& stack, std::size_t section, ContourId contour) {
  return section < stack.sections.size() &&
         contour.index() < stack.sections[SectionId(section)].contours.size();
}

Error named_badly(const std::string& path, std::size_t section, ContourId contour,
                  const std::string& message) {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = path;
  error.where.section = section;
  error.where.contour = contour.index();
  return error;
}

std::optional<Error> check_decision(const std::string& path, const SectionStack& stack,
                                    const LinkDecision& decision) {
  const std::size_t below = decision.slab.index();
  const std::string word = decision.join ? "join" : "part";
  if (below + 1 == stack.sections.size()) {
    return named_badly(path, below, decision.lower,
                       word + " names the last section, which has none above");
  }
  if (!is_contour(stack, below, decision.lower)) {
    return named_badly(path, below, decision.lower, word + " names a contour that the stack lacks");
  }
  if (!is_contour(stack, below + 1, decision.upper)) {
    return named_badly(path, below + 1, decision.upper,
                       word + " names a contour that the stack lacks");
  }
  return std::nullopt;
}

}  // namespace

Result<void> read_label_option(const Arguments& arguments, const SectionStack& stack,
                               CorrespondenceOptions& options) {
  const auto path = arguments.text("--labels");
  if (!path) return {};
  Result<Labels> read = read_labels(*path);
  if (!read) return read.error();
  for (const Label& label : read->labels) {
    if (is_contour(stack, label.section.index(), label.contour)) continue;
    return named_badly(*path, label.section.index(), label.contour,
                       "the label names a contour that the stack lacks");
  }
  for (const LinkDecision& decision : read->decisions) {
    if (auto error = check_decision(*path, stack, decision)) return *error;
  }
  options.labels = std::move(read->labels);
  options.decisions = std::move(read->decisions);
  return {};
}

}  // namespace tetloft::cli
