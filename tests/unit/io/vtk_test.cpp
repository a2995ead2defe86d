// Legacy VTK files: ours byte by byte, and those of others.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "unit/io/solid_files.hpp"

namespace tetloft {
namespace {

using test::expect_refused;
using test::packed;
using test::replaced;
using test::two_tets;
using test::written;

const std::string kText =
    "# vtk DataFile Version 3.0\nsolid\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n"
    "0.5 0 -0\n1 0 0\n0 1 0\n0 0 2\n1 1 1.0000000000000002\n7 8 9\n"
    "CELLS 2 10\n4 0 1 2 3\n4 1 4 2 3\nCELL_TYPES 2\n10 10\n"
    "CELL_DATA 2\nSCALARS component int 1\nLOOKUP_TABLE default\n1 0\n";

TEST(WriteLegacyVtk, WritesText) { EXPECT_EQ(written(two_tets(), "vtk", Encoding::ascii), kText); }

TEST(WriteLegacyVtk, WritesBigEndianBytes) {
  Model model = two_tets();
  model.kind = IdVector<TetId, TetKind>(std::vector<TetKind>{TetKind::cc, TetKind::ii});
  model.section = IdVector<VertexId, SectionId>(6, SectionId());
  model.about = {"a b", "mm", ""};
  const std::string expected =
      "# vtk DataFile Version 3.0\na b\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n" +
      packed<double>(test::coordinates_of(model), true) + "\nCELLS 2 10\n" +
      packed<std::int32_t>({4, 0, 1, 2, 3, 4, 1, 4, 2, 3}, true) + "\nCELL_TYPES 2\n" +
      packed<std::int32_t>({10, 10}, true) +
      "\nFIELD FieldData 2\nname 1 3 unsigned_char\na b\nunit 1 2 unsigned_char\nmm\n"
      "CELL_DATA 2\nSCALARS component int 1\nLOOKUP_TABLE default\n" +
      packed<std::int32_t>({1, 0}, true) + "\nFIELD FieldData 1\nkind 1 2 unsigned_char\n" +
      packed<std::uint8_t>({7, 2}, true) +
      "\nPOINT_DATA 6\nSCALARS section int 1\nLOOKUP_TABLE default\n" +
      packed<std::int32_t>({-1, -1, -1, -1, -1, -1}, true) + '\n';
  EXPECT_EQ(written(model, "vtk", Encoding::binary), expected);
  EXPECT_EQ(written(model, "vtk", Encoding::compressed), expected);
}

TEST(WriteLegacyVtk, CutsItsTitle) {
  Model model = two_tets();
  for (int i = 0; i < 100; ++i) model.about.name += "\xC3\xBC \n";  // six bytes and more
  const std::string text = written(model, "vtk", Encoding::ascii);
  const std::size_t begin = text.find('\n') + 1;
  const std::size_t length = text.find('\n', begin) - begin;
  EXPECT_LE(length, 255U);
  EXPECT_GT(length, 250U);
  EXPECT_EQ(parse_model(text, "a.vtk")->model.about.name, model.about.name);
}

TEST(LegacyVtk, IsReadBackBitForBit) {
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    Model model = test::with_names(test::hard_model());
    const auto read = parse_model(written(model, "vtk", encoding), "a");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    // Tables have no place there.
    model.links.clear();
    model.motions.clear();
    model.void_links.clear();
    model.deviations.clear();
    test::expect_same(read->model, model);
    for (const Model& other : {Model(), two_tets()}) {
      test::expect_same(parse_model(written(other, "vtk", encoding), "a")->model, other);
    }
  }
}

void expect_two_tets(const std::string& bytes, std::size_t warnings = 0) {
  const auto read = parse_model(bytes, "a.vtk");
  ASSERT_TRUE(read.ok()) << to_string(read.error()) << '\n' << bytes;
  test::expect_same(read->model, two_tets());
  EXPECT_EQ(read->warnings.size(), warnings) << bytes;
}

TEST(ReadLegacyVtk, TakesVersionsFrom2To5) {
  for (const char* version : {"1.0", "2.0", "3.1", "4.2"}) {
    expect_two_tets(replaced(kText, "3.0", version));
  }
  const std::string offsets =
      "CELLS 3 8\nOFFSETS vtktypeint64\n0 4 8\nCONNECTIVITY vtktypeint64\n0 1 2 3 1 4 2 3\n";
  const std::string text =
      replaced(replaced(kText, "3.0", "5.1"), "CELLS 2 10\n4 0 1 2 3\n4 1 4 2 3\n", offsets);
  expect_two_tets(text);
  const std::string binary =
      "# vtk DataFile Version 5.1\nvtk output\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
      "POINTS 6 double\n" +
      packed<double>(test::coordinates_of(two_tets()), true) +
      "\nCELLS 3 8\nOFFSETS vtktypeint64\n" + packed<std::int64_t>({0, 4, 8}, true) +
      "\nCONNECTIVITY vtktypeint64\n" + packed<std::int64_t>({0, 1, 2, 3, 1, 4, 2, 3}, true) +
      "\nCELL_TYPES 2\n" + packed<std::int32_t>({10, 10}, true) +
      "\n\nCELL_DATA 2\nFIELD FieldData 1\ncomponent 1 2 long\n" +
      packed<std::int64_t>({1, 0}, true) +
      "\nMETADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\n";
  expect_two_tets(binary);
}

TEST(ReadLegacyVtk, PassesOverWhatItDoesNotKeep) {
  const std::string more =
      "POINT_DATA 6\nSCALARS heat float 2\nLOOKUP_TABLE own\n0 1 2 3 4 5 6 7 8 9 10 nan\n"
      "LOOKUP_TABLE own 2\n0 0 0 1 1 1 1 1\nCOLOR_SCALARS c 1\n0 0 0 0 0 0.5\n"
      "VECTORS v double\n0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n"
      "TEXTURE_COORDINATES t 2 float\n0 0 0 0 0 0 0 0 0 0 0 0\n"
      "FIELD own 3\nsection 1 6 float\n0 0 0 0 0 0\norigin 1 6 int\n99 0 0 0 0 0\nb 1 3 bit\n1 0 "
      "1\n"
      "METADATA\nCOMPONENT_NAMES\na%20b\n\n";
  expect_two_tets(kText + more);
  expect_two_tets(kText + "METADATA\nx\n\n" + more + "GLOBAL_IDS g vtkIdType\n1 2 3 4 5 6\n");
  expect_two_tets(kText + more + "FIELD f 1\nnames 1 1 string\nab\n", 1);
  expect_two_tets(kText + "STRANGE 3\n", 1);
  // Lines that end as those of other systems, keywords in any case.
  std::string text = replaced(kText, "CELL_DATA", "cell_data");
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }
  expect_two_tets(text);
}

TEST(ReadLegacyVtk, LeavesOutCellsThatAreNoTets) {
  const std::string text = replaced(
      replaced(replaced(kText, "CELLS 2 10\n4 0 1 2 3\n", "CELLS 4 16\n3 0 1 9\n4 0 1 2 3\n1 5\n"),
               "CELL_TYPES 2\n10 10", "CELL_TYPES 4\n5 10 1 10"),
      "CELL_DATA 2\nSCALARS component int 1\nLOOKUP_TABLE default\n1 0",
      "CELL_DATA 4\nSCALARS component int\nLOOKUP_TABLE default\n8 1 9 0");
  expect_two_tets(text, 1);
  EXPECT_EQ(parse_model(text, "a")->warnings[0].message,
            "left out: 2 cells that are no tetrahedron");
}

TEST(ReadLegacyVtk, TurnsNegativeTetsOver) {
  const std::string text = replaced(kText, "4 0 1 2 3", "4 0 1 3 2");
  expect_two_tets(text, 1);
}

TEST(ReadLegacyVtk, RefusesWhatContradictsItself) {
  const std::string most = "9223372036854775807";
  const std::vector<std::array<std::string, 3>> wrong{
      {"Version 3.0", "Version 6.0", "no legacy VTK file"},
      {"ASCII", "TEXT", "neither ASCII nor BINARY"},
      {"UNSTRUCTURED_GRID", "POLYDATA", "no UNSTRUCTURED_GRID but 'polydata'"},
      {"POINTS 6", "POINTS -1", "no number of points"},
      {"POINTS 6", "POINTS " + most, "too many points"},
      {"POINTS 6", "POINTS 4000000000", "ends before"},
      {"POINTS 6", "POINTS 7", "is not a number"},
      {"6 double", "6 string", "no type of numbers"},
      {"0.5 0", "nan 0", "'nan'"},
      {"7 8 9", "7 8 x", "'x' is not a number"},
      {"CELLS 2 10", "CELLS 2 " + most, "ends before"},
      {"CELLS 2 10", "CELLS 3 10", "hold 2 cells where 3"},
      {"4 0 1 2 3", "5 0 1 2 3", "cells end before"},
      {"4 0 1 2 3", "-4 0 1 2 3", "cells end before"},
      {"4 0 1 2 3", "4 0 1 2 6", "refers to point 6 of 6"},
      {"4 0 1 2 3", "4 0 1 2 -1", "refers to point -1"},
      {"CELL_TYPES 2\n10 10", "CELL_TYPES 1\n10", "CELL_TYPES are 1 for 2"},
      {"10 10", "8 9", "none of the file's cells"},
      {"10 10", "10 1", "cell 1 is of type 1 and has 4 corners"},
      {"CELL_TYPES 2\n10 10", "", "no POINTS, CELLS and CELL_TYPES"},
      {"CELL_TYPES 2\n10 10\n", "STRANGE\n", "nothing that is read here"},
      {"int 1", "int 9", "1 to 4 components"},
      {"CELL_DATA 2", "CELL_DATA " + most, "claims more data"},
      {"CELL_TYPES", "POINTS 0 float\nCELL_TYPES", "stand twice"}};
  for (const auto& [from, to, reason] : wrong) {
    expect_refused(replaced(kText, from, to), "a.vtk", reason);
  }
  const std::string fields = kText + "FIELD f 1\n";
  expect_refused(fields, "a.vtk", "ends early");
  expect_refused(fields + "x 9223372036854775807 9223372036854775807 int\n", "a.vtk",
                 "claims more");
  const std::string binary = written(two_tets(), "vtk", Encoding::binary);
  const auto read = parse_model(replaced(binary, "CELLS 2", "CELLS 9"), "a.vtk");
  EXPECT_FALSE(read.error().where.line.has_value());
}

// A cut between two parts leaves a file that is whole: then it has all points and tets.
TEST(ReadLegacyVtk, TakesNoPartForTheWhole) {
  const Model model = test::with_names(two_tets());
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    const std::string bytes = written(model, "vtk", encoding);
    std::size_t refused = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const auto read = parse_model(bytes.substr(0, size), "a.vtk");
      if (!read) {
        ++refused;
        continue;
      }
      EXPECT_EQ(read->model.points, model.points) << size;
      EXPECT_EQ(read->model.tets, model.tets) << size;
    }
    EXPECT_GT(refused, bytes.find("CELL_TYPES"));
  }
}

TEST(ReadLegacyVtk, TakesFilesOfGmsh) {
  const std::string path = std::string(TETLOFT_SHARED_DATA_DIR) + "/formats/mesh-output/two.vtk";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto read = read_model(path);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->model.points.size(), 81U);
  EXPECT_EQ(read->model.tets.size(), 206U);
  EXPECT_NEAR(volume(read->model), 1.7, 1e-12);
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].message, "left out: 14 cells that are no tetrahedron");
}

}  // namespace
}  // namespace tetloft
