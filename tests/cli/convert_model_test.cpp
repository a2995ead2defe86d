// tetloft convert of models: to solids and surfaces of other formats, whole and by components.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

namespace fs = std::filesystem;
using test::expect_failure;
using test::JsonValue;
using test::run;
using test::run_json;
using test::TempFolder;

// Two tubes apart, of 1 and 4 cubic units.
const std::string kTwoTubes =
    "S 2\nv 8 z 0\n{ 0 0 1 0 1 1 0 1 }\n{ 10 0 12 0 12 2 10 2 }\n"
    "v 8 z 1\n{ 0 0 1 0 1 1 0 1 }\n{ 10 0 12 0 12 2 10 2 }\n";

class ConvertModel : public ::testing::Test {
 protected:
  ConvertModel() {
    test::put(stack_, kTwoTubes);
    EXPECT_EQ(run({"reconstruct", stack_, "-o", model_, "--quiet"}).code, 0);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }

  TempFolder folder_;
  std::string stack_ = folder_.file("two.cnt");
  std::string model_ = folder_.file("two.vtu");
};

TEST_F(ConvertModel, WritesTheBoundaryThatReconstructWrites) {
  for (const std::string ending : {"obj", "ply", "stl", "off", "vtp"}) {
    const std::string direct = file("direct." + ending);
    const std::string converted = file("converted." + ending);
    ASSERT_EQ(run({"reconstruct", stack_, "--surface", direct, "--quiet"}).code, 0);
    const JsonValue told = run_json({"convert", model_, converted});
    EXPECT_EQ(told.at("components").array.size(), 2U);
    EXPECT_EQ(test::get(converted), test::get(direct)) << ending;
  }
}

TEST_F(ConvertModel, KeepsASolidBitForBit) {
  for (const std::string encoding : {"--ascii", "--compress"}) {
    const std::string there = file("there.vtu");
    const std::string back = file("back.vtu");
    ASSERT_EQ(run({"convert", model_, "-o", there, encoding}).code, 0);
    EXPECT_NE(test::get(there), test::get(model_)) << encoding;
    ASSERT_EQ(run({"convert", there, back}).code, 0);
    EXPECT_EQ(test::get(back), test::get(model_)) << encoding;
    EXPECT_EQ(run({"check", there, stack_}).code, 0) << encoding;
  }
}

TEST_F(ConvertModel, MakesAFileOfEachComponent) {
  const JsonValue told = run_json({"convert", model_, file("part.vtu"), "--per-component"});
  ASSERT_EQ(told.at("written").array.size(), 2U);
  double volumes = 0;
  std::size_t tets = 0;
  for (const JsonValue& written : told.at("written").array) {
    const auto part = read_vtu(written.string);
    ASSERT_TRUE(part.ok()) << written.string;
    EXPECT_EQ(part->component_count, 1U);
    volumes += volume(*part);
    tets += part->tets.size();
  }
  EXPECT_DOUBLE_EQ(volumes, 5);
  EXPECT_EQ(static_cast<double>(tets), told.at("tets").number);
  EXPECT_EQ(told.at("written").array[0].string, file("part-component_1.vtu"));
}

TEST_F(ConvertModel, TakesTheFormatByName) {
  const std::string odd = file("surface.txt");
  ASSERT_EQ(run({"convert", model_, odd, "--to", "ply"}).code, 0);
  EXPECT_EQ(test::get(odd).substr(0, 4), "ply\n");
}

TEST_F(ConvertModel, RefusesWhatDoesNotFit) {
  const auto fails = [&](std::vector<std::string> words, int code, const std::string& in_message) {
    words.insert(words.begin(), "convert");
    expect_failure(words, code,
                   code == 2   ? "usage"
                   : code == 4 ? "io"
                               : "invalid_input",
                   in_message, {file("x.obj"), file("x.vtu")});
  };
  fails({model_}, 2, "missing OUT");
  fails({model_, file("x.obj"), "-o", file("x.vtu")}, 2, "given twice");
  fails({model_, file("x.obj"), "--roi", "1"}, 2, "--roi");
  fails({model_, file("x.obj"), "--labels-out", file("l")}, 2, "--labels-out");
  fails({model_, file("x.obj"), "--ascii", "--compress"}, 2, "exclude");
  fails({model_, model_}, 2, "overwrite");
  fails({model_, file("x.xyz")}, 2, ".vtu");
  fails({model_, file("x.obj"), "--to", "foo"}, 2, "foo");
  fails({stack_, file("x.obj")}, 3, "reconstruct makes a model");
  fails({model_, file("none/x.obj")}, 4, "folder");
}

// Nothing of several files appears where one of them cannot be written.
TEST_F(ConvertModel, LeavesNothingWhereOnePartCannotBeWritten) {
  fs::create_directory(file("part-component_2.stl"));
  expect_failure({"convert", model_, file("part.stl"), "--per-component"}, 4, "io",
                 "part-component_2.stl", {file("part-component_1.stl")});
}

TEST_F(ConvertModel, WritesAllFilesOfAFormatOrNone) {
  const std::vector<std::string> all{file("t.ele"), file("t.node"), file("t.face")};
  ASSERT_EQ(run({"convert", model_, file("t.ele")}).code, 0);
  for (const std::string& path : all) {
    EXPECT_FALSE(test::get(path).empty()) << path;
    fs::remove(path);
  }
  fs::create_directory(file("t.face"));
  expect_failure({"convert", model_, file("t.ele")}, 4, "io", "t.face",
                 {file("t.ele"), file("t.node")});
  // What stands beside the output is an output, too.
  test::put(file("p.node"), "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  expect_failure({"delaunay", file("p.node"), "-o", file("p.ele")}, 2, "usage", "overwrite",
                 {file("p.ele")});
  // Refused before the model is read.
  expect_failure({"convert", file("none.vtu"), file("x.obj"), "--to", "tetgen"}, 2, "usage", ".ele",
                 {file("x.obj")});
}

TEST_F(ConvertModel, EveryCommandTellsAllFilesOfAFormat) {
  test::put(file("p.xyz"), "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  EXPECT_NE(run({"delaunay", file("p.xyz"), "-o", file("p.ele")}).out.find("p.face"),
            std::string::npos);
  EXPECT_NE(run({"reconstruct", stack_, "-o", file("r.ele")}).out.find("r.face"),
            std::string::npos);
  test::put(file("labelled.csl"),
            "CSLC\n2 2\n\n1 4 1 0 0 1 0\n\n0 0 0\n9 0 0\n9 9 0\n0 9 0\n\n4 1 0 1 2 3\n"
            "\n2 4 1 0 0 1 -3\n\n0 0 3\n9 0 3\n9 9 3\n0 9 3\n\n4 1 0 1 2 3\n");
  const JsonValue told =
      run_json({"reconstruct", file("labelled.csl"), "--label", "all", "-o", file("l.ele")});
  std::vector<std::string> written;
  for (const JsonValue& path : told.at("structures").array[0].at("written").array) {
    written.push_back(path.string);
  }
  EXPECT_EQ(written,
            (std::vector<std::string>{file("l-1.ele"), file("l-1.node"), file("l-1.face")}));
}

// A grid of one tet of component 0 and one of component 2; the same without components, and
// without tets.
std::string grid(const std::string& tets, const std::string& offsets, const std::string& types,
                 const std::string& components) {
  const auto array = [](const std::string& attributes, const std::string& values) {
    return "<DataArray format=\"ascii\" " + attributes + ">" + values + "</DataArray>";
  };
  const std::string data =
      components.empty() ? "" : array("type=\"Int32\" Name=\"component\"", components);
  return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">"
         "<UnstructuredGrid><Piece NumberOfPoints=\"8\" NumberOfCells=\"" +
         std::to_string(std::count(types.begin(), types.end(), '1')) + "\"><Points>" +
         array("type=\"Float64\" NumberOfComponents=\"3\"",
               "0 0 0 1 0 0 0 1 0 0 0 1 5 0 0 6 0 0 5 1 0 5 0 1") +
         "</Points><Cells>" + array("type=\"Int64\" Name=\"connectivity\"", tets) +
         array("type=\"Int64\" Name=\"offsets\"", offsets) +
         array("type=\"UInt8\" Name=\"types\"", types) + "</Cells><CellData>" + data +
         "</CellData></Piece></UnstructuredGrid></VTKFile>\n";
}

TEST_F(ConvertModel, MakesNoFileOfAComponentWithoutTets) {
  test::put(file("gap.vtu"), grid("0 1 2 3 4 5 6 7", "4 8", "10 10", "0 2"));
  const JsonValue told = run_json({"convert", file("gap.vtu"), file("g.stl"), "--per-component"});
  EXPECT_EQ(told.at("written").array.size(), 2U);
  ASSERT_EQ(told.at("warnings").array.size(), 1U);
  EXPECT_NE(told.at("warnings").array[0].at("message").string.find("'component 2' has no tets"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(file("g-component_2.stl")));
  EXPECT_TRUE(fs::exists(file("g-component_3.stl")));
}

TEST_F(ConvertModel, ErrorsNameTheModel) {
  test::put(file("bare.vtu"), grid("0 1 2 3 4 5 6 7", "4 8", "10 10", ""));
  expect_failure({"convert", file("bare.vtu"), file("x.stl"), "--per-component"}, 3,
                 "invalid_input", "bare.vtu: the model does not tell of components",
                 {file("x.stl")});
  test::put(file("void.vtu"), grid("", "", "", ""));
  expect_failure({"convert", file("void.vtu"), file("x.stl")}, 3, "invalid_input",
                 "void.vtu: the model has no tets", {file("x.stl")});
}

// It is empty here.
TEST_F(ConvertModel, EveryCommandReadsModelsFromStandardInput) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"convert", "-", file("x.ply"), "--to", "ply"},
        {"check", "-", stack_},
        {"render", "-", "-o", file("x.svg")},
        {"report", "-", "-o", file("x.html")}}) {
    expect_failure(words, 3, "invalid_input", "/dev/stdin");
  }
}

TEST_F(ConvertModel, StacksHaveTheEncodingThatWasAskedFor) {
  for (const char* name : {"plain.vtp", "ascii.vtp", "compressed.vtp"}) {
    std::vector<std::string> words{"convert", stack_, file(name)};
    if (name[0] != 'p') words.push_back(name[0] == 'a' ? "--ascii" : "--compress");
    ASSERT_EQ(run(words).code, 0);
    ASSERT_EQ(run({"convert", file(name), file("back.cnt")}).code, 0);
    EXPECT_EQ(run({"check", model_, file("back.cnt")}).code, 0) << name;
  }
  EXPECT_NE(test::get(file("ascii.vtp")).find("format=\"ascii\""), std::string::npos);
  EXPECT_NE(test::get(file("compressed.vtp")).find("vtkZLibDataCompressor"), std::string::npos);
  EXPECT_EQ(test::get(file("plain.vtp")).find("format=\"ascii\""), std::string::npos);
  expect_failure({"convert", stack_, file("x.vtp"), "--ascii", "--compress"}, 2, "usage", "exclude",
                 {file("x.vtp")});
}

// Planes x = const: files of other formats do not tell that, but the stack does.
TEST_F(ConvertModel, KeepsSolidsOfSagittalPlanesCheckable) {
  std::string text = "CSLC\n2 2\n";
  for (const std::string x : {"0", "3"}) {
    text += "\n" + std::to_string(x == "0" ? 1 : 2) + " 4 1 1 0 0 -" + x + "\n\n" + x + " 0 0\n" +
            x + " 9 0\n" + x + " 9 5\n" + x + " 0 5\n\n4 1 0 1 2 3\n";
  }
  const std::string stack = file("turned.csl");
  test::put(stack, text);
  ASSERT_EQ(run({"reconstruct", stack, "-o", file("turned.vtu")}).code, 0);
  ASSERT_EQ(run({"convert", file("turned.vtu"), file("turned.msh")}).code, 0);
  const auto solid = read_model(file("turned.msh"));
  ASSERT_TRUE(solid.ok());
  for (const Point3& p : solid->model.points) EXPECT_TRUE(p.x == 0 || p.x == 3 || p.x == 1.5);
  EXPECT_EQ(run({"check", file("turned.msh"), stack}).code, 0);
  EXPECT_EQ(run({"report", file("turned.msh"), stack, "-o", file("turned.html")}).code, 0);
}

TEST_F(ConvertModel, RefusesWhatIsEmpty) {
  test::put(file("empty.vtk"), "");
  expect_failure({"convert", file("empty.vtk"), file("x.obj")}, 3, "invalid_input", "empty.vtk",
                 {file("x.obj")});
}

TEST_F(ConvertModel, NeverOverwritesItsInput) {
  const std::string input = file("part-component_1.vtu");
  fs::copy_file(model_, input);
  expect_failure({"convert", input, file("part.vtu"), "--per-component"}, 2, "usage", "overwrite",
                 {file("part-component_2.vtu")});
  EXPECT_EQ(test::get(input), test::get(model_));
}

TEST_F(ConvertModel, TellsAllFilesThatItWrites) {
  const JsonValue told = run_json({"convert", model_, file("t.ele")});
  std::vector<std::string> written;
  for (const JsonValue& path : told.at("written").array) written.push_back(path.string);
  EXPECT_EQ(written, (std::vector<std::string>{file("t.ele"), file("t.node"), file("t.face")}));
}

TEST_F(ConvertModel, NamesComponentsAfterLabels) {
  const std::string labels = file("labels");
  test::put(labels, "0 0 7\n0 1 3\n1 0 7\n1 1 3\n");
  const std::string model = file("labelled.vtu");
  ASSERT_EQ(run({"reconstruct", stack_, "-o", model, "--labels", labels}).code, 0);
  const JsonValue told = run_json({"convert", model, file("part.stl"), "--per-component"});
  std::vector<std::string> names;
  for (const JsonValue& name : told.at("components").array) names.push_back(name.string);
  EXPECT_EQ(names, (std::vector<std::string>{"label 7", "label 3"}));
  EXPECT_TRUE(fs::exists(file("part-label_7.stl")));
}

}  // namespace
}  // namespace tetloft
