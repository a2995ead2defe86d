// What tests of drawings that become stacks share, and the files of reference where they are.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>
#include <tetloft/nesting.hpp>

#include "unit/io/io_support.hpp"

namespace tetloft::test {

inline ReadOptions as_format(const std::string& format) {
  ReadOptions options;
  options.format = format;
  return options;
}

/// All warnings in a row.
inline std::string texts_of(const std::vector<Warning>& warnings) {
  std::string all;
  for (const Warning& warning : warnings) all += to_string(warning) + '\n';
  return all;
}

inline bool says(const std::vector<Warning>& warnings, const std::string& text) {
  return texts_of(warnings).find(text) != std::string::npos;
}

inline std::vector<double> heights_of(const SectionStack& stack) {
  std::vector<double> heights;
  for (const Section& section : stack.sections) heights.push_back(section.z);
  return heights;
}

/// Twice the area of a section by the odd-even rule, from its nesting.
inline double region_area(const Section& section) {
  const Nesting nesting = nest(section);
  double sum = 0;
  for (const ContourId c : section.contours.ids()) {
    const double area = std::abs(twice_area(section.contours[c])) / 2;
    sum += nesting.depth[c] % 2 == 0 ? area : -area;
  }
  return sum;
}

/// The error of reading `text`; empty where it can be read.
inline std::string refusal_of(const std::string& text, const ReadOptions& options,
                              const std::string& name = "a.x") {
  const Result<ReadStack> read = parse_stack(text, name, options);
  return read ? "" : to_string(read.error());
}

/// The reference files of a format, where they are.
inline std::vector<std::filesystem::path> reference_files(const std::string& format) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  const fs::path folder = fs::path(TETLOFT_SHARED_DATA_DIR) / "formats" / format;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().string();
    if (fs::exists(name + ".truth.json")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The number behind `"key":` in the truth of a file, at the outermost level; −1: none.
inline double truth_number(const std::filesystem::path& file, const std::string& key) {
  const std::string text = get(file.string() + ".truth.json");
  const std::size_t at = text.find("\n \"" + key + "\": ");
  return at == std::string::npos ? -1 : std::strtod(text.c_str() + at + key.size() + 6, nullptr);
}

}  // namespace tetloft::test
