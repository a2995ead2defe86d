// NRRD files made here: every way to hold data, and to say where they lie.
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
const std::string kText = "0 1 1 0 1 0\n1, 1, 0 0\r\n0 7";

std::string header_of(const std::string& fields, const std::string& type = "uchar",
                      const std::string& sizes = "3 2 2", const std::string& encoding = "raw") {
  return "NRRD0004\n# a comment\ntype: " + type +
         "\ndimension: " + std::to_string(std::count(sizes.begin(), sizes.end(), ' ') + 1) +
         "\nsizes: " + sizes + "\nencoding: " + encoding + "\n" + fields;
}

Result<FileSummary> look_at(const std::string& bytes) { return inspect_bytes(bytes, "file.nrrd"); }
Result<FileSummary> few(const std::string& fields) {
  return look_at(header_of(fields) + "\n" + kBytes);
}

template <class Number>
void expect_type(const char* name, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    for (const bool big : {false, true}) {
      const auto summary = look_at(header_of(big ? "endian: big\n" : "endian: little\n", word) +
                                   "\n" + samples_of<Number>(kFewVoxels, big));
      EXPECT_EQ(labels_of(summary), kFewLabels) << word;
      ASSERT_TRUE(summary.ok());
      EXPECT_EQ(summary->volume->type, name);
    }
  }
}

TEST(Nrrd, TypesAndByteOrders) {
  expect_type<std::int8_t>("int8", {"signed char", "int8", "int8_t"});
  expect_type<std::uint8_t>("uint8", {"uchar", "unsigned char", "uint8", "uint8_t", "UCHAR"});
  expect_type<std::int16_t>(
      "int16", {"short", "short int", "signed short", "signed short int", "int16", "int16_t"});
  expect_type<std::uint16_t>(
      "uint16", {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"});
  expect_type<std::int32_t>("int32", {"int", "signed int", "int32", "int32_t"});
  expect_type<std::uint32_t>("uint32", {"uint", "unsigned int", "uint32", "uint32_t"});
  expect_type<std::int64_t>("int64", {"longlong", "long long", "long long int", "signed long long",
                                      "signed long long int", "int64", "int64_t"});
  expect_type<std::uint64_t>("uint64", {"ulonglong", "unsigned long long", "unsigned long long int",
                                        "uint64", "uint64_t"});
  expect_type<float>("float32", {"float"});
  expect_type<double>("float64", {"double"});
  EXPECT_EQ(refusal_of(look_at(header_of("", "block") + "\n")),
            "voxels of type 'block' are not read");
}

TEST(Nrrd, AMissingByteOrderIsTold) {
  const auto summary =
      look_at(header_of("", "short") + "\n" + samples_of<std::int16_t>(kFewVoxels));
  EXPECT_EQ(labels_of(summary), kFewLabels);
  EXPECT_NE(warnings_of(summary).find("byte order"), std::string::npos);
  EXPECT_EQ(warnings_of(few("")), "");
}

TEST(Nrrd, Encodings) {
  for (const char* name : {"ascii", "text", "txt", "ASCII"}) {
    EXPECT_EQ(labels_of(look_at(header_of("", "float", "3 2 2", name) + "\n" + kText)), kFewLabels);
  }
  for (const char* name : {"gzip", "gz"}) {
    EXPECT_EQ(labels_of(look_at(header_of("", "uchar", "3 2 2", name) + "\n" + gzipped(kBytes))),
              kFewLabels);
  }
  EXPECT_EQ(labels_of(look_at(header_of("endian: big\n", "short", "3 2 2", "hex") + "\n" +
                              "0000 0001 0001 0000\n 00010000 0001 0001 00000000 0000 0007\n")),
            kFewLabels);
  for (const char* name : {"bzip2", "bz2"}) {
    EXPECT_NE(refusal_of(look_at(header_of("", "uchar", "3 2 2", name) + "\n")).find("gzip"),
              std::string::npos);
  }
  EXPECT_NE(refusal_of(look_at(header_of("", "uchar", "3 2 2", "zrl") + "\n")).find("'zrl'"),
            std::string::npos);
}

TEST(Nrrd, LinesMayEndAsOnOtherSystems) {
  std::string header = header_of("key:=value\nspace : LPS\n");
  std::string other;
  for (const char c : header) other += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(labels_of(look_at(other + "\r\n" + kBytes)), kFewLabels);
}

TEST(Nrrd, VersionsAndWrongLines) {
  for (const char v : {'1', '2', '3', '4', '5'}) {
    std::string bytes = header_of("") + "\n" + kBytes;
    bytes[7] = v;
    EXPECT_EQ(labels_of(look_at(bytes)), kFewLabels);
  }
  std::string newer = header_of("") + "\n" + kBytes;
  newer[7] = '6';
  EXPECT_NE(refusal_of(look_at(newer)).find("no version"), std::string::npos);
  EXPECT_EQ(few("nonsense\n").error().where.line, 7U);
  EXPECT_NE(refusal_of(few("type: short\n")).find("two fields"), std::string::npos);
  EXPECT_NE(refusal_of(look_at("NRRD0004\n\n")).find("no type"), std::string::npos);
}

TEST(Nrrd, Skips) {
  EXPECT_EQ(labels_of(look_at(header_of("line skip: 2\nbyte skip: 3\n") + "\na\nb\nabc" + kBytes)),
            kFewLabels);
  EXPECT_EQ(labels_of(look_at(header_of("byteskip: -1\n") + "\nwhatever" + kBytes)), kFewLabels);
  EXPECT_EQ(labels_of(look_at(header_of("line skip: 1\nbyte skip: 2\n", "uchar", "3 2 2", "gzip") +
                              "\nline\n" + gzipped("xx" + kBytes))),
            kFewLabels);
  EXPECT_EQ(labels_of(look_at(header_of("byte skip: -1\n", "uchar", "3 2 2", "gzip") + "\n" +
                              gzipped("anything" + kBytes))),
            kFewLabels);
  EXPECT_NE(refusal_of(few("byte skip: -2\n")).find("'-2' is neither"), std::string::npos);
  EXPECT_NE(refusal_of(few("line skip: -1\n")).find("no number of lines"), std::string::npos);
}

TEST(Nrrd, DetachedData) {
  TempFolder folder;
  std::filesystem::create_directory(folder.file("inner"));
  put(folder.file("all.raw"), kBytes);
  put(folder.file("inner/with blanks (1).raw"), kBytes);
  put(folder.file("s_01.raw"), kBytes.substr(0, 6));
  put(folder.file("s_02.raw"), kBytes.substr(6));
  for (int row = 0; row < 4; ++row) {
    put(folder.file("r" + std::to_string(row)),
        kBytes.substr(static_cast<std::size_t>(3 * row), 3));
  }
  const auto with = [&](const std::string& line) {
    put(folder.file("file.nhdr"), header_of(line));
    return inspect(folder.file("file.nhdr"));
  };
  for (const char* line :
       {"data file: all.raw\n", "datafile: ./all.raw\n", "data file: inner/with blanks (1).raw\n",
        "data file: /elsewhere/all.raw\n", "data file: ../all.raw\n",
        "data file: C:\\old\\all.raw\n", "data file: s_%02d.raw 1 2 1\n",
        "data file: s_%02d.raw 1 2 1 2\n", "data file: s_%02d.raw 1 2 1 3\n",
        "data file: r%d 0 3 1 1\n", "data file: LIST\ns_01.raw\ns_02.raw\n",
        "data file: LIST 1\nr0\nr1\nr2\nr3\n", "data file: LIST 3\nall.raw\n"}) {
    EXPECT_EQ(labels_of(with(line)), kFewLabels) << line;
  }
  EXPECT_EQ(labels_of(with("data file: s_%02d.raw 2 1 -1\n")), kFewLabels);
  EXPECT_NE(refusal_of(with("data file: absent.raw\n")).find("'absent.raw' is not there"),
            std::string::npos);
  EXPECT_NE(refusal_of(with("data file: /etc/passwd\n")).find("only copies beside the header"),
            std::string::npos);
  EXPECT_NE(refusal_of(with("data file: r%d 0 3 1\n")).find("4 files of 6 samples"),
            std::string::npos);
  EXPECT_NE(refusal_of(with("data file: s_%02d.raw 1 2 0\n")).find("do not go"), std::string::npos);
  EXPECT_NE(refusal_of(with("data file: LIST\ns_01.raw\nr0\n")).find("cut off"), std::string::npos);
  EXPECT_NE(refusal_of(look_at(header_of("data file: all.raw\n"))).find("not read from a file"),
            std::string::npos);
}

TEST(Nrrd, SpacesAndDirections) {
  const auto space = [](const std::string& name) {
    const auto summary = few("space: " + name + "\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n");
    return summary.ok() ? summary->volume->space : to_string(summary.error());
  };
  EXPECT_EQ(space("left-posterior-superior"), "LPS");
  EXPECT_EQ(space("LPS"), "LPS");
  EXPECT_EQ(space("right-anterior-superior"), "RAS");
  EXPECT_EQ(space("las"), "LAS");
  EXPECT_EQ(space("scanner-xyz"), "scanner-xyz");
  EXPECT_EQ(space("3D-right-handed"), "3D-right-handed");
  EXPECT_EQ(space("3DL"), "3D-left-handed");
  EXPECT_NE(space("somewhere").find("no space that is known"), std::string::npos);
  EXPECT_EQ(matrix_of(few("space dimension: 3\nspace directions: (1,0.5,0) ( 0 , 2, 0) (0,0,-3)\n"
                          "space origin: (5,6,7)\n")),
            "1 0 0 5 | 0.5 2 0 6 | 0 0 -3 7");
  EXPECT_NE(
      refusal_of(few("space: LPS\nspace directions: (1,0,0) (2,0,0) (0,0,1)\n")).find("singular"),
      std::string::npos);
  EXPECT_NE(
      refusal_of(few("space: LPS\nspace directions: (1,0,0) (2,0) (0,0,1)\n")).find("'(2,0)'"),
      std::string::npos);
  EXPECT_NE(refusal_of(few("space directions: (1,0,0) (0,1,0) (0,0,1)\n")).find("no space"),
            std::string::npos);
}

TEST(Nrrd, SpacingsAndAxisMins) {
  EXPECT_EQ(matrix_of(few("spacings: 0.5 2 3\n")), "0.5 0 0 0 | 0 2 0 0 | 0 0 3 0");
  EXPECT_EQ(matrix_of(few("spacings: 0.5 nan 3\naxis mins: 1 2 3\naxis maxs: nan 10 nan\n"
                          "centers: cell node ???\n")),
            "0.5 0 0 1.25 | 0 8 0 2 | 0 0 3 4.5");
  EXPECT_EQ(matrix_of(few("axismins: 0 0 0\naxismaxs: 3 2 1\ncenterings: cell cell cell\n")),
            "1 0 0 0.5 | 0 1 0 0.5 | 0 0 0.5 0.25");
  EXPECT_NE(refusal_of(few("spacings: 0 1 1\n")).find("singular"), std::string::npos);
  EXPECT_EQ(few("units: \"mm\" \"mm\" \"mm\"\n")->unit, "mm");
  EXPECT_EQ(few("units: \"mm\" \"mm\" \"s\"\n")->unit, "");
  EXPECT_EQ(few("space: RAS\nspace units: \"um\" \"um\" \"um\"\n")->unit, "um");
}

TEST(Nrrd, SegmentsAndLayers) {
  const std::string names =
      "Segment0_Name:=spleen\nSegment0_LabelValue:=7\nSegment0_Layer:=0\n"
      "Segment1_ID:=Segment_2\nSegment1_LabelValue:=1\n";
  EXPECT_EQ(labels_of(few(names)), "0:6 1:5 Segment_2 7:1 spleen");
  EXPECT_EQ(labels_of(few("Segment0_Name:=only\n")), "0:6 1:5 only 7:1");
  // Layers last, first, and between.
  const std::string two = "Segment0_Name:=a\nSegment1_Name:=b\n";
  const std::string ones = samples_of<std::uint8_t>({0, 1, 1, 0, 1, 0, 1, 1, 0, 0, 0, 1});
  const auto last = look_at(
      header_of("kinds: domain domain domain list\n" + two, "uchar", "3 1 2 2") + "\n" + ones);
  EXPECT_EQ(labels_of(last), "0:6 1:3 a 1:3 b");
  const std::string mixed = samples_of<std::uint8_t>({1, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0});
  const auto first =
      look_at(header_of("space: RAS\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
                        "kinds: list domain domain domain\n" +
                            two,
                        "uchar", "2 3 1 2") +
              "\n" + mixed);
  EXPECT_EQ(labels_of(first), "0:7 1:4 a 1:1 b");
  EXPECT_EQ(first->volume->structures, (std::vector<std::string>{"a", "b"}));
  const auto middle = look_at(
      header_of("kinds: domain vector domain domain\n" + two, "uchar", "3 2 1 2") + "\n" + ones);
  EXPECT_EQ(labels_of(middle), "0:6 1:4 a 1:2 b");
  EXPECT_NE(refusal_of(few("Segment0_Layer:=1\n")).find("is in layer 1, of 1"), std::string::npos);
  EXPECT_NE(refusal_of(few("Segment0_LabelValue:=x\n")).find("has no number"), std::string::npos);
}

TEST(Nrrd, FewerDimensions) {
  const auto flat = look_at(header_of("spacings: 2 3\n", "uchar", "3 4") + "\n" + kBytes);
  EXPECT_EQ(labels_of(flat), kFewLabels);
  EXPECT_EQ(matrix_of(flat), "2 0 0 0 | 0 3 0 0 | 0 0 1 0");
  const auto placed = look_at(
      header_of("space: LPS\nspace directions: (0,2,0) (0,0,3)\n", "uchar", "3 4") + "\n" + kBytes);
  EXPECT_EQ(matrix_of(placed), "0 0 1 0 | 2 0 0 0 | 0 3 0 0");
}

TEST(Nrrd, WhatIsCutOffOrAnnouncesTooMuchIsRefused) {
  EXPECT_NE(refusal_of(look_at(header_of("") + "\n" + kBytes.substr(1))).find("cut off"),
            std::string::npos);
  EXPECT_NE(refusal_of(look_at(header_of("", "float", "3 2 2", "ascii") + "\n1 2 3 4 5 6 7"))
                .find("cut off"),
            std::string::npos);
  EXPECT_EQ(refusal_of(look_at(header_of("", "float", "3 1", "ascii") + "\n1 two 3")),
            "'two' is not a number");
  EXPECT_NE(refusal_of(look_at(header_of("", "uchar", "99999999 99999999 9999999") + "\n")),
            "taken");
  EXPECT_NE(
      refusal_of(look_at(header_of("", "uchar", "99999 99999 1", "gzip") + "\n" + gzipped(kBytes)))
          .find("cut off"),
      std::string::npos);
  EXPECT_NE(refusal_of(look_at(header_of("", "uchar", "3 0 2") + "\n")).find("no size"),
            std::string::npos);
}

}  // namespace
}  // namespace tetloft
