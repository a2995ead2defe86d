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
    if (warnings_.size() >= kMost) {
      ++untold_;
      return;
    }
    Warning warning{std::move(message), {}};
    warning.where.file = name_;
    if (line != 0) warning.where.line = line;
    warnings_.push_back(std::move(warning));
  }

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
  static constexpr std::size_t kMost = 1000;

  std::string name_;
  std::vector<Warning> warnings_;
  std::size_t untold_ = 0;
};

}  // namespace tetloft::internal::io
