// Gmsh's files, versions 4.1 and 2.2: ours byte by byte, and those of others.
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

// Of component 1 (the second tet) three faces, of component 2 three; the last point is of no tet.
const std::string kNames =
    "$PhysicalNames\n4\n2 1 \"component 1\"\n2 2 \"component 2\"\n3 1 \"component 1\"\n"
    "3 2 \"component 2\"\n$EndPhysicalNames\n";
const std::string kText4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + kNames +
    "$Entities\n0 0 2 2\n"
    "1 0 0 0 1 1 2 1 1 0\n2 0 0 -0 1 1 2 1 2 0\n1 0 0 0 1 1 2 1 1 1 1\n2 0 0 -0 1 1 2 1 2 1 2\n"
    "$EndEntities\n$Nodes\n3 6 1 6\n"
    "2 1 0 4\n2\n3\n4\n5\n1 0 0\n0 1 0\n0 0 2\n1 1 1.0000000000000002\n"
    "3 1 0 1\n6\n7 8 9\n2 2 0 1\n1\n0.5 0 -0\n$EndNodes\n"
    "$Elements\n4 8 1 8\n2 1 2 3\n3 5 3 4\n4 2 5 4\n5 2 3 5\n2 2 2 3\n6 1 4 3\n7 1 2 4\n8 1 3 2\n"
    "3 1 4 1\n2 2 5 3 4\n3 2 4 1\n1 1 2 3 4\n$EndElements\n";
const std::string kText2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + kNames +
    "$Nodes\n6\n1 0.5 0 -0\n2 1 0 0\n3 0 1 0\n4 0 0 2\n5 1 1 1.0000000000000002\n6 7 8 "
    "9\n$EndNodes\n"
    "$Elements\n8\n3 2 2 1 1 5 3 4\n4 2 2 1 1 2 5 4\n5 2 2 1 1 2 3 5\n6 2 2 2 2 1 4 3\n"
    "7 2 2 2 2 1 2 4\n8 2 2 2 2 1 3 2\n2 4 2 1 1 2 5 3 4\n1 4 2 2 2 1 2 3 4\n$EndElements\n";

// Boxes are least and largest numbers, which may be zeros of either sign.
std::string without_signed_zeros(std::string text) {
  for (std::size_t at = 0; (at = text.find(" -0 ", at)) != std::string::npos;)
    text.erase(at + 1, 1);
  return text;
}

TEST(WriteMsh, WritesText) {
  EXPECT_EQ(without_signed_zeros(written(two_tets(), "msh", Encoding::ascii)),
            without_signed_zeros(kText4));
  EXPECT_EQ(written(two_tets(), "msh2", Encoding::ascii), kText2);
}

// What Gmsh calls int and size_t, without spaces between.
std::string ints(const std::vector<double>& values, bool big = false) {
  return packed<std::int32_t>(values, big);
}
std::string sizes(const std::vector<double>& values, bool big = false) {
  return packed<std::uint64_t>(values, big);
}
std::string doubles(const std::vector<double>& values, bool big = false) {
  return packed<double>(values, big);
}

// One tet of one component, which has a name.
std::string binary4(bool big) {
  return "$MeshFormat\n4.1 1 8\n" + ints({1}, big) +
         "\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"a\"\n3 1 "
         "\"a\"\n$EndPhysicalNames\n$Entities\n" +
         sizes({0, 0, 1, 1}, big) + ints({1}, big) + doubles({0, 0, 0, 1, 1, 1}, big) +
         sizes({1}, big) + ints({1}, big) + sizes({0}, big) + ints({1}, big) +
         doubles({0, 0, 0, 1, 1, 1}, big) + sizes({1}, big) + ints({1}, big) + sizes({1}, big) +
         ints({1}, big) + "\n$EndEntities\n$Nodes\n" + sizes({1, 4, 1, 4}, big) +
         ints({2, 1, 0}, big) + sizes({4, 1, 2, 3, 4}, big) +
         doubles({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, big) + "\n$EndNodes\n$Elements\n" +
         sizes({2, 5, 1, 5}, big) + ints({2, 1, 2}, big) +
         sizes({4, 2, 2, 3, 4, 3, 1, 4, 3, 4, 1, 2, 4, 5, 1, 3, 2}, big) + ints({3, 1, 4}, big) +
         sizes({1, 1, 1, 2, 3, 4}, big) + "\n$EndElements\n";
}
std::string binary2(bool big) {
  std::string nodes;
  const std::vector<std::vector<double>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    nodes += ints({static_cast<double>(i + 1)}, big) + doubles(points[i], big);
  }
  return "$MeshFormat\n2.2 1 8\n" + ints({1}, big) +
         "\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"a\"\n3 1 "
         "\"a\"\n$EndPhysicalNames\n$Nodes\n4\n" +
         nodes + "\n$EndNodes\n$Elements\n5\n" + ints({2, 4, 2}, big) +
         ints({2, 1, 1, 2, 3, 4, 3, 1, 1, 1, 4, 3, 4, 1, 1, 1, 2, 4, 5, 1, 1, 1, 3, 2}, big) +
         ints({4, 1, 2, 1, 1, 1, 1, 2, 3, 4}, big) + "\n$EndElements\n";
}

Model one_tet() {
  Model model;
  for (const Point3& p : std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    model.points.push_back(p);
  }
  model.tets.push_back({VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  model.component.push_back(ComponentId(0));
  model.component_count = 1;
  model.component_names.push_back("a");
  return model;
}

TEST(Msh, IsBinaryAsTheManualSays) {
  EXPECT_EQ(written(one_tet(), "msh", Encoding::binary), binary4(false));
  EXPECT_EQ(written(one_tet(), "msh2", Encoding::compressed), binary2(false));
  for (const std::string& bytes : {binary4(false), binary4(true), binary2(false), binary2(true)}) {
    const auto read = parse_model(bytes, "a");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    test::expect_same(read->model, one_tet());
    EXPECT_TRUE(read->warnings.empty());
  }
}

TEST(Msh, IsReadBackBitForBit) {
  for (const char* format : {"msh", "msh2"}) {
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
      Model model = test::with_names(two_tets());
      test::expect_same(parse_model(written(model, format, encoding), "a")->model, model);
      const Model hard = test::hard_model();
      const auto read = parse_model(written(hard, format, encoding), "a");
      ASSERT_TRUE(read.ok()) << to_string(read.error());
      EXPECT_EQ(read->model.tets, hard.tets);
      EXPECT_EQ(read->model.component, hard.component);
      ASSERT_EQ(read->model.points.size(), hard.points.size());
      for (const VertexId v : hard.points.ids()) {
        EXPECT_TRUE(test::same_bits(read->model.points[v], hard.points[v])) << v.value();
      }
      // A model without anything, and one of points alone.
      test::expect_same(parse_model(written(Model(), format, encoding), "a")->model, Model());
      model = Model();
      model.points.push_back({1, 2, 3});
      test::expect_same(parse_model(written(model, format, encoding), "a")->model, model);
    }
  }
}

TEST(WriteMsh, GivesTetsOfNoComponentNoGroup) {
  Model model = two_tets();
  model.component[TetId(1)] = ComponentId();
  for (const char* format : {"msh", "msh2"}) {
    const std::string text = written(model, format, Encoding::ascii);
    EXPECT_NE(text.find("$PhysicalNames\n2\n2 2 \"component 2\"\n3 2 \"component 2\"\n"),
              std::string::npos);
    // As components by their entity.
    const auto read = parse_model(text, "a");
    EXPECT_EQ(read->model.component_count, 2U);
    EXPECT_EQ(read->model.component[TetId(0)], ComponentId(0));
    EXPECT_EQ(read->model.component[TetId(1)], ComponentId(1));
    const std::vector<std::string> names{"component 2", ""};
    EXPECT_EQ(read->model.component_names.raw(), names);
  }
}

TEST(WriteMsh, TellsNamesThatItCannotHold) {
  Model model = two_tets();
  model.component_names.push_back("a \"b\"\nc");
  model.component_names.push_back(std::string(126, 'x') + "\xC3\xBC");
  const auto made = format_model(model, {Encoding::ascii, "msh"});
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->warnings.size(), 2U);
  EXPECT_NE(made->warnings[0].message.find("component 1"), std::string::npos);
  const auto read = parse_model(made->bytes, "a");
  const std::vector<std::string> names{"a 'b'\\x0ac", std::string(126, 'x')};
  EXPECT_EQ(read->model.component_names.raw(), names);
}

TEST(WriteMsh, RefusesNumbersThatGmshHasNot) {
  Model model = two_tets();
  model.component[TetId(1)] = ComponentId(0x7FFFFFFF);
  model.component_count = std::size_t{1} << 31;
  for (const char* format : {"msh", "msh2"}) {
    const auto made = format_model(model, {Encoding::binary, format});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, ErrorCode::invalid_input);
  }
}

void expect_two_tets(const std::string& text) {
  const auto read = parse_model(text, "a.msh");
  ASSERT_TRUE(read.ok()) << to_string(read.error()) << '\n' << text;
  Model expected = two_tets();
  expected.component_names = read->model.component_names;
  test::expect_same(read->model, expected);
}

TEST(ReadMsh, TakesWhatItDoesNotKeep) {
  for (const std::string& text : {kText4, kText2}) {
    expect_two_tets(text);
    expect_two_tets("$Comments\nmade by hand\n$EndComments\n" + text);
    expect_two_tets(text + "$Periodic\n1\n$EndPeriodic\n$NodeData\nwhat ever\n$EndNodeData\n");
    EXPECT_EQ(parse_model(replaced(text, "2 1 \"c", "1 1 \"c"), "a")->warnings.size(), 0U);
  }
  // Nodes with parameters on their entity.
  expect_two_tets(replaced(kText4, "2 2 0 1\n1\n0.5 0 -0", "2 2 1 1\n1\n0.5 0 -0 0.25 0.5"));
  // Points and curves; groups of other dimensions; several groups of a volume.
  expect_two_tets(replaced(replaced(kText4, "$Entities\n0 0 2 2\n",
                                    "$Entities\n1 1 2 2\n9 0 0 0 2 5 6\n"
                                    "3 0 0 0 1 1 1 0 2 9 -9\n"),
                           "2 1 1 1 1\n2 0", "2 2 1 7 1 1\n2 0"));
  // Tags beyond the second (partitions), and none.
  expect_two_tets(replaced(kText2, "2 4 2 1 1", "2 4 4 1 1 8 9"));
}

// The numbers of nodes and elements mean nothing beside their order.
TEST(ReadMsh, TakesNumbersWithGaps) {
  const std::string text =
      "$MeshFormat\n2 0 8\n$EndMeshFormat\n$Nodes\n4\n70 0 0 1\n-5 0 0 0\n3000000 9 9 9\n8 0 1 0\n"
      "$EndNodes\n$Elements\n1\n900 4 0 -5 3000000 8 70\n$EndElements\n";
  const auto read = parse_model(text, "a");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const std::vector<Point3> points{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};
  EXPECT_EQ(read->model.points.raw(), points);
  const TetVertices tet{VertexId(0), VertexId(3), VertexId(1), VertexId(2)};
  EXPECT_EQ(read->model.tets[TetId(0)], tet);
  EXPECT_TRUE(read->model.component.empty());
  EXPECT_EQ(read->model.component_count, 0U);
}

TEST(ReadMsh, PutsComponentsInTheOrderOfTheirGroups) {
  std::string text = replaced(kText2, "2 4 2 1 1 2 5", "2 4 2 -40 1 2 5");
  text = replaced(text, "1 4 2 2 2 1 2", "1 4 2 0 3 1 2");  // by entity, which is behind all groups
  text = replaced(text, "3 1 \"component 1\"", "3 40 \"forty\"");
  const auto read = parse_model(text, "a");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const std::vector<ComponentId> components{ComponentId(1), ComponentId(0)};
  EXPECT_EQ(read->model.component.raw(), components);
  const std::vector<std::string> names{"forty", ""};
  EXPECT_EQ(read->model.component_names.raw(), names);
}

TEST(ReadMsh, LeavesOutOtherSolidsAndTurnsTets) {
  const std::string text =
      replaced(replaced(kText2, "$Elements\n8", "$Elements\n10"), "1 4 2 2 2 1 2 3 4\n",
               "20 5 2 2 2 1 2 3 4 5 6 1 2\n21 99 2 2 2 1 2 3\n1 4 2 2 2 1 2 4 3\n");
  const auto read = parse_model(text, "a");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->model.tets, two_tets().tets);
  ASSERT_EQ(read->warnings.size(), 2U);
  EXPECT_EQ(read->warnings[0].message, "left out: 2 elements that are no tet of four nodes");
  EXPECT_EQ(read->warnings[1].message, "1 tet is negative: it is turned over");
}

// As Gmsh 2.2 writes a tet that is in several physical groups.
TEST(ReadMsh, TakesARepeatedTetOnce) {
  const std::string text =
      replaced(replaced(kText2, "$Elements\n8", "$Elements\n9"), "1 4 2 2 2 1 2 3 4\n",
               "30 4 2 1 2 2 1 4 3\n1 4 2 2 2 1 2 3 4\n");
  const auto read = parse_model(text, "a");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->model.tets, two_tets().tets);
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].message, "left out: 1 tet that stands again, as of several groups");
}

TEST(ReadMsh, RefusesWhatHasNoTets) {
  expect_refused(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
      "$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n",
      "a.msh", "none of the elements is a tet");
}

TEST(ReadMsh, RefusesWhatContradictsItself) {
  const std::string most = "9223372036854775807";
  const std::vector<std::array<std::string, 3>> wrong4{
      {"4.1 0", "4.0 0", "version '4.0'"},
      {"4.1 0", "4.1 2", "no form"},
      {"$EndMeshFormat", "$EndMesh", "does not end where"},
      {"$PhysicalNames\n4", "$PhysicalNames\n5", "'$EndPhysicalNames' is no integer"},
      {"\"component 1\"\n2", "component 1\n2", "no name in quotes"},
      {"$Nodes\n3 6", "$Nodes\n3 7", "hold 6 where 7"},
      {"$Nodes\n3 6", "$Nodes\n" + most + " 6", "no integer"},
      {"2 1 0 4\n", "2 1 0 " + most + "\n", "ends before"},
      {"2 1 0 4\n", "5 1 0 4\n", "no dimension"},
      {"2 1 0 4\n2\n3", "2 1 0 4\n2\n2", "node 2 stands twice"},
      {"0.5 0 -0", "0.5 inf -0", "'inf'"},
      {"$Elements\n4 8", "$Elements\n4 9", "hold 8 where 9"},
      {"1 1 2 3 4\n$End", "1 1 2 3 9\n$End", "refers to node 9"},
      {"1 1 2 3 4\n$End", "1 1 2 3\n$End", "no integer"},
      {"3 1 4 1\n", "3 9000000000 4 1\n", "more than 32 bits"},
      {"$EndElements", "$EndNodes", "does not end where"},
      {"$Entities\n0", "$Entities\n-1", "too large"},
      {"$EndElements\n", "$EndElements\n$Elements\n$EndElements", "stands twice"},
      {"$EndElements\n", "$EndElements\nwords", "begins no section"},
      {"$EndElements\n", "$EndElements\n$Other\n", "does not end"}};
  for (const auto& [from, to, reason] : wrong4) {
    expect_refused(replaced(kText4, from, to), "a.msh", reason);
  }
  const std::vector<std::array<std::string, 3>> wrong2{
      {"$Nodes\n6", "$Nodes\n7", "no integer"},
      {"$Nodes\n6", "$Nodes\n5", "does not end where"},
      {"$Nodes\n6", "$Nodes\n" + most, "no integer"},
      {"$Elements\n8", "$Elements\n" + most, "no integer"},
      {"1 4 2 2 2 1 2", "1 4 -2 2 2 1 2", "cannot be"},
      {"1 4 2 2 2 1 2", "1 4 " + most + " 2 2 1 2", "more than 32 bits"}};
  for (const auto& [from, to, reason] : wrong2) {
    expect_refused(replaced(kText2, from, to), "a.msh", reason);
  }
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  expect_refused(head, "a.msh", "no section $Elements");
  expect_refused(head + "$Elements\n0\n$EndElements\n", "a.msh", "stand before $Nodes");
  expect_refused(head + "$Nodes\n0\n$EndNodes\n$Elements\n1\n1 5 0 1 1 1 1 1 1 1 1\n$EndElements\n",
                 "a.msh", "none of the elements");
  expect_refused("$Comments\n$EndComments\n$Nodes\n", "a.msh", "does not begin with $MeshFormat");
  expect_refused(replaced(binary4(false), ints({1}), ints({2})), "a.msh", "order of bytes");
  expect_refused(replaced(binary2(false), ints({4, 1, 2}), ints({4, 2, 2})), "a.msh", "cannot be");
  expect_refused(replaced(binary2(false), ints({4, 1, 2}), ints({77, 1, 2})), "a.msh", "not known");
}

TEST(ReadMsh, TakesNoPartForTheWhole) {
  for (const std::string& bytes : {kText4, kText2, binary4(false), binary2(false)}) {
    for (std::size_t size = 0; size + 1 < bytes.size(); ++size) {
      EXPECT_FALSE(parse_model(bytes.substr(0, size), "a.msh").ok()) << size << '\n' << bytes;
    }
  }
}

// Sections in any order: values or a clean error.
TEST(ReadMsh, TakesSectionsInAnyOrder) {
  const auto section = [](const std::string& name) {
    const std::size_t begin = kText4.find('$' + name);
    const std::size_t end = kText4.find("$End" + name);
    return kText4.substr(begin, end - begin) + "$End" + name + '\n';
  };
  const std::string head = section("MeshFormat");
  expect_two_tets(head + section("Nodes") + section("Entities") + section("Elements") +
                  section("PhysicalNames"));
  expect_refused(head + section("Nodes") + section("Elements") + section("Entities"), "a.msh",
                 "behind $Elements");
}

TEST(ReadMsh, TakesFilesOfGmsh) {
  const std::string folder = std::string(TETLOFT_SHARED_DATA_DIR) + "/formats/mesh-output/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const char* name : {"two_v22.msh", "two_v22_bin.msh", "two_v41.msh", "two_v41_bin.msh"}) {
    const auto read = read_model(folder + name);
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->model.points.size(), 81U);
    EXPECT_EQ(read->model.tets.size(), 206U);
    EXPECT_NEAR(volume(read->model), 1.7, 1e-12);
    EXPECT_EQ(read->model.component_count, 2U);
    const std::vector<std::string> names{"lower", "upper"};
    EXPECT_EQ(read->model.component_names.raw(), names);
    EXPECT_TRUE(read->warnings.empty());
  }
}

}  // namespace
}  // namespace tetloft
