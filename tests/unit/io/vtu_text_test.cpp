// Names, unit and orientation in unstructured grids.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "support/counted_memory.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {
namespace {

Model named_model() {
  Model model = test::hard_model();
  model.about = {"left \"lung\" & <heart>", "mm", "LPS"};
  model.component_names.push_back("a b\n\tc");
  model.component_names.push_back("Grün \xF0\x9F\xAB\x80");
  return model;
}

Model written_and_read(const Model& model, Encoding encoding) {
  const auto bytes = format_vtu(model, encoding);
  EXPECT_TRUE(bytes.ok());
  const auto read = parse_vtu(*bytes, "m.vtu");
  EXPECT_TRUE(read.ok());
  return *read;
}

// meshio finds raw arrays one after the other by their offsets, and moves each to where it stands
// in base64: none may get the old offset of a later one.
TEST(VtuOffsets, DoNotMisleadMeshio) {
  const std::regex told("offset=\"([0-9]+)\"");
  std::size_t raw = 0;
  for (std::size_t n = 4; n < 150; ++n) {
    Model model;
    for (std::size_t i = 0; i < n; ++i) {
      const auto x = static_cast<double>(i);
      model.points.push_back({x, x * x, x * x * x});
      model.section.push_back(SectionId(0));
      model.contour.push_back(ContourId(0));
      model.origin.push_back(PointOrigin::input);
    }
    for (std::size_t i = 0; i + 3 < n; i += 2) {
      model.tets.push_back({VertexId(i), VertexId(i + 1), VertexId(i + 2), VertexId(i + 3)});
      model.component.push_back(ComponentId(0));
    }
    model.component_count = 1;
    const auto bytes = format_vtu(model);
    ASSERT_TRUE(bytes.ok());
    const auto read = parse_vtu(*bytes, "m.vtu");
    ASSERT_TRUE(read.ok()) << n << ": " << to_string(read.error());
    test::expect_same(model, *read);
    if (bytes->find("encoding=\"base64\"") != std::string::npos) continue;
    ++raw;
    const std::string head = bytes->substr(0, bytes->find("<AppendedData"));
    std::vector<std::size_t> old;
    for (std::sregex_iterator at(head.begin(), head.end(), told), end; at != end; ++at) {
      old.push_back(std::stoul((*at)[1]));
    }
    std::set<std::size_t> moved;
    std::size_t next = 0;
    for (std::size_t k = 0; k + 1 < old.size(); ++k) {
      next += (old[k + 1] - old[k] + 2) / 3 * 4;
      EXPECT_EQ(moved.count(old[k + 1]), 0U) << n;
      moved.insert(next);
    }
    EXPECT_EQ(old.size(), 8U);
  }
  EXPECT_GT(raw, 100U);
  // One that would.
  const auto hard = format_vtu(test::hard_model());
  ASSERT_TRUE(hard.ok());
  EXPECT_NE(hard->find("<AppendedData encoding=\"base64\">"), std::string::npos);
}

TEST(VtuTexts, AreReadBack) {
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii, Encoding::compressed}) {
    test::expect_same(named_model(), written_and_read(named_model(), encoding));
  }
}

TEST(VtuTexts, OfSomeComponentsAreReadBack) {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"", "b"}, {"a", ""}, {"a", "b"}}) {
    Model model = test::hard_model();
    model.component_names = IdVector<ComponentId, std::string>(names);
    test::expect_same(model, written_and_read(model, Encoding::binary));
  }
}

TEST(VtuTexts, AreLeftOutWhereEmpty) {
  Model model = test::hard_model();
  const auto plain = format_vtu(model, Encoding::binary);
  for (const char* array : {"\"name\"", "\"unit\"", "\"orientation\"", "\"component_names\""}) {
    EXPECT_EQ(plain->find(array), std::string::npos) << array;
  }
  model.component_names.resize(2);
  EXPECT_EQ(*format_vtu(model, Encoding::binary), *plain);
  model.about.unit = "mm";
  const auto with_unit = format_vtu(model, Encoding::ascii);
  EXPECT_NE(with_unit->find("Name=\"unit\" NumberOfTuples=\"2\" format=\"ascii\">\n109 109\n"),
            std::string::npos);
}

TEST(VtuTexts, AreWrittenAsUtf8) {
  Model model = test::hard_model();
  model.about.name = "a\xFF";
  model.component_names.push_back(std::string("b\0c", 3));
  model.component_names.push_back("d");
  const Model read = written_and_read(model, Encoding::binary);
  EXPECT_EQ(read.about.name, "a\xEF\xBF\xBD");
  ASSERT_EQ(read.component_names.size(), 2U);
  EXPECT_EQ(read.component_names[ComponentId(0)],
            "b\xEF\xBF\xBD"
            "c");
}

// A tet of component 0, with one more array about the whole.
std::string file_with(const std::string& array) {
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><FieldData>" + array +
         "</FieldData><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><CellData><DataArray "
         "type=\"Int32\" Name=\"component\">0</DataArray></CellData><Points><DataArray "
         "type=\"Float64\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>"
         "<Cells><DataArray type=\"Int32\" Name=\"connectivity\">0 1 2 3</DataArray><DataArray "
         "type=\"Int32\" Name=\"offsets\">4</DataArray><DataArray type=\"UInt8\" Name=\"types\">10"
         "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
}

std::string array(const std::string& name, const std::string& type, const std::string& values,
                  const std::string& more = "") {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" " + more + ">" + values +
         "</DataArray>";
}

TEST(VtuTexts, OfOthersAreIgnored) {
  const std::vector<std::string> others{array("name", "UInt8", "255"),
                                        array("name", "UInt8", "192 128"),  // overlong
                                        array("name", "UInt8", "-1"),
                                        array("name", "UInt8", "321"),
                                        array("name", "Int32", "65"),
                                        array("name", "Float64", "65"),
                                        array("name", "String", "65 0"),
                                        array("name", "UInt8", "65", "NumberOfComponents=\"2\""),
                                        array("component_names", "UInt8", "65 0 66"),
                                        array("component_names", "UInt8", "0"),
                                        array("component_names", "UInt8", "255"),
                                        array("component_names", "Int8", "65")};
  for (const std::string& other : others) {
    const auto read = parse_vtu(file_with(other), "a.vtu");
    ASSERT_TRUE(read.ok()) << other << '\n' << to_string(read.error());
    EXPECT_EQ(read->about, Description{}) << other;
    EXPECT_TRUE(read->component_names.empty()) << other;
    EXPECT_EQ(read->component_count, 1U);
  }
  const auto right = parse_vtu(
      file_with(array("name", "UInt8", "65 66") + array("component_names", "UInt8", "67")),
      "a.vtu");
  ASSERT_TRUE(right.ok());
  EXPECT_EQ(right->about.name, "AB");
  EXPECT_EQ(right->component_names.raw(), std::vector<std::string>{"C"});
}

// A name for each of two thousand components, of which one tet is the last.
TEST(VtuTexts, OfMoreComponentsThanTetsAreIgnored) {
  std::string bytes = file_with(array("component_names", "UInt8", test::repeated("0 ", 3998)));
  bytes.replace(bytes.find(">0</DataArray></CellData>"), 2, ">1999");
  const auto read = parse_vtu(bytes, "a.vtu");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->component_count, 2000U);
  EXPECT_TRUE(read->component_names.empty());
}

}  // namespace
}  // namespace tetloft
