// See label_input.hpp.
#include "cli/label_input.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "cli/console.hpp"

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

// Word is that of the line.
std::optional<Error> check_section(const std::string& path, const SectionStack& stack,
                                   const LinkDecision& decision, const std::string& word) {
  const std::size_t below = decision.slab.index();
  if (below + 1 == stack.sections.size()) {
    return named_badly(path, below, decision.lower,
                       word + " names the last section, which has none above");
  }
  return std::nullopt;
}

std::optional<Error> check_decision(const std::string& path, const SectionStack& stack,
                                    const LinkDecision& decision) {
  const std::size_t below = decision.slab.index();
  const std::string word = decision.join ? "join" : "part";
  if (auto error = check_section(path, stack, decision, word)) return error;
  if (!is_contour(stack, below, decision.lower)) {
    return named_badly(path, below, decision.lower, word + " names a contour that the stack lacks");
  }
  if (!is_contour(stack, below + 1, decision.upper)) {
    return named_badly(path, below + 1, decision.upper,
                       word + " names a contour that the stack lacks");
  }
  return std::nullopt;
}

// The holes that lines name. Sections are nested as they are asked for.
class HoleNames {
 public:
  HoleNames(const std::string& path, const SectionStack& stack) : path_(path), stack_(stack) {}

  std::optional<Error> check(const Label& label) {
    return check_hole(label.section.index(), label.contour, "the label");
  }
  std::optional<Error> check(const LinkDecision& decision) {
    const std::size_t below = decision.slab.index();
    const std::string word = decision.join ? "open" : "close";
    if (auto error = check_section(path_, stack_, decision, word)) return error;
    if (decision.lower.valid()) {
      if (auto error = check_hole(below, decision.lower, word)) return error;
    }
    if (!decision.upper.valid()) return std::nullopt;
    return check_hole(below + 1, decision.upper, word);
  }

 private:
  std::optional<Error> check_hole(std::size_t section, ContourId contour, const std::string& what) {
    if (!is_contour(stack_, section, contour)) {
      return named_badly(path_, section, contour, what + " names a contour that the stack lacks");
    }
    auto known = nestings_.find(section);
    if (known == nestings_.end()) {
      known = nestings_.emplace(section, nest(stack_.sections[SectionId(section)])).first;
    }
    if (known->second.depth[contour] % 2 != 0) return std::nullopt;
    return named_badly(path_, section, contour, what + " names a contour that is no hole");
  }

  const std::string& path_;
  const SectionStack& stack_;
  std::map<std::size_t, Nesting> nestings_;
};

}  // namespace

namespace {

void take_labels(Labels labels, CorrespondenceOptions& options) {
  options.voids.labels = std::move(labels.hole_labels);
  options.voids.decisions = std::move(labels.void_decisions);
  options.labels = std::move(labels.labels);
  options.decisions = std::move(labels.decisions);
}

}  // namespace

Result<void> read_label_option(const Arguments& arguments, const StackInput& input,
                               CorrespondenceOptions& options) {
  const auto path = arguments.text("--labels");
  if (!path) {
    Labels labels = input.labels;
    if (options.voids.rule == VoidRule::free) labels.hole_labels.clear();
    take_labels(std::move(labels), options);
    return {};
  }
  const SectionStack& stack = input.stack();
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
  if (options.voids.rule == VoidRule::free &&
      !(read->hole_labels.empty() && read->void_decisions.empty())) {
    return in_file({ErrorCode::invalid_input,
                    "with --voids free its lines hole, open and close would do nothing",
                    {}},
                   *path);
  }
  HoleNames holes(*path, stack);
  for (const Label& label : read->hole_labels) {
    if (auto error = holes.check(label)) return *error;
  }
  for (const LinkDecision& decision : read->void_decisions) {
    if (auto error = holes.check(decision)) return *error;
  }
  take_labels(*std::move(read), options);
  return {};
}

}  // namespace tetloft::cli
