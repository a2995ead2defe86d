// Numbers that come in any order, more of them than memory holds, read back sorted.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

#include "io/scratch_column.hpp"

namespace tetloft::internal::io {

/// In memory are a run of numbers, sorted and put away when it is full, and, while they are read, a
/// stretch of each run.
class SortedScratch {
 public:
  /// How many numbers are in a run, and in a stretch of it.
  static constexpr std::size_t kRun = std::size_t{1} << 18;
  static constexpr std::size_t kStretch = std::size_t{1} << 10;

  /// Temporaries as of ScratchFile.
  explicit SortedScratch(const std::string& path, std::size_t run = kRun,
                         std::size_t stretch = kStretch)
      : run_size_(run), stretch_(stretch), sorted_(path) {}

  /// No NaN.
  void push_back(double value);
  /// Calls visit with all numbers, in increasing order, until it returns false. May be called
  /// again, and more numbers be added in between.
  void for_each(const std::function<bool(double)>& visit);
  [[nodiscard]] const std::optional<Error>& failure() const { return sorted_.failure(); }

 private:
  void put_away();

  std::size_t run_size_;
  std::size_t stretch_;
  std::vector<double> run_;
  ScratchColumn<double> sorted_;   // runs, one behind the other
  std::vector<std::size_t> ends_;  // of runs
};

}  // namespace tetloft::internal::io
