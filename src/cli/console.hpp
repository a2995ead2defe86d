// What goes to the terminal: results to standard output, everything else to standard error.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

#include "cli/json.hpp"

namespace tetloft::cli {

class Console {
 public:
  Console(bool json, bool quiet) : json_(json), quiet_(quiet) {}

  [[nodiscard]] bool json() const { return json_; }
  [[nodiscard]] bool quiet() const { return quiet_; }

  /// Prints a result.
  void print(const std::string& text) const;
  /// Prints a message on standard error.
  void say(const std::string& text) const;
  /// Prints a warning and keeps it for the JSON object.
  void warn(const Warning& warning);
  /// Says what failed; as JSON too where that was asked for. Returns the exit code.
  int fail(const Error& error) const;

  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  bool json_;
  bool quiet_;
  std::vector<Warning> warnings_;
};

/// The members file, line, section, slab, contour, vertex, point, where known.
void write_place(JsonWriter& json, const Place& place);
/// A member "warnings": objects with message and where.
void write_warnings(JsonWriter& json, const std::vector<Warning>& warnings);

/// Six significant digits, for reading.
[[nodiscard]] std::string readable(double value);
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

}  // namespace tetloft::cli
