// Volumes of other programs, beside what independent readers found in them. Skipped where they are
// not there.
//
// What the readers mean by the same words differs: nibabel's matrix leads to RAS, those of NRRD and
// MetaImage to the space that the header names; nibabel calls big-endian types ">i2".
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>
#include <tetloft/section_stack.hpp>

#include "cli/json_value.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {
namespace {

namespace fs = std::filesystem;
using test::JsonValue;

std::string reference_folder() {
  const char* const set = std::getenv("TETLOFT_SHARED_DATA");
  return std::string(set != nullptr ? set : TETLOFT_SHARED_DATA_DIR) + "/formats/";
}

// Files with a truth, by name.
std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(folder, absent)) {
    const std::string name = entry.path().filename().string();
    const std::string end = ".truth.json";
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0) {
      names.push_back(name.substr(0, name.size() - end.size()));
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<double> numbers_of(const JsonValue& array) {
  std::vector<double> numbers;
  for (const JsonValue& value : array.array) numbers.push_back(value.number);
  return numbers;
}

std::vector<double> as_numbers(const std::vector<std::size_t>& sizes) {
  return {sizes.begin(), sizes.end()};
}

std::string plain_type(const std::string& dtype) {
  if (dtype == ">i2") return "int16";
  if (dtype == ">u2") return "uint16";
  if (dtype == ">f8") return "float64";
  return dtype;
}

// Numbers of text, as ITK prints them.
std::vector<double> printed_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t used = 0;
    numbers.push_back(std::stod(text.substr(at), &used));
    at += used + 1;
  }
  return numbers;
}

// Of more than 60 values the truth has but some; of images all that is counted here is the range.
void expect_labels(const VolumeSummary& volume, const JsonValue& labels) {
  if (!labels.has("distinct")) return;
  const auto distinct = static_cast<std::size_t>(labels.at("distinct").number);
  EXPECT_EQ(volume.intensities, distinct > kMostLabels);
  if (volume.intensities) return;
  EXPECT_EQ(volume.labels.size(), distinct);
  for (const auto& [value, voxels] : labels.at("counts").object) {
    std::size_t found = 0;
    for (const LabelSummary& label : volume.labels) {
      if (std::abs(std::stod(value) - label.value) < 1e-6) found += label.voxels;
    }
    EXPECT_EQ(static_cast<double>(found), voxels.number) << value;
  }
}

void expect_matrix(const VolumeSummary& volume, const JsonValue& rows) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const double expected = rows.array.at(row).array.at(column).number;
      EXPECT_NEAR(volume.matrix[row][column], expected, 1e-5 * (1 + std::abs(expected)))
          << row << ' ' << column;
    }
  }
}

// ITK's world is LPS, whatever the file's.
void expect_itk(const VolumeSummary& volume, const JsonValue& itk, bool turned) {
  if (!itk.has("origin")) return;
  const std::vector<double> origin = printed_numbers(itk.at("origin").string);
  const std::vector<double> spacing = printed_numbers(itk.at("spacing").string);
  const std::vector<double> direction = printed_numbers(itk.at("direction").string);
  ASSERT_EQ(origin.size(), 3U);
  for (std::size_t row = 0; row < 3; ++row) {
    const double sign = turned && row < 2 ? -1 : 1;
    EXPECT_NEAR(sign * volume.matrix[row][3], origin[row], 1e-4);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(sign * volume.matrix[row][axis], direction[3 * row + axis] * spacing[axis],
                  2e-4 * spacing[axis]);
    }
  }
}

// Every label, across every axis, both ways.
void expect_stacks(const std::string& path, const VolumeSummary& volume) {
  std::size_t tried = 0;
  for (const std::string& structure : volume.structures) {
    if (++tried > 4) break;
    for (const int axis : {0, 1, 2}) {
      for (const auto way : {VolumeContours::sub_pixel, VolumeContours::lattice}) {
        ReadOptions options;
        options.structure = structure;
        options.axis = axis;
        options.contours = way;
        const Result<ReadStack> read = read_stack(path, options);
        ASSERT_TRUE(read.ok()) << to_string(read.error());
      }
    }
  }
}

void expect_refused(const std::string& path, const std::string& words) {
  const Result<FileSummary> summary = inspect(path);
  ASSERT_FALSE(summary.ok());
  EXPECT_NE(summary.error().message.find(words), std::string::npos) << summary.error().message;
  EXPECT_FALSE(summary.error().where.file.empty());
}

TEST(ReferenceVolumes, Nifti) {
  const std::string folder = reference_folder() + "nifti/";
  const std::vector<std::string> names = files_in(folder);
  if (names.empty()) GTEST_SKIP() << "no reference files in " << folder;
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const JsonValue truth = *test::parse_json(test::get(folder + name + ".truth.json"));
    if (truth.has("nibabel_error")) {
      expect_refused(folder + name, "cut off");
      continue;
    }
    const Result<FileSummary> summary = inspect(folder + name);
    ASSERT_TRUE(summary.ok()) << to_string(summary.error());
    EXPECT_EQ(summary->format, "nifti");
    const VolumeSummary& volume = *summary->volume;
    EXPECT_EQ(as_numbers(volume.size), numbers_of(truth.at("shape")));
    EXPECT_EQ(volume.type, plain_type(truth.at("dtype").string));
    EXPECT_EQ(volume.space, "RAS");
    const std::string unit = truth.at("xyzt_units").array.at(0).string;
    EXPECT_EQ(volume.unit, unit == "micron" ? "um" : unit == "unknown" ? "" : unit);
    // nibabel flips and centres a volume without transforms; ITK, as here, does not.
    const bool placed = truth.at("qform_code").number > 0 || truth.at("sform_code").number > 0;
    if (placed) expect_matrix(volume, truth.at("affine_used"));
    // Of a volume without transforms ITK's world is that of the numbers, as here. ITK makes
    // millimetres of microns and turns a sheared sform into a rotation; of several volumes and of
    // what it may not call LPS plastimatch prints numbers of its own.
    const bool differs =
        unit == "micron" || name == "nifti_oblique_sform.nii.gz" || volume.size.size() > 3;
    const JsonValue& itk = truth.at("itk_5.2_via_plastimatch");
    if (!differs) expect_itk(volume, itk, placed && volume.space == "RAS");
    expect_labels(volume, truth.at("labels"));
    expect_stacks(folder + name, volume);
  }
}

void expect_segments(const VolumeSummary& volume, const JsonValue& segments) {
  for (const auto& [key, value] : segments.object) {
    const std::size_t end = key.find("_LabelValue");
    if (end == std::string::npos) continue;
    const std::string name = segments.at(key.substr(0, end) + "_Name").string;
    std::size_t found = 0;
    for (const LabelSummary& label : volume.labels) {
      if (label.value == std::stod(value.string) && label.name == name) ++found;
    }
    EXPECT_EQ(found, 1U) << name;
  }
}

// Directions stand in the truth axis by axis; without them ITK tells what spacings and axis mins
// come to.
void expect_nrrd_place(const VolumeSummary& volume, const JsonValue& truth) {
  const JsonValue& directions = truth.at("space_directions");
  std::size_t axis = 0;
  for (const JsonValue& direction : directions.array) {
    if (direction.kind != JsonValue::Kind::array) continue;
    for (std::size_t row = 0; row < direction.array.size(); ++row) {
      EXPECT_EQ(volume.matrix[row][axis], direction.array[row].number);
    }
    ++axis;
  }
  const std::vector<double> origin = numbers_of(truth.at("space_origin"));
  for (std::size_t row = 0; row < origin.size(); ++row) {
    EXPECT_EQ(volume.matrix[row][3], origin[row]);
  }
  if (volume.size.size() == 3) {
    expect_itk(volume, truth.at("itk_5.2_via_plastimatch"), volume.space == "RAS");
  }
}

TEST(ReferenceVolumes, Nrrd) {
  const std::string folder = reference_folder() + "nrrd/";
  const std::vector<std::string> names = files_in(folder);
  if (names.empty()) GTEST_SKIP() << "no reference files in " << folder;
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const JsonValue truth = *test::parse_json(test::get(folder + name + ".truth.json"));
    if (name.find("bz2") != std::string::npos || name.find("bzip2") != std::string::npos) {
      expect_refused(folder + name, "save them in gzip");
      continue;
    }
    if (name.find("minus_five") != std::string::npos) {
      expect_refused(folder + name, "'-5' is neither");
      continue;
    }
    const Result<FileSummary> summary = inspect(folder + name);
    ASSERT_TRUE(summary.ok()) << to_string(summary.error());
    EXPECT_EQ(summary->format, "nrrd");
    const VolumeSummary& volume = *summary->volume;
    if (truth.has("sizes")) {
      EXPECT_EQ(as_numbers(volume.size), numbers_of(truth.at("sizes")));
    }
    if (truth.at("dtype").kind == JsonValue::Kind::string) {
      EXPECT_EQ(volume.type, plain_type(truth.at("dtype").string));
    }
    // Where pynrrd fails, and the truth was taken from the file that this one was made of, there is
    // but the labels to compare.
    expect_nrrd_place(volume, truth);
    expect_labels(volume, truth.at("labels"));
    expect_segments(volume, truth.at("segments"));
    expect_stacks(folder + name, volume);
  }
}

TEST(ReferenceVolumes, MetaImage) {
  const std::string folder = reference_folder() + "metaimage/";
  const std::vector<std::string> names = files_in(folder);
  if (names.empty()) GTEST_SKIP() << "no reference files in " << folder;
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const JsonValue truth = *test::parse_json(test::get(folder + name + ".truth.json"));
    const Result<FileSummary> summary = inspect(folder + name);
    ASSERT_TRUE(summary.ok()) << to_string(summary.error());
    EXPECT_EQ(summary->format, "metaimage");
    const VolumeSummary& volume = *summary->volume;
    EXPECT_EQ(as_numbers(volume.size), numbers_of(truth.at("dims")));
    EXPECT_EQ(volume.type, plain_type(truth.at("dtype").string));
    EXPECT_EQ(volume.space, "LPS");
    const std::vector<double> spacing = numbers_of(truth.at("spacing"));
    const std::vector<double> offset = numbers_of(truth.at("offset"));
    for (std::size_t axis = 0; axis < spacing.size(); ++axis) {
      EXPECT_EQ(volume.spacing[axis], spacing[axis]);
      EXPECT_EQ(volume.matrix[axis][3], offset[axis]);
      for (std::size_t row = 0; row < spacing.size(); ++row) {
        const double direction =
            truth.at("axis_direction_rows").array.at(axis).array.at(row).number;
        EXPECT_EQ(volume.matrix[row][axis], direction * spacing[axis]);
      }
    }
    if (spacing.size() == 3) expect_itk(volume, truth.at("itk_5.2_via_plastimatch"), false);
    expect_labels(volume, truth.at("labels"));
    expect_stacks(folder + name, volume);
  }
}

}  // namespace
}  // namespace tetloft
