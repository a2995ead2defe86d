// Unstructured grids as this library writes them.
#include <gtest/gtest.h>

#include <tetloft/io.hpp>

#include "unit/io/io_support.hpp"

namespace tetloft {
namespace {

using test::TempFolder;

class VtuEncoding : public testing::TestWithParam<Encoding> {};
INSTANTIATE_TEST_SUITE_P(All, VtuEncoding,
                         testing::Values(Encoding::binary, Encoding::ascii, Encoding::compressed),
                         [](const auto& param) {
                           return param.param == Encoding::binary  ? "Binary"
                                  : param.param == Encoding::ascii ? "Ascii"
                                                                   : "Compressed";
                         });

TEST_P(VtuEncoding, ReadsBackBitForBit) {
  TempFolder folder;
  const Model model = test::hard_model();
  ASSERT_TRUE(write_vtu(folder.file("m.vtu"), model, GetParam()).ok());
  const auto read = read_vtu(folder.file("m.vtu"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  test::expect_same(model, *read);
}

TEST_P(VtuEncoding, KeepsInvalidIds) {
  TempFolder folder;
  Model model = test::hard_model();
  model.component[TetId(0)] = ComponentId();
  model.slab[TetId(1)] = SlabId();
  ASSERT_TRUE(write_vtu(folder.file("m.vtu"), model, GetParam()).ok());
  const auto read = read_vtu(folder.file("m.vtu"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  test::expect_same(model, *read);
}

TEST_P(VtuEncoding, WritesMeshesWithoutProvenance) {
  TempFolder folder;
  const Model model = test::hard_model();
  ASSERT_TRUE(
      write_vtu(folder.file("m.vtu"), model.points.raw(), model.tets.raw(), GetParam()).ok());
  const auto read = read_vtu(folder.file("m.vtu"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->tets, model.tets);
  EXPECT_TRUE(read->component.empty());
  EXPECT_TRUE(read->origin.empty());
  EXPECT_TRUE(read->links.empty());
  EXPECT_EQ(read->component_count, 0U);
  // What was read without provenance can be written again.
  EXPECT_TRUE(write_vtu(folder.file("n.vtu"), *read, GetParam()).ok());
  EXPECT_EQ(test::get(folder.file("m.vtu")).size() > 0, true);
}

TEST_P(VtuEncoding, WritesTheEmptyModel) {
  TempFolder folder;
  ASSERT_TRUE(write_vtu(folder.file("m.vtu"), Model(), GetParam()).ok());
  const auto read = read_vtu(folder.file("m.vtu"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->points.empty());
  EXPECT_TRUE(read->tets.empty());
}

TEST_P(VtuEncoding, WritesTheSameBytesAgain) {
  TempFolder folder;
  ASSERT_TRUE(write_vtu(folder.file("a.vtu"), test::hard_model(), GetParam()).ok());
  ASSERT_TRUE(write_vtu(folder.file("b.vtu"), test::hard_model(), GetParam()).ok());
  EXPECT_EQ(test::get(folder.file("a.vtu")), test::get(folder.file("b.vtu")));
}

// Longer than the pieces in which arrays are written.
TEST_P(VtuEncoding, WritesLongArrays) {
  TempFolder folder;
  Model model;
  for (int i = 0; i < 30000; ++i) model.points.push_back({0.1 * i, -0.3 * i, 1.0 / (1 + i)});
  for (int i = 0; i + 3 < 30000; ++i) {
    model.tets.push_back({VertexId(i), VertexId(i + 1), VertexId(i + 2), VertexId(i + 3)});
  }
  ASSERT_TRUE(write_vtu(folder.file("m.vtu"), model, GetParam()).ok());
  const auto read = read_vtu(folder.file("m.vtu"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->points, model.points);
  EXPECT_EQ(read->tets, model.tets);
}

TEST(WriteVtu, RefusesArraysOfWrongLength) {
  TempFolder folder;
  Model model = test::hard_model();
  model.slab.push_back(SlabId(1));
  EXPECT_EQ(write_vtu(folder.file("m.vtu"), model).error().code, ErrorCode::invalid_input);
  EXPECT_TRUE(folder.names().empty());
}

// Which no reader would take.
TEST(WriteVtu, RefusesVerticesThatTheFramePlacesNowhere) {
  Model model;
  model.points.raw() = {{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  model.tets.raw() = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  model.frame.axes[0].x = 0x1p1022;
  EXPECT_TRUE(format_vtu(model).ok());
  model.frame.axes[0].x = 0x1p1023;
  const auto refused = format_vtu(model);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::unrepresentable);
}

TEST(WriteVtu, TellsWhatCannotBeWritten) {
  TempFolder folder;
  const auto written = write_vtu(folder.file("none/m.vtu"), test::hard_model());
  EXPECT_EQ(written.error().code, ErrorCode::io);
}

TEST(ReadVtu, TellsWhenThereIsNoFile) {
  TempFolder folder;
  EXPECT_EQ(read_vtu(folder.file("none.vtu")).error().code, ErrorCode::io);
}

}  // namespace
}  // namespace tetloft
