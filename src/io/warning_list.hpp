// Warnings of one file: a file of a million slips gets a thousand of them, and one that counts the
// others.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

class WarningList {
 public:
  /// Of the file `name`.
  explicit WarningList(std::string name) : name_(std::move(name)) {}

  /// `line` is one-based; 0: none.
  void add(std::string message, std::size_t line = 0) {
    Warning warning{std::move(message), {}};
    if (line != 0) warning.where.line = line;
    add(std::move(warning));
  }
  /// At its place, in the file.
  void add(Warning warning) {
    if (warnings_.size() >= kMost) {
      ++untold_;
      return;
    }
    warning.where.file = name_;
    warnings_.push_back(std::move(warning));
  }
  /// Those of `other`, a list of the same file, behind these; as if each had been added here.
  void append(WarningList other) {
    for (Warning& warning : other.warnings_) add(std::move(warning));
    untold_ += other.untold_;
  }

  /// The most that are told one by one.
  static constexpr std::size_t kMost = 1000;

  [[nodiscard]] std::vector<Warning> take() {
    if (untold_ != 0) {
      Warning warning{"and " + std::to_string(untold_) + " more warnings of this file", {}};
      warning.where.file = name_;
      warnings_.push_back(std::move(warning));
      untold_ = 0;
    }
    return std::exchange(warnings_, {});
  }

 private:
  std::string name_;
  std::vector<Warning> warnings_;
  std::size_t untold_ = 0;
};

}  // namespace tetloft::internal::io
