// MEDIT's .mesh: what is written, read by a parser of this test; what is read, by hand and from
// others; and what is refused.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>

#include "core/prng.hpp"
#include "unit/io/io_support.hpp"
#include "unit/io/solid_files.hpp"
#include "unit/io/solid_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

std::string medit_of(const Model& model) {
  const auto made = format_model(model, {.format = "medit"});
  EXPECT_TRUE(made.ok());
  EXPECT_TRUE(made->warnings.empty());
  return made->bytes;
}

// Rows of numbers by keyword; each section as long as it says.
std::map<std::string, std::vector<std::vector<double>>> sections_of(const std::string& text) {
  std::map<std::string, std::vector<std::vector<double>>> sections;
  const std::vector<std::string> lines = test::lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] != "Vertices" && lines[i] != "Tetrahedra" && lines[i] != "Triangles") continue;
    auto& rows = sections[lines[i]];
    const std::size_t count = std::stoul(lines.at(i + 1));
    for (std::size_t k = 0; k < count; ++k) {
      rows.push_back(test::numbers_of_line(lines.at(i + 2 + k)));
    }
    EXPECT_EQ(lines.at(i + 2 + count), "");
  }
  return sections;
}

TEST(WriteMedit, HasReferencesOfComponentsAndOutwardTriangles) {
  const Model model = test::named_solid();
  const std::string text = medit_of(model);
  EXPECT_EQ(text.find("MeshVersionFormatted 2\n"), 0U);
  EXPECT_NE(text.find("\nDimension 3\n"), std::string::npos);
  EXPECT_TRUE(text.ends_with("\nEnd\n"));
  auto sections = sections_of(text);
  ASSERT_EQ(sections["Vertices"].size(), model.points.size());
  for (const VertexId v : model.points.ids()) {
    const std::vector<double>& row = sections["Vertices"][v.index()];
    ASSERT_EQ(row.size(), 4U);
    EXPECT_TRUE(test::same_bits({row[0], row[1], row[2]}, model.points[v]));
    EXPECT_EQ(row[3], 0);
  }
  const std::vector<double> references{1, 1, 2, 3, 4, 5, 0};
  ASSERT_EQ(sections["Tetrahedra"].size(), model.tets.size());
  for (const TetId t : model.tets.ids()) {
    const std::vector<double>& row = sections["Tetrahedra"][t.index()];
    ASSERT_EQ(row.size(), 5U);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(row[k], model.tets[t][k].value() + 1.0);
    EXPECT_EQ(row[4], references[t.index()]);
  }
  // Two tets share a face. Cones of outward triangles over a point are the volume.
  ASSERT_EQ(sections["Triangles"].size(), 4 * model.tets.size() - 2);
  std::map<double, double> volumes;
  for (const std::vector<double>& row : sections["Triangles"]) {
    const auto point = [&](std::size_t k) {
      return model.points[VertexId(static_cast<std::size_t>(row[k]) - 1)];
    };
    volumes[row[3]] += test::determinant({Point3{}, point(0), point(1), point(2)});
  }
  ASSERT_EQ(volumes.size(), 6U);
  for (const auto& [reference, volume] : volumes) EXPECT_GT(volume, 0.8) << reference;
}

TEST(WriteMedit, SaysInCommentsWhatItIsOf) {
  const std::string text = medit_of(test::named_solid());
  for (const std::string comment :
       {"# name: liver", "# unit: mm", "# orientation: LPS",
        "# component 2: Gr\xC3\xB6\xC3\x9F"
        "e 7",
        "# component 3: lobe a", "# component 4: lobe A", "# component 5: 7"}) {
    EXPECT_NE(text.find('\n' + comment + '\n'), std::string::npos) << comment;
  }
  EXPECT_NE(text.find("\n# component 1: " + test::first_name_printed() + '\n'), std::string::npos);
}

TEST(ReadMedit, TakesBackWhatIsWritten) {
  Model model = test::named_solid();
  const auto read = parse_model(medit_of(model), "a");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  test::expect_same_solid(read->model, model);
  EXPECT_EQ(read->model.about, model.about);
  model.component_names[ComponentId(0)] = test::first_name_printed();
  EXPECT_EQ(read->model.component_names, model.component_names);
  EXPECT_EQ(medit_of(read->model), medit_of(test::named_solid()));
  // Without components, and without anything.
  model = test::named_solid();
  model.component.clear();
  EXPECT_EQ(parse_model(medit_of(model), "a")->model.component_count, 1U);
  EXPECT_TRUE(parse_model(medit_of({}), "a")->model.tets.empty());
}

// Of references only 0 is none.
TEST(ReadMedit, TakesNegativeReferencesForComponents) {
  const auto read = parse_model(
      "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
      "1 1 1 0\nTetrahedra 3\n1 2 3 4 7\n2 5 3 4 -1\n1 2 3 4 0\nEnd\n",
      "a.mesh");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->model.component_count, 2U);
  EXPECT_EQ(read->model.component.raw(),
            (std::vector<ComponentId>{ComponentId(1), ComponentId(0), ComponentId()}));
}

// Words on one line or many, in any order of sections, with what else there may be.
TEST(ReadMedit, TakesTheFormsOfOthers) {
  const std::string forms[] = {
      " MeshVersionFormatted 1\n Dimension\n 3\n Vertices\n 4\n 0 0 0 7\n 1 0 0 7\n0 1 0 7\n0 0 1 "
      "7\n"
      " Tetrahedra\n 1\n 1 2 3 4 12\n End\n",
      "\xEF\xBB\xBF# of nobody\r\nMeshVersionFormatted 2 Dimension 3\r\nTetrahedra 1 1 2 3 4 12\r\n"
      "Corners 1 4 Ridges 0\r\nVertices 4 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0 # four\r\n"
      "Triangles 1 1 2 3 5 Hexahedra 0 NormalAtVertices 1 1 1 Normals 1 0 0 -1e0\r\nEnd rest"};
  for (const std::string& form : forms) {
    const auto read = parse_model(form, "a");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_TRUE(read->warnings.empty());
    ASSERT_EQ(read->model.points.size(), 4U);
    EXPECT_EQ(read->model.points[VertexId(3)], (Point3{0, 0, 1}));
    ASSERT_EQ(read->model.tets.size(), 1U);
    EXPECT_EQ(read->model.component_count, 1U);
  }
  const auto cut = parse_model(forms[0].substr(0, forms[0].find(" End")), "a");
  ASSERT_TRUE(cut.ok());
  ASSERT_EQ(cut->warnings.size(), 1U);
  EXPECT_NE(cut->warnings[0].message.find("no End"), std::string::npos);
}

TEST(ReadMedit, TellsOfOtherCells) {
  const auto read = parse_model(
      "MeshVersionFormatted 2\nDimension 3\nHexahedra 2\n1 2 3 4 1 2 3 4 0\n1 2 3 4 1 2 3 4 0\n"
      "Prisms 0\nTetrahedra 0\nEnd\n",
      "a.mesh");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].message, "left out: 2 Hexahedra");
  EXPECT_EQ(read->warnings[0].where.line, 3U);
}

TEST(ReadMedit, NamesWhatIsWrongAndWhere) {
  const std::string head = "MeshVersionFormatted 2\nDimension 3\n";
  const std::string points = "Vertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
  struct Case {
    std::string text;
    std::size_t line;
    const char* message;
  };
  for (const Case& wrong : {
           Case{"MeshVersionFormatted 2\nDimension 2\n", 2, "dimension '2'"},
           Case{"MeshVersionFormatted Dimension", 1, "followed by a number"},
           Case{head + points + "Tetrahedra 1\n1 2 3 5 0\nEnd", 10, "vertex 5 of 4"},
           Case{head + points + "Tetrahedra 1\n1 2 3 0 0\nEnd", 9, "'0' is no number of a vertex"},
           Case{head + points + "Tetrahedra 1\n1 2 3 -4 0\nEnd", 9, "'-4'"},
           Case{head + points + "Tetrahedra 1\n1 2 3 4294967296 0\nEnd", 9, "'4294967296'"},
           Case{head + points + "Tetrahedra 2\n1 2 3 4 0\n", 10, "2 tetrahedra are announced"},
           Case{head + points + "Tetrahedra 1\n1 2 3 4 x\nEnd", 9, "'x' is no reference"},
           Case{head + points + "Tetrahedra -1\nEnd", 8, "'-1' is no count of tetrahedra"},
           Case{head + points + "Tetrahedra 99999999999999\n1 2 3 4 1\n", 10, "99999999999999"},
           Case{head + points + points + "End", 8, "twice"},
           Case{head + points + "End", 8, "no Tetrahedra"},
           Case{head + "Vertices 1\n0 0 1e999 0\n", 4, "'1e999' is not a finite number"},
           Case{head + "Vertices 1\n0 0 nan 0\n", 4, "'nan'"},
           Case{head + "Vertices 2\n0 0 0 0\n", 5, "2 vertices are announced"},
           Case{head + "Vertices x\n", 3, "'x' is no count of vertices"},
           Case{head + "7\n", 3, "'7' stands for a keyword"},
       }) {
    test::expect_error_at(parse_model(wrong.text, "a.mesh"), "a.mesh", wrong.line, wrong.message);
  }
}

// Cut or changed anywhere: an error or a model, and tets have points that there are.
TEST(ReadMedit, TakesNoHarmFromDamage) {
  const std::string whole = medit_of(test::named_solid());
  Prng random(1);
  std::size_t refused = 0;
  const auto look = [&](const std::string& bytes) {
    const auto read = parse_model(bytes, "a.mesh");
    refused += read.ok() ? 0U : 1U;
    if (!read.ok()) return;
    for (const TetVertices& tet : read->model.tets) {
      for (const VertexId v : tet) ASSERT_LT(v.index(), read->model.points.size());
    }
  };
  for (std::size_t size = 0; size < whole.size(); ++size) look(whole.substr(0, size));
  EXPECT_GT(refused, whole.size() / 3);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole;
    bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
    look(bytes);
  }
}

}  // namespace
}  // namespace tetloft
