// Command lines: which options a command has, and what was given.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::cli {

struct Option {
  std::string name;   ///< "--overlap"
  std::string value;  ///< what it takes ("TAU"); empty for a flag
  std::string help;
  std::string alias = {};  ///< "-o"
  /// The words that it takes as value, alone (choice()) or beside others.
  std::vector<std::string> words = {};
};

/// What a command takes: for parsing and for --help.
struct Usage {
  std::string_view command;
  std::string_view summary;
  std::vector<std::string> operands;  ///< all are required, but see `spared`
  std::vector<Option> options;
  std::string notes;  ///< further help, one paragraph
  /// Of a command whose operand is a word: those that there are.
  std::vector<std::string> words = {};
  std::vector<std::string> further = {};  ///< operands that may follow
  bool repeats = false;                   ///< the last operand may be given several times
  std::string_view spared = {};           ///< an option that stands for all operands

  /// All operands, for help, each behind a space: " IN [OUT]", " MODEL...".
  [[nodiscard]] std::string operand_line() const;
};

class Arguments {
 public:
  /// Takes options in any place, values as "--name value" or "--name=value", operands, and
  /// "--", behind which everything is an operand. Error usage names the offender: unknown
  /// or repeated options, missing values, too few or too many operands.
  [[nodiscard]] static Result<Arguments> parse(const Usage& usage,
                                               const std::vector<std::string>& words);

  [[nodiscard]] const std::string& operand(std::size_t i) const { return operands_[i]; }
  [[nodiscard]] std::size_t operand_count() const { return operands_.size(); }
  /// All that stood behind the command.
  [[nodiscard]] const std::vector<std::string>& line() const { return line_; }
  /// Which of the usage's words the operand is, by index.
  [[nodiscard]] Result<std::size_t> chosen_operand() const;
  [[nodiscard]] bool has(std::string_view option) const { return find(option) != nullptr; }
  [[nodiscard]] std::optional<std::string> text(std::string_view option) const;
  /// The option as a finite number; empty if it was not given.
  [[nodiscard]] Result<std::optional<double>> number(std::string_view option) const;
  /// The option as an integer of [least, largest]; empty if it was not given.
  [[nodiscard]] Result<std::optional<std::int64_t>> integer(std::string_view option,
                                                            std::int64_t least,
                                                            std::int64_t largest) const;
  /// Which of its words the option is, by index; empty if it was not given.
  [[nodiscard]] Result<std::optional<std::size_t>> choice(std::string_view option) const;

 private:
  struct Given {
    std::string value;  ///< of flags ""
    std::vector<std::string> words;
  };
  [[nodiscard]] const std::string* find(std::string_view option) const;

  std::vector<std::string> line_;
  std::vector<std::string> operands_;
  std::vector<std::string> operand_words_;
  std::map<std::string, Given, std::less<>> given_;  // by full name
};

[[nodiscard]] Error usage_error(const std::string& message);

[[nodiscard]] std::string help_text(const Usage& usage);
/// Appends a paragraph in lines of 80 columns at most, indented but for the first, and its end.
void append_wrapped(std::string& text, std::string_view paragraph, std::size_t indent);

}  // namespace tetloft::cli
