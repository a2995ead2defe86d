// TetGen's files, read by this test; .ele with .node beside it, by hand and as TetGen writes them;
// and what is refused.
#include <gtest/gtest.h>

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

using test::TempFolder;

// Rows of numbers without comments.
std::vector<std::vector<double>> rows_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  for (const std::string& line : test::lines_of(text)) {
    if (line.front() != '#') rows.push_back(test::numbers_of_line(line));
  }
  return rows;
}

Result<ReadModel> read_pair(const std::string& ele, const std::string& node) {
  TempFolder folder;
  test::put(folder.file("a.ele"), ele);
  test::put(folder.file("a.node"), node);
  return read_model(folder.file("a.ele"));
}

TEST(WriteTetgen, HasThreeFiles) {
  const Model model = test::named_solid();
  TempFolder folder;
  const auto written = write_model(folder.file("a.b.ele"), model);
  ASSERT_TRUE(written.ok()) << to_string(written.error());
  EXPECT_TRUE(written->empty());
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.b.ele", "a.b.face", "a.b.node"}));

  const auto nodes = rows_of(test::get(folder.file("a.b.node")));
  ASSERT_EQ(nodes.size(), 1 + model.points.size());
  EXPECT_EQ(nodes[0], (std::vector<double>{double(model.points.size()), 3, 0, 0}));
  for (const VertexId v : model.points.ids()) {
    const std::vector<double>& row = nodes[1 + v.index()];
    ASSERT_EQ(row.size(), 4U);
    EXPECT_EQ(row[0], double(v.index()));
    EXPECT_TRUE(test::same_bits({row[1], row[2], row[3]}, model.points[v]));
  }
  const auto tets = rows_of(test::get(folder.file("a.b.ele")));
  const std::vector<double> attributes{1, 1, 2, 3, 4, 5, 0};
  ASSERT_EQ(tets.size(), 1 + attributes.size());
  EXPECT_EQ(tets[0], (std::vector<double>{7, 4, 1}));
  for (const TetId t : model.tets.ids()) {
    std::vector<double> due{double(t.index())};
    for (const VertexId v : model.tets[t]) due.push_back(double(v.index()));
    due.push_back(attributes[t.index()]);
    EXPECT_EQ(tets[1 + t.index()], due);
  }
  const auto faces = rows_of(test::get(folder.file("a.b.face")));
  ASSERT_EQ(faces.size(), 1 + 4 * 7 - 2U);
  EXPECT_EQ(faces[0], (std::vector<double>{26, 1}));
  double volume = 0;
  for (std::size_t i = 1; i < faces.size(); ++i) {
    ASSERT_EQ(faces[i].size(), 5U);
    EXPECT_EQ(faces[i][0], double(i - 1));
    const auto point = [&](std::size_t k) {
      return model.points[VertexId(static_cast<std::size_t>(faces[i][k]))];
    };
    volume += faces[i][4] == 1 ? test::determinant({Point3{}, point(1), point(2), point(3)}) : 0;
  }
  EXPECT_NEAR(volume, 0.9 + 2, 1e-12);  // of the two tets of the first component
}

TEST(WriteTetgen, LeavesNothingWhereOneFileCannotBe) {
  TempFolder folder;
  std::filesystem::create_directory(folder.file("a.face"));
  EXPECT_FALSE(write_model(folder.file("a.ele"), test::named_solid()).ok());
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.face"});
}

TEST(ReadTetgen, TakesBackWhatIsWritten) {
  TempFolder folder;
  Model model = test::named_solid();
  ASSERT_TRUE(write_model(folder.file("a.ele"), model).ok());
  auto read = read_model(folder.file("a.ele"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  test::expect_same_solid(read->model, model);
  EXPECT_EQ(read->model.about, model.about);
  model.component_names[ComponentId(0)] = test::first_name_printed();
  EXPECT_EQ(read->model.component_names, model.component_names);
  model = test::hard_model();
  ASSERT_TRUE(write_model(folder.file("hard.ELE"), model).ok());
  read = read_model(folder.file("hard.ELE"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  test::expect_same_solid(read->model, model);
  EXPECT_TRUE(read_points(folder.file("hard.node")).ok());
}

const std::string kNodes =
    "5 3 1 1\n1 0 0 0 9 1\n2 1 0 0 9 1\n3 0 1 0 9 1\n4 0 0 1 9 1\n5 1 1 1 9 1\n";

TEST(ReadTetgen, CountsFromOneAndTakesRegions) {
  const auto read = read_pair(
      "# a comment\n2  4  2\n    1      1     2     3     4    7.0 3\n    2  2 4 3 5    -1 3\n# "
      "Generated",
      kNodes);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->model.tets[TetId(0)],
            (TetVertices{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}));
  // By their numbers.
  EXPECT_EQ(read->model.component.raw(),
            (std::vector<ComponentId>{ComponentId(1), ComponentId(0)}));
  ASSERT_EQ(read->warnings.size(), 3U);  // of points, of tets, and that one is turned over
  EXPECT_TRUE(read->warnings[0].where.file.ends_with("a.node"));
  EXPECT_TRUE(read->warnings[1].where.file.ends_with("a.ele"));
  EXPECT_EQ(read->model.tets[TetId(1)],
            (TetVertices{VertexId(1), VertexId(3), VertexId(4), VertexId(2)}));
  const auto plain = read_pair("1 4\n0 0 1 2 3\n", "4 3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  ASSERT_TRUE(plain.ok()) << to_string(plain.error());
  EXPECT_TRUE(plain->model.component.empty());
  EXPECT_EQ(plain->model.tets.size(), 1U);
}

TEST(ReadTetgen, NamesWhatIsWrongAndWhere) {
  struct Case {
    std::string ele;
    std::size_t line;
    const char* message;
  };
  for (const Case& wrong : {
           Case{"", 0, "empty"},
           Case{"1\n", 1, "expected \"count 4 attributes\""},
           Case{"x 4 0\n", 1, "'x' is no count"},
           Case{"1 10 0\n", 1, "tets of 10 points"},
           Case{"1 4 0\n1 1 2 3 6\n", 2, "'6' is none of the points, which count from 1 to 5"},
           Case{"1 4 0\n1 0 2 3 4\n", 2, "'0' is none"},
           Case{"1 4 0\n0 1 2 3 4\n", 2, "not '0'"},
           Case{"2 4 0\n1 1 2 3 4\n3 1 2 3 4\n", 3, "not '3'"},
           Case{"1 4 0\n1 1 2 3 4\n2 1 2 3 4\n", 3, "more tets than the 1"},
           Case{"3 4 0\n1 1 2 3 4\n", 2, "3 tets are announced, here are 1"},
           Case{"1 4 1\n1 1 2 3 4\n", 2, "1 attributes, got 5 fields"},
           Case{"1 4 1\n1 1 2 3 4 1.5\n", 2, "'1.5' is no number of a region"},
           Case{"1 4 1\n1 1 2 3 4 1e300\n", 2, "'1e300'"},
           Case{"1 4 999999999999999999\n1 1 2 3 4 1\n", 2, "attributes, got 6"},
       }) {
    test::expect_error_at(read_pair(wrong.ele, kNodes), "a.ele", wrong.line, wrong.message);
  }
  const auto node = read_pair("1 4 0\n1 1 2 3 4\n", "5 3\n1 0 0 x\n");
  ASSERT_FALSE(node.ok());
  EXPECT_TRUE(node.error().where.file.ends_with("a.node"));
}

TEST(ReadTetgen, NeedsThePointsBesideIt) {
  const auto bytes = parse_model("1 4 0\n1 1 2 3 4\n", "a.ele");
  ASSERT_FALSE(bytes.ok());
  EXPECT_NE(bytes.error().message.find("not read from a file"), std::string::npos);
  TempFolder folder;
  test::put(folder.file("a.ele"), "1 4 0\n1 1 2 3 4\n");
  const auto alone = read_model(folder.file("a.ele"));
  ASSERT_FALSE(alone.ok());
  EXPECT_NE(alone.error().message.find("'a.node', are not beside it"), std::string::npos);
  test::put(folder.file("a.NODE"), kNodes);
  EXPECT_TRUE(read_model(folder.file("a.ele")).ok());
}

TEST(ReadTetgen, TakesNoHarmFromDamage) {
  TempFolder folder;
  ASSERT_TRUE(write_model(folder.file("a.ele"), test::named_solid()).ok());
  const std::string ele = test::get(folder.file("a.ele"));
  const std::string node = test::get(folder.file("a.node"));
  Prng random(2);
  std::size_t refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string changed = i % 2 == 0 ? ele : node;
    const std::size_t at = random.below(changed.size());
    if (i % 4 < 2) changed.resize(at);
    if (i % 4 >= 2) changed[at] = static_cast<char>(random.below(256));
    test::put(folder.file("a.ele"), i % 2 == 0 ? changed : ele);
    test::put(folder.file("a.node"), i % 2 == 0 ? node : changed);
    const auto read = read_model(folder.file("a.ele"));
    refused += read.ok() ? 0U : 1U;
    if (!read.ok()) continue;
    for (const TetVertices& tet : read->model.tets) {
      for (const VertexId v : tet) ASSERT_LT(v.index(), read->model.points.size());
    }
  }
  EXPECT_GT(refused, 800U);
}

}  // namespace
}  // namespace tetloft
