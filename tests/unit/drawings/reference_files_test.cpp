// Files of other programs, where they are there: what inspect() tells of each is what an
// independent reader found, in NAME.truth.json beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "cli/json_value.hpp"
#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

namespace fs = std::filesystem;
using namespace test;

fs::path folder_of(const std::string& format) {
  return fs::path(TETLOFT_SHARED_DATA_DIR) / "formats" / format;
}

JsonValue truth_of(const fs::path& file) {
  std::ifstream stream(file.string() + ".truth.json", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return parse_json(text).value_or(JsonValue());
}

std::vector<fs::path> files_of(const std::string& format) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder_of(format))) return files;
  for (const auto& entry : fs::directory_iterator(folder_of(format))) {
    if (entry.path().extension() != ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::size_t count_at(const JsonValue& value, const std::string& key) {
  return static_cast<std::size_t>(value.at(key).number);
}

void expect_structure(const StructureSummary& structure, const JsonValue& truth) {
  SCOPED_TRACE(structure.name);
  EXPECT_EQ(structure.name, truth.at("name").string);
  EXPECT_EQ(structure.contours, count_at(truth, "contours"));
  EXPECT_EQ(structure.points, count_at(truth, "points"));
  // Where all contours are too small to have a plane the truth has none.
  if (truth.has("planes")) {
    EXPECT_EQ(structure.planes, count_at(truth, "planes"));
  }
  std::map<std::string, std::size_t> types;
  for (const auto& [type, count] : truth.at("geometric_types").object) {
    types[type] = static_cast<std::size_t>(count.number);
  }
  EXPECT_EQ((std::map<std::string, std::size_t>(structure.types.begin(), structure.types.end())),
            types);
}

// Of each file of a format, all of which can be read: body(path, truth, what inspect() tells).
// False where there are none.
template <class Body>
bool for_each_summary(const std::string& format, Body&& body) {
  const std::vector<fs::path> files = files_of(format);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    const auto read = inspect(file.string());
    if (read) {
      body(file, truth_of(file), *read);
    } else {
      ADD_FAILURE() << to_string(read.error());
    }
  }
  return !files.empty();
}

TEST(ReferenceFiles, StructureSets) {
  const std::vector<fs::path> files = files_of("rtstruct");
  if (files.empty()) GTEST_SKIP() << "no reference files";
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    const JsonValue truth = truth_of(file);
    const auto read = inspect(file.string());
    if (truth.has("truth_error")) {
      ASSERT_FALSE(read.ok());
      EXPECT_NE(read.error().message.find("byte "), std::string::npos);
      EXPECT_NE(read.error().message.find("(3006,0050)"), std::string::npos);
      continue;
    }
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    const std::vector<JsonValue>& rois = truth.at("rois").array;
    ASSERT_EQ(read->structures.size(), rois.size());
    for (const JsonValue& roi : rois) {
      const auto found = std::find_if(
          read->structures.begin(), read->structures.end(),
          [&](const auto& s) { return static_cast<double>(s.number) == roi.at("number").number; });
      ASSERT_NE(found, read->structures.end());
      expect_structure(*found, roi);
    }
  }
}

TEST(ReferenceFiles, Cxt) {
  const auto as_told = [](const fs::path& /*file*/, const JsonValue& truth,
                          const FileSummary& read) {
    ASSERT_EQ(read.structures.size(), truth.at("rois").array.size());
    for (std::size_t s = 0; s < read.structures.size(); ++s) {
      const StructureSummary& structure = read.structures[s];
      const std::string number = std::to_string(structure.number);
      EXPECT_EQ(structure.contours, count_at(truth.at("contours_per_roi"), number));
      EXPECT_EQ(structure.points, count_at(truth.at("points_per_roi"), number));
      const std::string& line = truth.at("rois").array[s].string;
      EXPECT_TRUE(line.starts_with(number + '|')) << line;
      EXPECT_TRUE(line.ends_with('|' + structure.name)) << line;
    }
  };
  if (!for_each_summary("cxt", as_told)) GTEST_SKIP() << "no reference files";
}

TEST(ReferenceFiles, Csl) {
  const auto as_told = [](const fs::path& file, const JsonValue& truth, const FileSummary& read) {
    ASSERT_TRUE(read.lines.has_value());
    EXPECT_EQ(read.lines->planes, count_at(truth, "planes_read"));
    EXPECT_EQ(read.lines->contours, count_at(truth, "components"));
    EXPECT_EQ(read.lines->points, count_at(truth, "vertices"));
    EXPECT_EQ(read.lines->open, 0U);
    std::vector<std::int64_t> labels;
    for (const JsonValue& label : truth.at("labels_used").array) {
      labels.push_back(static_cast<std::int64_t>(label.number));
    }
    EXPECT_EQ(read.lines->labels, labels);
    const auto stack = read_stack(file.string());
    EXPECT_EQ(stack.ok(), truth.at("planes_parallel").boolean);
    if (!stack) return;
    EXPECT_EQ(stack->stack.sections.size(), count_at(truth, "planes_read"));
    // Holes have the labels of what is around them.
    EXPECT_EQ(stack->labels.labels.size(),
              count_at(truth, "components") - count_at(truth, "holes"));
  };
  if (!for_each_summary("csl", as_told)) GTEST_SKIP() << "no reference files";
}

TEST(ReferenceFiles, Slc) {
  const auto as_told = [](const fs::path& file, const JsonValue& truth, const FileSummary& read) {
    ASSERT_TRUE(read.lines.has_value());
    EXPECT_EQ(read.lines->planes, count_at(truth, "slices"));
    EXPECT_EQ(read.lines->contours, count_at(truth, "contours"));
    EXPECT_EQ(read.lines->points, count_at(truth, "points"));
    EXPECT_EQ(read.lines->open, count_at(truth, "open"));
    EXPECT_EQ(read.lines->closed, count_at(truth, "closed"));
    EXPECT_EQ(read.warnings.size(), count_at(truth, "adjacency_out_of_range"));
    const auto stack = read_stack(file.string());
    EXPECT_EQ(stack.ok(), count_at(truth, "open") == 0);
    if (!stack) return;
    EXPECT_EQ(stack->labels.labels.size() + stack->labels.hole_labels.size(),
              count_at(truth, "contours"));
  };
  if (!for_each_summary("slc", as_told)) GTEST_SKIP() << "no reference files";
}

TEST(ReferenceFiles, Imod) {
  const auto as_told = [](const fs::path& /*file*/, const JsonValue& truth,
                          const FileSummary& read) {
    EXPECT_EQ(read.unit, "nm");
    EXPECT_EQ(read.warnings.size(), 0U) << warnings_of(read.warnings);
    const std::vector<JsonValue>& objects = truth.at("objects").array;
    ASSERT_EQ(read.structures.size(), objects.size());
    for (std::size_t s = 0; s < objects.size(); ++s) {
      const StructureSummary& structure = read.structures[s];
      EXPECT_EQ(structure.name, objects[s].at("name").string);
      EXPECT_EQ(structure.contours, count_at(objects[s], "contours_header"));
      std::size_t points = 0;
      for (const JsonValue& contour : objects[s].at("contours").array) {
        points += count_at(contour, "points");
      }
      EXPECT_EQ(structure.points, points);
      const bool open = objects[s].at("open_flag").boolean;
      for (const auto& [type, count] : structure.types) EXPECT_EQ(type, open ? "open" : "closed");
    }
  };
  if (!for_each_summary("imod", as_told)) GTEST_SKIP() << "no reference files";
}

}  // namespace
}  // namespace tetloft
