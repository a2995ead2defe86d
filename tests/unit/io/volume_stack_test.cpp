// From a volume to a stack: where slices lie, across which axis, and of which voxels.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <tetloft/frame.hpp>
#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/prng.hpp"
#include "io/volume/stack_of_volume.hpp"
#include "support/memory_volume.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::MemoryVolume;
using Columns = std::array<std::array<double, 3>, 3>;

Result<ReadStack> read_of(MemoryVolume& volume, const ReadOptions& options) {
  Result<io::StackOfFile> made = io::stack_of_volume(volume, "file", options);
  if (!made) return made.error();
  return std::move(made->read);
}

ReadOptions structure(const std::string& name) {
  ReadOptions options;
  options.structure = name;
  return options;
}

std::string refusal(MemoryVolume& volume, const ReadOptions& options,
                    ErrorCode code = ErrorCode::usage) {
  const Result<ReadStack> read = read_of(volume, options);
  if (read) return "read";
  EXPECT_EQ(read.error().code, code);
  EXPECT_EQ(read.error().where.file, "file");
  return read.error().message;
}

// A few voxels, no two of which are mirrored or exchanged.
MemoryVolume lopsided() {
  MemoryVolume volume({5, 6, 7});
  for (const auto& [i, j, k] : {std::array<std::size_t, 3>{1, 1, 1},
                                {2, 1, 1},
                                {2, 2, 1},
                                {2, 2, 2},
                                {2, 3, 4},
                                {4, 5, 6}}) {
    volume.at(i, j, k) = 1;
  }
  return volume;
}

// Where the centre of a voxel lies by the matrix.
Point3 world_of(const MemoryVolume& volume, double i, double j, double k) {
  const auto& m = volume.header().matrix;
  const auto row = [&](std::size_t r) { return m[r][0] * i + m[r][1] * j + m[r][2] * k + m[r][3]; };
  return {row(0), row(1), row(2)};
}

double distance(const Point3& a, const Point3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

// Every voxel of the label is the middle of a diamond or a part of a larger contour: here the mean
// of each section's vertices, weighted by area, would do; of single voxels it is the centre.
std::vector<Point3> lone_voxels(const ReadStack& read) {
  std::vector<Point3> centres;
  for (const Section& section : read.stack.sections) {
    for (const Contour& contour : section.contours) {
      if (contour.vertices.size() != 4) continue;
      Point3 sum{0, 0, section.z};
      for (const Point2& v : contour.vertices) sum.x += v.x / 4, sum.y += v.y / 4;
      centres.push_back(place(read.stack.frame, sum));
    }
  }
  return centres;
}

std::vector<std::pair<double, double>> sorted_vertices(const Section& section) {
  std::vector<std::pair<double, double>> all;
  for (const Contour& contour : section.contours) {
    for (const Point2& v : contour.vertices) all.emplace_back(v.x, v.y);
  }
  std::sort(all.begin(), all.end());
  return all;
}

const std::vector<Columns> kAligned{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},      {{{-0.5, 0, 0}, {0, -0.5, 0}, {0, 0, 3}}},
    {{{0, 0, 2}, {0.75, 0, 0}, {0, 1.5, 0}}}, {{{0, -2, 0}, {0, 0, 1.25}, {-1, 0, 0}}},
    {{{0, 3, 0}, {1, 0, 0}, {0, 0, -2}}},
};
const std::vector<Columns> kOblique{
    {{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 2}}},
    {{{0.8, 0.6, 0}, {0.6, -0.8, 0}, {0, 0, 2}}},
    {{{1, 0.1, 0}, {0, 2, 0.3}, {-0.2, 0, 1.5}}},
    {{{-1, 0.1, 0}, {0, 2, 0.3}, {-0.2, 0, 1.5}}},
};

TEST(VolumeStack, VoxelsLieWhereTheMatrixPutsThem) {
  for (const bool oblique : {false, true}) {
    for (const Columns& columns : oblique ? kOblique : kAligned) {
      MemoryVolume volume({5, 6, 7});
      volume.at(1, 2, 3) = volume.at(4, 5, 6) = volume.at(3, 0, 2) = 1;
      volume.set_axes(columns, {10, -20, 30});
      for (const int axis : {0, 1, 2}) {
        ReadOptions options;
        options.axis = axis;
        const Result<ReadStack> read = read_of(volume, options);
        ASSERT_TRUE(read.ok()) << to_string(read.error());
        const auto& [x, y, z] = read->stack.frame.axes;
        EXPECT_EQ(orient3d({}, x, y, z), Sign::positive);
        EXPECT_EQ(is_exact(read->stack.frame), !oblique);
        const std::vector<Point3> centres = lone_voxels(*read);
        ASSERT_EQ(centres.size(), 3U);
        for (const auto& voxel : {Point3{1, 2, 3}, Point3{4, 5, 6}, Point3{3, 0, 2}}) {
          double nearest = 1e9;
          for (const Point3& c : centres) {
            nearest = std::min(nearest, distance(c, world_of(volume, voxel.x, voxel.y, voxel.z)));
          }
          EXPECT_LT(nearest, oblique ? 1e-13 * 50 : 1e-300);
        }
      }
    }
  }
}

TEST(VolumeStack, CoordinatesOfAlignedAxesAreThoseOfTheWorld) {
  MemoryVolume volume({4, 4, 4});
  volume.fill([](auto i, auto, auto) { return i == 0 ? 0.0 : 1.0; });
  volume.set_axes({{{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, -0.7}}}, {0.3, 0, 100});
  const Result<ReadStack> read = read_of(volume, {});
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->stack.frame, Frame{});
  ASSERT_EQ(read->stack.sections.size(), 4U);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(read->stack.sections[SectionId(3 - k)].z, 100 + k * -0.7);
  }
}

TEST(VolumeStack, EmptySlicesAreLeftOutAtTheEndsAndKeptBetween) {
  MemoryVolume volume({3, 3, 9});
  volume.at(1, 1, 2) = volume.at(1, 1, 5) = 7;
  const Result<ReadStack> read = read_of(volume, {});
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->stack.sections.size(), 4U);
  EXPECT_EQ(read->stack.sections[SectionId(0)].z, 2);
  EXPECT_EQ(read->stack.sections[SectionId(3)].z, 5);
  EXPECT_TRUE(read->stack.sections[SectionId(1)].contours.empty());
}

// Slices across an axis are those of the volume with its axes exchanged.
TEST(VolumeStack, AxesMayBeExchanged) {
  Prng prng(8);
  MemoryVolume volume({6, 7, 8});
  volume.fill([&](auto, auto, auto) { return static_cast<double>(prng.below(3)); });
  for (const std::size_t axis : {0U, 1U}) {
    // With axis as the last one; the cycle keeps the handedness.
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    MemoryVolume turned(
        {volume.header().size[a], volume.header().size[b], volume.header().size[axis]});
    turned.fill([&](auto i, auto j, auto k) {
      std::array<std::size_t, 3> at{};
      at[a] = i, at[b] = j, at[axis] = k;
      return volume.at(at[0], at[1], at[2]);
    });
    for (const auto way : {VolumeContours::sub_pixel, VolumeContours::lattice}) {
      ReadOptions options = structure("1");
      options.contours = way;
      const Result<ReadStack> expected = read_of(turned, options);
      options.axis = static_cast<int>(axis);
      const Result<ReadStack> got = read_of(volume, options);
      ASSERT_TRUE(expected.ok() && got.ok());
      ASSERT_EQ(got->stack.sections.size(), expected->stack.sections.size());
      EXPECT_EQ(got->stack.vertex_count(), expected->stack.vertex_count());
      EXPECT_EQ(got->stack.contour_count(), expected->stack.contour_count());
      for (SectionId s(0); s < got->stack.sections.end_id(); s = SectionId(s.index() + 1)) {
        EXPECT_EQ(sorted_vertices(got->stack.sections[s]),
                  sorted_vertices(expected->stack.sections[s]));
      }
    }
  }
}

TEST(VolumeStack, ManySlicesAcrossOtherAxesAreReadInPasses) {
  MemoryVolume volume({400, 1, 100'000});
  volume.piece = 50'000;
  volume.at(3, 0, 5) = volume.at(399, 0, 99'999) = 1;
  ReadOptions options = structure("1");
  options.axis = 0;
  const Result<ReadStack> read = read_of(volume, options);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.sections.size(), 397U);
  EXPECT_EQ(read->stack.contour_count(), 2U);
  EXPECT_EQ(volume.readings, 3U);
  EXPECT_EQ(lone_voxels(*read).back(), (Point3{399, 0, 99'999}));
}

TEST(VolumeStack, CoordinatesThatAreNotToldApartAreRefused) {
  MemoryVolume volume = lopsided();
  volume.set_axes({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 1e15, 0});
  EXPECT_EQ(refusal(volume, {}, ErrorCode::invalid_input),
            "double precision does not tell the voxels along axis 1 apart: they are 1 from each "
            "other, and begin at 1e+15");
}

TEST(VolumeStack, TheOnlyLabelNeedsNoName) {
  MemoryVolume volume = lopsided();
  EXPECT_TRUE(read_of(volume, {}).ok());
  MemoryVolume empty({2, 2, 2});
  EXPECT_EQ(refusal(empty, {}, ErrorCode::invalid_input), "all voxels of the volume are 0");
}

TEST(VolumeStack, SeveralLabelsAreListed) {
  MemoryVolume volume = lopsided();
  volume.at(0, 0, 0) = 12;
  EXPECT_EQ(refusal(volume, {}),
            "the volume has several labels: 1 (6 voxels), 12 (1 voxel); choose one with --label N, "
            "or --label all; of an image, --iso VALUE");
  EXPECT_EQ(read_of(volume, structure("12"))->stack.contour_count(), 1U);
  EXPECT_EQ(refusal(volume, structure("7")),
            "no voxel has the value 7; there is 1 (6 voxels), 12 (1 voxel)");
  EXPECT_EQ(
      refusal(volume, structure("liver")),
      "the labels of this file have no names, of which 'liver' could be one: choose by value");
  volume.edit().segments = {{1, "Liver", 0}, {12, "left lung", 0}, {13, "spleen", 0}};
  EXPECT_EQ(refusal(volume, {}),
            "the volume has several labels: 1 'Liver' (6 voxels), 12 'left lung' (1 voxel); choose "
            "one with --label N|NAME, or --label all; of an image, --iso VALUE");
  EXPECT_EQ(read_of(volume, structure("LIVER"))->stack.about.name, "Liver");
  EXPECT_EQ(read_of(volume, structure("12"))->stack.about.name, "left lung");
  EXPECT_EQ(refusal(volume, structure("livre")),
            "there is no single segment 'livre' (did you mean Liver?); there is 1 'Liver', "
            "12 'left lung', 13 'spleen'");
  EXPECT_EQ(refusal(volume, structure("spleen"), ErrorCode::invalid_input),
            "the segment 'spleen' has no voxels");
}

TEST(VolumeStack, ImagesAskForAnIsoValue) {
  MemoryVolume volume = lopsided();
  volume.at(0, 0, 0) = -0.5;
  EXPECT_EQ(refusal(volume, {}),
            "the volume is an image, with values from -0.5 to 1: choose the region of values from "
            "VALUE on with --iso VALUE");
  ReadOptions options;
  options.iso = 2;
  EXPECT_EQ(refusal(volume, options, ErrorCode::invalid_input),
            "no voxel has a value of at least 2; they are from -0.5 to 1");
  options.structure = "1";
  EXPECT_EQ(refusal(volume, options), "a label and an iso-value exclude each other");
}

TEST(VolumeStack, OfSeveralVolumesOneIsChosen) {
  MemoryVolume volume({3, 3, 3}, 4);
  volume.at(1, 1, 1, 1) = 1;
  volume.at(1, 1, 1, 2) = 1;
  volume.at(0, 0, 0, 2) = 5;
  const std::string which =
      "the file holds 4 volumes: choose one with --label N, from 1 to 4, of a label volume also "
      "--label N:VALUE, of an image with --iso VALUE";
  EXPECT_EQ(refusal(volume, {}), which);
  EXPECT_EQ(read_of(volume, structure("2"))->stack.contour_count(), 1U);
  EXPECT_EQ(
      refusal(volume, structure("3")),
      "volume 3 has several labels: 1 (1 voxel), 5 (1 voxel); choose one with --label 3:N, or "
      "--label all; of an image, --iso VALUE");
  EXPECT_EQ(read_of(volume, structure("3:5"))->stack.sections[SectionId(0)].z, 0);
  EXPECT_EQ(refusal(volume, structure("1"), ErrorCode::invalid_input),
            "all voxels of volume 1 are 0");
  EXPECT_EQ(refusal(volume, structure("5")), "there is no single structure '5'; " + which);
  ReadOptions options = structure("3");
  options.iso = 1;
  EXPECT_EQ(read_of(volume, options)->stack.contour_count(), 2U);
  options.structure = "";
  EXPECT_EQ(refusal(volume, options), which);
  const Result<FileSummary> summary = io::summary_of_volume(volume, {});
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->volume->structures, (std::vector<std::string>{"2:1", "3:1", "3:5"}));
}

TEST(VolumeStack, SegmentsOfSeveralVolumesOverlap) {
  MemoryVolume volume({3, 3, 3}, 2);
  volume.at(1, 1, 1, 0) = 1;
  volume.at(1, 1, 2, 0) = 2;
  volume.at(1, 1, 1, 1) = 1;
  volume.edit().segments = {{1, "a", 0}, {1, "b", 1}, {2, "c", 0}};
  EXPECT_EQ(
      refusal(volume, {}),
      "the file has several segments: 1 'a' in volume 1, 1 'b' in volume 2, 2 'c' in volume 1; "
      "choose one with --label N|NAME, or --label all");
  for (const char* name : {"a", "b", "c"}) {
    const Result<ReadStack> read = read_of(volume, structure(name));
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->stack.about.name, name);
    EXPECT_EQ(read->stack.sections[SectionId(0)].z, *name == 'c' ? 2 : 1);
  }
  const Result<FileSummary> summary = io::summary_of_volume(volume, {});
  ASSERT_TRUE(summary.ok());
  const auto& labels = summary->volume->labels;
  ASSERT_EQ(labels.size(), 4U);
  EXPECT_EQ(labels[0].voxels, 51U);
  EXPECT_EQ(labels[1].name + labels[2].name + labels[3].name, "abc");
  EXPECT_EQ(summary->volume->structures, (std::vector<std::string>{"a", "c", "b"}));
}

TEST(VolumeStack, NamesThatMisleadAreReplacedByNumbers) {
  MemoryVolume volume({3, 1, 1});
  volume.at(0, 0, 0) = 1;
  volume.at(1, 0, 0) = 2;
  volume.at(2, 0, 0) = 3;
  volume.edit().segments = {{1, "2", 0}, {2, "same", 0}, {3, "same", 0}};
  const Result<FileSummary> summary = io::summary_of_volume(volume, {});
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->volume->structures, (std::vector<std::string>{"2", "1:2", "3"}));
  for (std::size_t i = 0; i < 3; ++i) {
    const Result<ReadStack> read = read_of(volume, structure(summary->volume->structures[i]));
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(lone_voxels(*read).front().x, static_cast<double>(i));
  }
}

TEST(VolumeSummary, CountsLabels) {
  MemoryVolume volume = lopsided();
  volume.at(0, 0, 0) = -3;
  volume.at(0, 0, 1) = 1e9;
  const Result<FileSummary> summary = io::summary_of_volume(volume, {});
  ASSERT_TRUE(summary.ok());
  const VolumeSummary& v = *summary->volume;
  EXPECT_EQ(v.size, (std::vector<std::size_t>{5, 6, 7}));
  EXPECT_FALSE(v.intensities);
  EXPECT_EQ(v.least, -3);
  EXPECT_EQ(v.largest, 1e9);
  ASSERT_EQ(v.labels.size(), 4U);
  EXPECT_EQ(v.labels[1].value, 0);
  EXPECT_EQ(v.labels[1].voxels, 210U - 8U);
  EXPECT_EQ(v.labels[2].voxels, 6U);
}

TEST(VolumeSummary, OfAnImageHasARange) {
  MemoryVolume volume({50, 50, 50});
  volume.fill([](auto i, auto j, auto k) { return static_cast<double>(i * j * k) / 8; });
  const Result<FileSummary> summary = io::summary_of_volume(volume, {});
  ASSERT_TRUE(summary.ok());
  EXPECT_TRUE(summary->volume->intensities);
  EXPECT_TRUE(summary->volume->labels.empty());
  EXPECT_EQ(summary->volume->largest, 49 * 49 * 49 / 8.0);
}

TEST(VolumeSummary, InfinityIsNoLabel) {
  MemoryVolume volume = lopsided();
  volume.at(0, 0, 0) = std::numeric_limits<double>::infinity();
  const Result<FileSummary> summary = io::summary_of_volume(volume, {});
  ASSERT_TRUE(summary.ok());
  EXPECT_TRUE(summary->volume->structures.empty());
  EXPECT_NE(refusal(volume, {}).find("is an image"), std::string::npos);
}

TEST(VolumeStack, IsWatchedAndStopped) {
  MemoryVolume volume = lopsided();
  ReadOptions options;
  std::vector<std::size_t> done;
  options.execution.progress = [&](std::size_t steps, std::size_t all) {
    done.push_back(steps);
    EXPECT_EQ(all, 14U);
  };
  ASSERT_TRUE(read_of(volume, options).ok());
  ASSERT_EQ(done.size(), 14U);
  EXPECT_EQ(done.back(), 14U);
  std::stop_source stop;
  stop.request_stop();
  options.execution.progress = {};
  options.execution.stop = stop.get_token();
  EXPECT_THROW(static_cast<void>(read_of(volume, options)), Cancelled);
}

}  // namespace
}  // namespace tetloft
