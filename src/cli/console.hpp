// What goes to the terminal: results to standard output, everything else to standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "cli/json.hpp"

namespace tetloft::cli {

class Console {
 public:
  Console(bool json, bool quiet) : json_(json), quiet_(quiet) {}
  /// Shows nothing and keeps warnings: of work beside others.
  [[nodiscard]] static Console keeping() {
    Console console(false, true);
    console.shows_ = false;
    return console;
  }

  [[nodiscard]] bool json() const { return json_; }
  [[nodiscard]] bool quiet() const { return quiet_; }

  /// Brings a command's result to its reader. Error io where it did not get there: a command
  /// that also writes files calls this before they appear.
  [[nodiscard]] Result<void> deliver(const std::string& text);
  /// Prints one line on standard error.
  void say(const std::string& text) const;
  /// Prints a warning and keeps it for the JSON object; of many of a kind, the first few are
  /// printed and the rest counted (tell_rest).
  void warn(const Warning& warning);
  /// The same for each of these, about this file where they name none.
  void warn_of(const std::string& file, const std::vector<Warning>& warnings);
  /// Says how many warnings of each kind were not printed. To be called when all have come.
  void tell_rest();
  /// Says what failed; as JSON too where that was asked for and nothing was delivered. Returns
  /// the exit code.
  int fail(const Error& error);

  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  struct Kind {
    std::size_t unprinted = 0;
    std::size_t printed = 0;
    std::string first;  // the first one's message
  };

  bool json_;
  bool quiet_;
  bool shows_ = true;
  bool delivered_ = false;  // or tried to
  std::vector<Warning> warnings_;
  std::map<std::string, Kind> kinds_;
};

/// What warnings that differ in numbers and quoted words only have in common.
[[nodiscard]] std::string kind_of(std::string_view message);

/// The members file, line, section, slab, contour, vertex, point, where known.
void write_place(JsonWriter& json, const Place& place);
/// A member "error": code, message, where.
void write_error(JsonWriter& json, const Error& error);
/// A member "warnings": objects with message and where.
void write_warnings(JsonWriter& json, const std::vector<Warning>& warnings);

/// Six significant digits, for reading.
[[nodiscard]] std::string readable(double value);
/// Digits that bring the same number back.
[[nodiscard]] std::string exact(double value);
/// 16 digits.
[[nodiscard]] std::string in_hex(std::uint64_t number);
/// Milliseconds are the finest that matter to people.
[[nodiscard]] std::string readable_seconds(double seconds);
/// "1 tet", "2 tets".
[[nodiscard]] std::string counted(std::size_t n, const char* singular);

/// Seconds of wall-clock time since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The error, about this file where it names none.
[[nodiscard]] Error in_file(Error error, const std::string& file);

}  // namespace tetloft::cli
