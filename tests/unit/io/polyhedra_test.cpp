// Polyhedra as VTK files.
#include <gtest/gtest.h>

#include <filesystem>

#include <tetloft/io.hpp>

#include "unit/io/io_support.hpp"

namespace tetloft {
namespace {

using test::TempFolder;

// Two tets that share a face, each with its own order of corners.
PolyhedronSet two_tets() {
  PolyhedronSet set;
  set.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  set.cells = {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
               {{1, 3, 2}, {4, 3, 1}, {4, 1, 2}, {4, 2, 3}}};
  set.data = {{"volume", {0.5, 0.25}}};
  return set;
}

TEST(Polyhedra, HaveFacesAsCountsAndPoints) {
  const auto text = format_polyhedra(two_tets(), Encoding::ascii);
  ASSERT_TRUE(text.ok()) << to_string(text.error());
  // Points of each cell once, by number.
  EXPECT_NE(text->find("0 1 2 3 1 2 3 4"), std::string::npos);
  // Faces of the first, then of the second cell, sixteen numbers to a line.
  EXPECT_NE(text->find("4 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2\n3 4 3 1 3 2 3 4 3 1 3 4 1 2 3 4\n2 3"),
            std::string::npos)
      << *text;
  EXPECT_NE(text->find("17 34"), std::string::npos);
  EXPECT_NE(text->find("0.5 0.25"), std::string::npos);
}

TEST(Polyhedra, AreWrittenAllOrNotAtAll) {
  TempFolder folder;
  PolyhedronSet set = two_tets();
  const std::string path = folder.file("cells.vtu");
  ASSERT_TRUE(write_polyhedra(path, set).ok());
  EXPECT_EQ(*format_polyhedra(set), test::get(path));
  set.cells[1][2][0] = 5;
  EXPECT_EQ(write_polyhedra(folder.file("no.vtu"), set).error().code, ErrorCode::invalid_input);
  EXPECT_FALSE(std::filesystem::exists(folder.file("no.vtu")));
  set = two_tets();
  set.data[0].value.pop_back();
  const auto refused = format_polyhedra(set);
  EXPECT_NE(refused.error().message.find("volume"), std::string::npos);
  EXPECT_TRUE(format_polyhedra({}).ok());
}

}  // namespace
}  // namespace tetloft
