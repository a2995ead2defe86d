// What the tests of formats of volumes ask of a summary.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include <tetloft/inspect.hpp>

#include "unit/io/io_support.hpp"

namespace tetloft::test {

/// "0:6 1:5 7:1": values and voxels, with names where there are some.
inline std::string labels_of(const Result<FileSummary>& summary) {
  if (!summary) return to_string(summary.error());
  if (!summary->volume) return "no volume";
  std::string text;
  for (const LabelSummary& label : summary->volume->labels) {
    if (!text.empty()) text += ' ';
    text += std::to_string(static_cast<int>(label.value)) + ':' + std::to_string(label.voxels);
    if (!label.name.empty()) text += ' ' + label.name;
  }
  return text;
}
inline const char* const kFewLabels = "0:6 1:5 7:1";

inline std::string refusal_of(const Result<FileSummary>& summary) {
  if (summary) return "taken";
  EXPECT_EQ(summary.error().code, ErrorCode::invalid_input);
  EXPECT_FALSE(summary.error().where.file.empty());
  return summary.error().message;
}

/// The rows of the matrix in one line.
inline std::string matrix_of(const Result<FileSummary>& summary) {
  if (!summary || !summary->volume) return "none";
  std::string text;
  for (std::size_t row = 0; row < 3; ++row) {
    for (const double entry : summary->volume->matrix[row]) {
      std::string number = std::to_string(entry);
      number.erase(number.find_last_not_of('0') + 1);
      if (number.back() == '.') number.pop_back();
      text += (text.empty() ? "" : " ") + number;
    }
    if (row < 2) text += " |";
  }
  return text;
}

/// The messages of its warnings, one after the other.
inline std::string warnings_of(const Result<FileSummary>& summary) {
  std::string text;
  if (!summary) return text;
  for (const Warning& warning : summary->warnings) text += warning.message + '\n';
  return text;
}

}  // namespace tetloft::test
