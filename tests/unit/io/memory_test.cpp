// What readers take of memory, over files made to take much: counted by this program's own
// allocation functions.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "io/bytes/deflate.hpp"
#include "io/files.hpp"
#include "unit/io/io_support.hpp"
#include "unit/io/memory_support.hpp"

namespace tetloft {

using namespace internal;
using test::expect_bounded;
using test::Family;
using test::kSize;
using test::peak_of;
using test::repeated;
namespace {

std::vector<Family> stacks() {
  std::vector<Family> families;
  const std::string head = "S 1\nv 3 z 0\n";
  for (const char* piece :
       {"{}", "{ }", "{0}", "{0 0}", "{0 0 0}", "{0 0 0 0}", "{0 0 1 0 0 1}", "{1 0 0}", "{",
        "{0 0 0 0 0 0}", "{0 1 1 0 0 0 1 0 0}", "0 ", "#\n", "# {{{{{{ v v v\n", "{,}", "v "}) {
    families.push_back({piece, repeated(piece, kSize, head)});
  }
  for (const char* piece : {"v0 z0\n", "v 1 z 0\n", "v1 z0{}", "v3 z0{0 0 1 0 0 1}"}) {
    families.push_back({piece, repeated(piece, kSize, "S 1\n")});
  }
  // Valid, with as little text for each vertex and each contour as can be.
  std::string triangles = "S 1\nv 0 z 0\n";
  for (int i = 0; triangles.size() < kSize; ++i) {
    const std::string y = std::to_string(2 * i);
    const std::string above = std::to_string(2 * i + 1);
    triangles += "{0 " + y + " 1 " + y + " 0 " + above + "}";
  }
  families.push_back({"triangles", triangles});
  std::string heights = "S 0\n";
  for (int i = 0; heights.size() < kSize; ++i) heights += "v1 z" + std::to_string(i) + "{}";
  families.push_back({"heights", heights});
  families.push_back({"long contour", repeated("0 1 ", kSize, head + "{", "}")});
  families.push_back({"triples", repeated("1 2 0 ", kSize, head + "{", "}")});
  families.push_back({"long token", head + "{ " + std::string(kSize, '7') + " 0}"});
  families.push_back({"long word", std::string(kSize, 'S')});
  families.push_back({"huge counts", "S 1e300\n" + repeated("v 1e300 z 0\n", kSize)});
  families.push_back({"line feeds", std::string(kSize, '\n')});
  families.push_back({"zeros", std::string(kSize, '\0')});
  return families;
}

TEST(Memory, OfStacksIsBounded) {
  for (const Validity validity : {Validity::required, Validity::unchecked}) {
    expect_bounded(stacks(), [&](const std::string& bytes) {
      static_cast<void>(parse_cnt(bytes, "a.cnt", validity));
    });
  }
}

TEST(Memory, OfLabelsAndPointsIsBounded) {
  const std::vector<Family> families{
      {"rows", repeated("0 0 0\n", kSize)},    {"decisions", repeated("join 0 0 0\n", kSize)},
      {"comments", repeated("#\n", kSize)},    {"long line", repeated("0 ", kSize)},
      {"long token", std::string(kSize, '0')}, {"zeros", std::string(kSize / 24 * 24, '\0')}};
  expect_bounded(families, [](const std::string& bytes) {
    static_cast<void>(parse_labels(bytes, "a.txt"));
    static_cast<void>(parse_points(bytes, "a.txt"));
    static_cast<void>(parse_points(bytes, "a.bin"));
  });
}

std::vector<Family> volumes() {
  std::vector<Family> families;
  const std::string side = std::to_string(kSize / 400);
  const std::string nrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 20 20 " + side + "\n";
  const std::string raw = nrrd + "encoding: raw\n\n";
  families.push_back({"boards", repeated(std::string("\0\1", 2), kSize, raw)});
  families.push_back({"ones", repeated("\1", kSize, raw)});
  std::string noise = raw;
  for (std::size_t i = 0; i < kSize; ++i) noise += static_cast<char>(i * i * 2654435761U >> 13);
  families.push_back({"noise", noise});
  families.push_back({"lone pixels", repeated(std::string("\0\1", 2), kSize,
                                              "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 633 631 "
                                              "1\nencoding: raw\n\n")});
  families.push_back({"doubles", repeated("00000000", kSize,
                                          "NRRD0004\ntype: double\ndimension: 3\nsizes: 20 20 100\n"
                                          "endian: big\nencoding: raw\n\n")});
  families.push_back({"text", repeated("0 1 ", kSize,
                                       "NRRD0004\ntype: int\ndimension: 3\nsizes: 20 20 500\n"
                                       "encoding: ascii\n\n")});
  std::string keys = nrrd;
  for (int i = 0; keys.size() < kSize; ++i) keys += std::to_string(i) + ":=\n";
  families.push_back({"keys", keys});
  std::string segments = nrrd;
  for (int i = 0; segments.size() < kSize; ++i) {
    segments += "Segment" + std::to_string(i) + "_Name:=\n";
  }
  families.push_back({"segments", segments + "encoding: raw\n\n"});
  families.push_back({"names", repeated("a\n", kSize, nrrd + "encoding: raw\ndata file: LIST\n")});
  families.push_back({"long line", nrrd + std::string(kSize, 'a')});
  std::string fields = "NDims = 3\n";
  for (int i = 0; fields.size() < kSize; ++i) fields += std::to_string(i) + "=\n";
  families.push_back({"fields", fields});
  return families;
}

TEST(Memory, OfVolumesIsBounded) {
  for (const int axis : {0, 2}) {
    for (const auto way : {VolumeContours::sub_pixel, VolumeContours::lattice}) {
      expect_bounded(
          volumes(),
          [&](const std::string& bytes) {
            ReadOptions options;
            options.axis = axis;
            options.contours = way;
            options.structure = "1";
            static_cast<void>(parse_stack(bytes, "a.nrrd", options));
            options.structure = {};
            options.iso = 48;
            static_cast<void>(parse_stack(bytes, "a.nrrd", options));
          },
          kVolumeMultiple);
    }
  }
  expect_bounded(volumes(), [](const std::string& bytes) {
    static_cast<void>(inspect_bytes(bytes, "a.nrrd"));
  });
}

// Whatever a small file unpacks to, a slice is in memory, and what contours there are.
TEST(Memory, OfPackedVolumesIsThatOfASlice) {
  const std::string zeros = io::zlib_compressed(std::string(std::size_t{64} << 20, '\0'));
  const auto header = [](const char* sizes) {
    return "NDims = 3\nDimSize = " + std::string(sizes) +
           "\nElementType = MET_UCHAR\nCompressedData = True\nElementDataFile = LOCAL\n";
  };
  for (const char* sizes : {"256 256 1024", "16 16 262144"}) {
    const std::string bytes = header(sizes) + zeros;
    const std::size_t peak = peak_of([&] {
      const auto summary = inspect_bytes(bytes, "a.mha");
      ASSERT_TRUE(summary.ok());
      EXPECT_EQ(summary->volume->labels.at(0).voxels, std::size_t{64} << 20);
      EXPECT_FALSE(parse_stack(bytes, "a.mha").ok());
    });
    EXPECT_LE(peak, kReaderBytes) << sizes;
  }
  // A large slice is announced, and not there.
  const std::string cut = header("8192 8192 1") + zeros.substr(0, zeros.size() - 1000);
  const std::size_t peak = peak_of([&] { EXPECT_FALSE(parse_stack(cut, "a.mha").ok()); });
  EXPECT_LE(peak, std::size_t{4} * 8192 * 8192);
}

TEST(Memory, OfAVolumeInAFileIsThatOfASlice) {
  test::TempFolder folder;
  std::string bytes = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 200 200 500\nencoding: raw\n\n";
  bytes.resize(bytes.size() + 200 * 200 * 500);
  bytes[bytes.size() - 100'000] = 1;
  test::put(folder.file("a.nrrd"), bytes);
  const std::size_t peak = peak_of([&] { EXPECT_TRUE(read_stack(folder.file("a.nrrd")).ok()); });
  EXPECT_LE(peak, kReaderBytes);
}

TEST(Memory, OfAWholeFileIsItsSize) {
  test::TempFolder folder;
  test::put(folder.file("a"), std::string(5'000'000, 'x'));
  const std::size_t bytes = peak_of([&] { EXPECT_TRUE(io::read_file(folder.file("a")).ok()); });
  EXPECT_LE(bytes, 5'100'000U);
}

TEST(Memory, OfAStreamEndsAtItsLimit) {
  const io::ReadLimits limits{1U << 20, 1U << 20};
  const std::size_t bytes = peak_of([&] {
    const auto read = io::read_file("/dev/zero", limits);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::io);
    EXPECT_NE(read.error().message.find("1 MiB"), std::string::npos) << read.error().message;
  });
  EXPECT_LE(bytes, (std::size_t{3} << 20) + 16384);
}

}  // namespace
}  // namespace tetloft
