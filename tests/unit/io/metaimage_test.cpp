// MetaImages made here.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "support/deflated.hpp"
#include "support/volume_files.hpp"
#include "unit/io/volume_formats_support.hpp"

namespace tetloft {
namespace {

using namespace test;

const std::string kBytes = samples_of<std::uint8_t>(kFewVoxels);

std::string header_of(const std::string& fields, const std::string& type = "MET_UCHAR",
                      const std::string& sizes = "3 2 2", const std::string& file = "LOCAL") {
  return "ObjectType = Image\nNDims = " +
         std::to_string(std::count(sizes.begin(), sizes.end(), ' ') + 1) + "\n" + fields +
         "DimSize = " + sizes + "\nElementType = " + type + "\nElementDataFile = " + file + "\n";
}

Result<FileSummary> look_at(const std::string& bytes) { return inspect_bytes(bytes, "file.mha"); }
Result<FileSummary> few(const std::string& fields) { return look_at(header_of(fields) + kBytes); }

template <class Number>
void expect_type(const std::string& element, const char* name) {
  for (const bool big : {false, true}) {
    const std::string order = big ? "BinaryDataByteOrderMSB = True\n" : "ElementByteOrderMSB = F\n";
    const auto summary = look_at(header_of(order, element) + samples_of<Number>(kFewVoxels, big));
    EXPECT_EQ(labels_of(summary), kFewLabels) << element;
    ASSERT_TRUE(summary.ok());
    EXPECT_EQ(summary->format, "metaimage");
    EXPECT_EQ(summary->volume->type, name);
    EXPECT_EQ(summary->volume->space, "LPS");
  }
}

TEST(MetaImage, TypesAndByteOrders) {
  expect_type<std::int8_t>("MET_CHAR", "int8");
  expect_type<std::uint8_t>("MET_UCHAR", "uint8");
  expect_type<std::int16_t>("MET_SHORT", "int16");
  expect_type<std::uint16_t>("MET_USHORT", "uint16");
  expect_type<std::int32_t>("MET_INT", "int32");
  expect_type<std::uint32_t>("MET_UINT", "uint32");
  expect_type<std::int32_t>("MET_LONG", "int32");
  expect_type<std::uint32_t>("MET_ULONG", "uint32");
  expect_type<std::int64_t>("MET_LONG_LONG", "int64");
  expect_type<std::uint64_t>("MET_ULONG_LONG", "uint64");
  expect_type<float>("MET_FLOAT", "float32");
  expect_type<double>("MET_DOUBLE", "float64");
  EXPECT_EQ(refusal_of(look_at(header_of("", "MET_FLOAT_ARRAY"))),
            "voxels of type 'MET_FLOAT_ARRAY' are not read");
}

TEST(MetaImage, CompressedAndText) {
  const std::string compressed = "BinaryData = True\nCompressedData = True\n";
  EXPECT_EQ(
      labels_of(look_at(header_of(compressed + "CompressedDataSize = 23\n") + zlibbed(kBytes))),
      kFewLabels);
  EXPECT_EQ(labels_of(look_at(header_of(compressed) + gzipped(kBytes))), kFewLabels);
  EXPECT_EQ(labels_of(look_at(header_of("BinaryData = False\n", "MET_FLOAT") +
                              "0 1 1 0 1 0 1 1 0 0 0 7\n")),
            kFewLabels);
}

TEST(MetaImage, Places) {
  EXPECT_EQ(matrix_of(few("")), "1 0 0 0 | 0 1 0 0 | 0 0 1 0");
  for (const char* origin : {"Offset", "Position", "Origin"}) {
    for (const char* matrix : {"TransformMatrix", "Rotation", "Orientation"}) {
      for (const char* spacing : {"ElementSpacing", "ElementSize"}) {
        EXPECT_EQ(matrix_of(few(std::string(matrix) + " = 0 1 0 -1 0 0 0 0.5 1\n" + origin +
                                " = 5 6 7\n" + spacing + " = 2 3 4\nCenterOfRotation = 9 9 9\n")),
                  "0 -3 0 5 | 2 0 2 6 | 0 0 4 7");
      }
    }
  }
  // Both are in some files: where voxels lie is what counts.
  EXPECT_EQ(matrix_of(few("ElementSize = 9 9 9\nElementSpacing = 2 3 4\n")),
            "2 0 0 0 | 0 3 0 0 | 0 0 4 0");
  EXPECT_NE(refusal_of(few("TransformMatrix = 1 0 0 2 0 0 0 0 1\n")).find("singular"),
            std::string::npos);
  EXPECT_NE(refusal_of(few("Offset = 1 2\n")).find("offset has 2 numbers"), std::string::npos);
  EXPECT_NE(refusal_of(few("Offset = 1 2 x\n")).find("'x' is not a number"), std::string::npos);
}

TEST(MetaImage, DataInFilesBeside) {
  TempFolder folder;
  put(folder.file("all (1, 2).raw"), kBytes);
  put(folder.file("s01.raw"), kBytes.substr(0, 6));
  put(folder.file("s02.raw"), kBytes.substr(6));
  put(folder.file("headed.raw"), "head" + kBytes);
  put(folder.file("all.zraw"), zlibbed(kBytes));
  for (int row = 0; row < 4; ++row) {
    put(folder.file("r" + std::to_string(row)),
        kBytes.substr(static_cast<std::size_t>(3 * row), 3));
  }
  const auto with = [&](const std::string& file, const std::string& fields = "") {
    put(folder.file("file.mhd"), header_of(fields, "MET_UCHAR", "3 2 2", file));
    return inspect(folder.file("file.mhd"));
  };
  for (const char* file :
       {"all (1, 2).raw", "/gone/all (1, 2).raw", "C:\\gone\\all (1, 2).raw", "s%02d.raw 1 2 1",
        "LIST\ns01.raw\ns02.raw", "LIST 2\r\ns01.raw\r\ns02.raw", "LIST 1\nr0\nr1\nr2\nr3",
        "LIST 3\nall (1, 2).raw"}) {
    EXPECT_EQ(labels_of(with(file)), kFewLabels) << file;
  }
  EXPECT_EQ(labels_of(with("headed.raw", "HeaderSize = -1\n")), kFewLabels);
  EXPECT_EQ(labels_of(with("headed.raw", "HeaderSize = 4\n")), kFewLabels);
  EXPECT_EQ(labels_of(with("all.zraw", "CompressedData = True\n")), kFewLabels);
  EXPECT_NE(refusal_of(with("headed.raw", "HeaderSize = -2\n")).find("HeaderSize"),
            std::string::npos);
  EXPECT_NE(refusal_of(with("LIST\ns01.raw")).find("1 files are named, where DimSize asks for 2"),
            std::string::npos);
  EXPECT_NE(refusal_of(with("absent.raw")).find("is not there"), std::string::npos);
  EXPECT_NE(refusal_of(with("s%02d.raw 1 2 0")).find("do not go"), std::string::npos);
}

TEST(MetaImage, ChannelsAndDimensions) {
  EXPECT_EQ(labels_of(look_at(header_of("", "MET_UCHAR", "3 4") + kBytes)), kFewLabels);
  const auto channels =
      look_at(header_of("ElementNumberOfChannels = 2\n", "MET_UCHAR", "3 1 2") + kBytes);
  EXPECT_EQ(labels_of(channels), kFewLabels);
  EXPECT_EQ(channels->volume->structures, (std::vector<std::string>{"1:1", "2:1", "2:7"}));
  const auto four = look_at(
      header_of("ElementSpacing = 1 1 2 1\nOffset = 0 0 5 0\n", "MET_UCHAR", "3 1 2 2") + kBytes);
  EXPECT_EQ(matrix_of(four), "1 0 0 0 | 0 1 0 0 | 0 0 2 5");
  EXPECT_EQ(four->volume->size, (std::vector<std::size_t>{3, 1, 2, 2}));
}

TEST(MetaImage, WrongHeaders) {
  EXPECT_EQ(few("nonsense\n").error().where.line, 3U);
  EXPECT_NE(refusal_of(look_at("NDims = 3\n")).find("no ElementDataFile"), std::string::npos);
  EXPECT_NE(refusal_of(look_at("NDims = 3\nElementDataFile = LOCAL\n")).find("no ElementType"),
            std::string::npos);
  EXPECT_NE(refusal_of(look_at(header_of("") + kBytes.substr(1))).find("cut off"),
            std::string::npos);
  EXPECT_NE(refusal_of(look_at(header_of("", "MET_UCHAR", "3 0 2"))).find("'0' is no size"),
            std::string::npos);
  EXPECT_NE(refusal_of(look_at(header_of("NDims = 2\n"))).find("NDims is 2"), std::string::npos);
}

}  // namespace
}  // namespace tetloft
