// Parsing command lines and writing their help.
#include "cli/arguments.hpp"

#include <algorithm>

#include "core/spelling.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

Error usage_error(const std::string& message) { return {ErrorCode::usage, message, {}}; }

namespace {

const Option* find_option(const Usage& usage, std::string_view word) {
  for (const Option& option : usage.options) {
    if (option.name == word || (!option.alias.empty() && option.alias == word)) return &option;
  }
  return nullptr;
}

std::string unknown_option(const Usage& usage, const std::string& name) {
  if (name == "--drift") {
    return "there is no option --drift any more: oblique parts are continued unless --no-chain is "
           "given";
  }
  std::vector<std::string_view> names;
  for (const Option& option : usage.options) names.push_back(option.name);
  return "unknown option " + io::in_quotes(name) + did_you_mean(name, names);
}

// What an option is called in messages: "--output (-o)".
std::string display_name(const Option& option) {
  std::string name = option.name;
  if (!option.alias.empty()) name += " (" + option.alias + ')';
  return name;
}

std::string see_help(const Usage& usage) {
  return "; see tetloft " + std::string(usage.command) + " --help";
}

}  // namespace

Result<Arguments> Arguments::parse(const Usage& usage, const std::vector<std::string>& words) {
  Arguments arguments;
  arguments.operand_words_ = usage.words;
  arguments.line_ = words;
  bool options_ended = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (options_ended || word.size() < 2 || word.front() != '-') {
      arguments.operands_.push_back(word);
      continue;
    }
    if (word == "--") {
      options_ended = true;
      continue;
    }
    const std::size_t equals = word.rfind("--", 0) == 0 ? word.find('=') : std::string::npos;
    const std::string name = word.substr(0, equals);
    const Option* const option = find_option(usage, name);
    if (option == nullptr) {
      return usage_error(unknown_option(usage, name) + see_help(usage));
    }
    std::string value;
    if (option->value.empty()) {
      if (equals != std::string::npos) {
        return usage_error("option " + display_name(*option) + " takes no value");
      }
    } else if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else {
      // A following option is more likely a forgotten value than a value.
      const bool missing = i + 1 == words.size() || words[i + 1].rfind("--", 0) == 0;
      if (missing) {
        return usage_error("option " + display_name(*option) + " needs a value (" + option->value +
                           ')');
      }
      value = words[++i];
    }
    if (!arguments.given_.emplace(option->name, Given{value, option->words}).second) {
      return usage_error("option " + display_name(*option) + " is given twice");
    }
  }
  const std::size_t expected = usage.operands.size();
  const bool spared = arguments.has(usage.spared) && arguments.operands_.empty();
  if (arguments.operands_.size() < expected && !spared && !arguments.has("--help")) {
    return usage_error("missing " + usage.operands[arguments.operands_.size()] + see_help(usage));
  }
  const std::size_t most = expected + usage.further.size();
  if (arguments.operands_.size() > most && !usage.repeats) {
    const bool writes = find_option(usage, "--output") != nullptr;
    return usage_error("unexpected argument " + io::in_quotes(arguments.operands_[most]) +
                       (writes && !arguments.has("--output") ? " (an output needs -o)" : "") +
                       see_help(usage));
  }
  return arguments;
}

const std::string* Arguments::find(std::string_view option) const {
  const auto found = given_.find(option);
  return found == given_.end() ? nullptr : &found->second.value;
}

std::optional<std::string> Arguments::text(std::string_view option) const {
  const std::string* const value = find(option);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

Result<std::optional<double>> Arguments::number(std::string_view option) const {
  const std::string* const value = find(option);
  if (value == nullptr) return std::optional<double>();
  const io::ParsedNumber number = io::parse_number(*value);
  if (!number.ok()) {
    return usage_error("option " + std::string(option) + ": " +
                       io::complaint(*value, number.status));
  }
  return std::optional(number.value);
}

Result<std::optional<std::int64_t>> Arguments::integer(std::string_view option, std::int64_t least,
                                                       std::int64_t largest) const {
  const std::string* const value = find(option);
  if (value == nullptr) return std::optional<std::int64_t>();
  const auto number = io::parse_integer(*value);
  if (!number || *number < least || *number > largest) {
    return usage_error("option " + std::string(option) + ": " + io::in_quotes(*value) +
                       " is no integer from " + std::to_string(least) + " to " +
                       std::to_string(largest));
  }
  return number;
}

namespace {

// Which of `words` the value is; `of` says in messages what has that value.
Result<std::size_t> chosen_word(const std::string& of, const std::string& value,
                                const std::vector<std::string>& words) {
  const auto found = std::find(words.begin(), words.end(), value);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const std::vector<std::string_view> names(words.begin(), words.end());
  return usage_error(of + io::in_quotes(value) + " is not " + list_of(names) +
                     did_you_mean(value, names));
}

}  // namespace

Result<std::optional<std::size_t>> Arguments::choice(std::string_view option) const {
  const auto given = given_.find(option);
  if (given == given_.end()) return std::optional<std::size_t>();
  const auto word =
      chosen_word("option " + std::string(option) + ": ", given->second.value, given->second.words);
  if (!word) return word.error();
  return std::optional(*word);
}

Result<std::size_t> Arguments::chosen_operand() const {
  return chosen_word("", operands_.front(), operand_words_);
}

void append_wrapped(std::string& text, std::string_view paragraph, std::size_t indent) {
  constexpr std::size_t kWidth = 80;
  std::size_t column = indent;
  while (!paragraph.empty()) {
    const std::size_t end = std::min(paragraph.find(' '), paragraph.size());
    const std::string_view word = paragraph.substr(0, end);
    paragraph.remove_prefix(std::min(end + 1, paragraph.size()));
    if (column > indent && column + 1 + word.size() > kWidth) {
      text += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      text += ' ';
      ++column;
    }
    text += word;
    column += word.size();
  }
  text += '\n';
}

std::string Usage::operand_line() const {
  std::string line;
  for (const std::string& operand : operands) line += ' ' + operand;
  for (const std::string& operand : further) line += " [" + operand + ']';
  return line + (repeats ? "..." : "");
}

std::string help_text(const Usage& usage) {
  constexpr std::size_t kHelpColumn = 30;
  std::string text = "usage: tetloft " + std::string(usage.command);
  text += usage.operand_line() + " [options]\n\n";
  append_wrapped(text, usage.summary, 0);
  text += "\noptions:\n";
  for (const Option& option : usage.options) {
    std::string left = "  " + option.alias;
    if (!option.alias.empty()) left += ", ";
    left += option.name;
    if (!option.value.empty()) left += ' ' + std::string(option.value);
    left.resize(std::max(left.size() + 1, kHelpColumn), ' ');
    text += left;
    if (left.size() > kHelpColumn) text += '\n' + std::string(kHelpColumn, ' ');
    append_wrapped(text, option.help, kHelpColumn);
  }
  if (!usage.notes.empty()) {
    text += '\n';
    append_wrapped(text, usage.notes, 0);
  }
  return text;
}

}  // namespace tetloft::cli
