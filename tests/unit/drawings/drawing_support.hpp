// What the tests of drawings share.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/inspect.hpp>

namespace tetloft::test {

inline Result<FileSummary> inspected(std::string_view bytes, const std::string& format = {}) {
  return inspect_bytes(bytes, "a.file", {.format = format});
}

/// Of what was read, all warnings in one text.
inline std::string warnings_of(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) text += to_string(warning) + '\n';
  return text;
}

inline void expect_error(std::string_view bytes, const std::vector<std::string>& parts,
                         const std::string& format = {}) {
  const auto read = inspected(bytes, format);
  ASSERT_FALSE(read.ok()) << "expected an error with: " << parts.front();
  EXPECT_EQ(read.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(read.error().where.file, "a.file");
  const std::string text = to_string(read.error());
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
  }
}

inline void expect_warning(const std::vector<Warning>& warnings,
                           const std::vector<std::string>& parts) {
  for (const Warning& warning : warnings) {
    bool all = true;
    for (const std::string& part : parts) {
      all = all && warning.message.find(part) != std::string::npos;
    }
    if (all) {
      EXPECT_EQ(warning.where.file, "a.file");
      return;
    }
  }
  ADD_FAILURE() << "no warning has " << parts.front() << ": " << warnings_of(warnings);
}

/// An object of this name with a square in each of two planes, one of an open line, one of points.
inline void expect_three_objects(const FileSummary& read, const std::string& name) {
  ASSERT_EQ(read.structures.size(), 3U);
  EXPECT_EQ(read.structures[0].number, 1);
  EXPECT_EQ(read.structures[0].name, name);
  EXPECT_EQ(read.structures[0].contours, 2U);
  EXPECT_EQ(read.structures[0].points, 8U);
  EXPECT_EQ(read.structures[0].planes, 2U);
  using Types = std::vector<std::pair<std::string, std::size_t>>;
  EXPECT_EQ(read.structures[0].types, (Types{{"closed", 2}}));
  EXPECT_EQ(read.structures[1].types, (Types{{"open", 1}}));
  EXPECT_EQ(read.structures[2].types, (Types{{"points", 1}}));
}

}  // namespace tetloft::test
