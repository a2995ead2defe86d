// tetloft delaunay.
#include <gtest/gtest.h>

#include <tetloft/io.hpp>

#include "cli/runner.hpp"
#include "core/little_endian.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::expect_failure;
using test::JsonValue;
using test::Outcome;
using test::run;
using test::run_json;
using test::TempFolder;

constexpr const char* kOctahedron =
    "# corners\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n1 0 0\n";

TEST(DelaunayCommand, CountsTets) {
  TempFolder folder;
  test::put(folder.file("p.txt"), kOctahedron);
  const JsonValue json = run_json({"delaunay", folder.file("p.txt"), "--threads", "2"});
  EXPECT_EQ(json.at("points").number, 7);
  EXPECT_EQ(json.at("duplicates").number, 1);
  EXPECT_EQ(json.at("dimension").number, 3);
  EXPECT_GE(json.at("tets").number, 4);
  EXPECT_EQ(json.at("seconds").kind, JsonValue::Kind::number);
  const Outcome plain = run({"delaunay", folder.file("p.txt")});
  EXPECT_EQ(plain.code, 0);
  EXPECT_NE(plain.out.find("7 points"), std::string::npos);
}

TEST(DelaunayCommand, ReadsBinaryPointsAndWritesTets) {
  TempFolder folder;
  std::string bytes;
  for (const double value : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.}) {
    append_little(bytes, value);
  }
  test::put(folder.file("p.bin"), bytes);
  const JsonValue json = run_json({"delaunay", folder.file("p.bin"), "-o", folder.file("o.vtu")});
  EXPECT_EQ(json.at("tets").number, 1);
  const auto model = read_vtu(folder.file("o.vtu"));
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->tets.size(), 1U);
  EXPECT_EQ(model->points.size(), 4U);
  EXPECT_GT(volume(*model), 0);
}

TEST(DelaunayCommand, EndsAtTheWorkLimit) {
  TempFolder folder;
  const std::string points = folder.file("p.txt");
  // Two skew lines: every piece of one spans a tet with every piece of the other.
  std::string text;
  for (int i = 0; i < 60; ++i) {
    text += std::to_string(i) + " 0.25 0\n30.5 " + std::to_string(i - 30) + " 7\n";
  }
  test::put(points, text);
  expect_failure({"delaunay", points, "--work-limit", "0.1"}, 7, "work_limit", "more than 3276");
  expect_failure({"delaunay", points, "--work-limit", "0"}, 2, "usage", "--work-limit");
  EXPECT_GE(run_json({"delaunay", points}).at("tets").number, 59 * 59);
}

TEST(DelaunayCommand, OffersItsEngines) {
  TempFolder folder;
  const std::string points = folder.file("p.txt");
  test::put(points, "0 0 0\n2 0 0\n0 2 0\n0 0 1\n2 0 1\n1 2 1\n");
  EXPECT_EQ(run_json({"delaunay", points}).at("engine").string, "slab");
  EXPECT_EQ(run_json({"delaunay", points, "--engine", "auto"}).at("engine").string, "slab");
  std::vector<std::string> written;
  for (const char* engine : {"slab", "incremental"}) {
    const std::string output = folder.file(std::string(engine) + ".vtu");
    EXPECT_EQ(run_json({"delaunay", points, "--engine", engine, "-o", output}).at("engine").string,
              engine);
    written.push_back(test::get(output));
  }
  EXPECT_EQ(written[0], written[1]);
  expect_failure({"delaunay", points, "--engine", "fast"}, 2, "usage", "--engine");
  test::put(points, kOctahedron);
  EXPECT_EQ(run_json({"delaunay", points}).at("engine").string, "incremental");
  expect_failure({"delaunay", points, "--engine", "slab"}, 3, "invalid_input", "two planes");
}

TEST(DelaunayCommand, WarnsOfFlatPoints) {
  TempFolder folder;
  test::put(folder.file("p.txt"), "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  const Outcome plain = run({"delaunay", folder.file("p.txt")});
  EXPECT_EQ(plain.code, 0);
  EXPECT_NE(plain.err.find("coplanar"), std::string::npos);
  test::put(folder.file("p.txt"), "");
  EXPECT_EQ(run_json({"delaunay", folder.file("p.txt")}).at("dimension").number, -1);
}

// An octahedron about its centre, with a second copy of its first corner.
std::string centred_octahedron() { return std::string(kOctahedron) + "0 0 0\n"; }

TEST(DelaunayCommand, PrintsTheNearestPointOfEachQueryAndNothingElse) {
  TempFolder folder;
  test::put(folder.file("p.txt"), centred_octahedron());
  // The last but one is as near to points 2 and 4 as to 0 and its copy.
  test::put(folder.file("q.csv"), "0,0,-9\n1,0,0\n3,3,1\n0,0.9,0\n0.6,0.6,0.6\n0.1,0.1,0.1\n");
  const std::vector<std::string> line{"delaunay", folder.file("p.txt"), "--nearest",
                                      folder.file("q.csv")};
  const Outcome plain = run(line);
  EXPECT_EQ(plain.code, 0);
  EXPECT_EQ(plain.out, "5\n0\n0\n2\n0\n7\n");
  EXPECT_EQ(plain.err, "");
  for (const char* option : {"--quiet", "--threads=1", "--threads=3"}) {
    std::vector<std::string> more = line;
    more.push_back(option);
    EXPECT_EQ(run(more).out, plain.out) << option;
  }
  const JsonValue json = run_json({line[0], line[1], line[2], line[3]});
  ASSERT_EQ(json.at("nearest").array.size(), 6U);
  EXPECT_EQ(json.at("nearest").array[5].number, 7);
  EXPECT_EQ(json.at("points").number, 8);
  EXPECT_EQ(json.at("duplicates").number, 1);
  EXPECT_EQ(json.at("tets").number, 8);
}

TEST(DelaunayCommand, PrintsTheSimplexThatHoldsEachQuery) {
  TempFolder folder;
  test::put(folder.file("p.txt"), centred_octahedron());
  test::put(folder.file("q.txt"),
            "0.2 0.2 0.2\n0.25 0.25 0\n0 0 -0.5\n1 0 0\n0.5 0.5 0\n1 1 1\n-1 0 0.001\n");
  const std::vector<std::string> line{"delaunay", folder.file("p.txt"), "--locate",
                                      folder.file("q.txt")};
  EXPECT_EQ(run(line).out,
            "tet 0 2 4 7\nfacet 0 2 7\nedge 5 7\nvertex 0\nedge 0 2\noutside\noutside\n");
  const JsonValue json = run_json(line);
  ASSERT_EQ(json.at("locations").array.size(), 7U);
  const JsonValue& facet = json.at("locations").array[1];
  EXPECT_EQ(facet.at("kind").string, "facet");
  ASSERT_EQ(facet.at("vertices").array.size(), 3U);
  EXPECT_EQ(facet.at("vertices").array[2].number, 7);
  EXPECT_TRUE(json.at("locations").array[5].at("vertices").array.empty());
}

TEST(DelaunayCommand, AnswersForPointsThatSpanNoSpace) {
  TempFolder folder;
  const std::string points = folder.file("p.txt");
  const std::string queries = folder.file("q.txt");
  test::put(queries, "1 0 0\n0.5 0 0\n1 0 1\n");
  const auto told = [&](const char* option) {
    const Outcome outcome = run({"delaunay", points, option, queries});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  };
  test::put(points, "");
  EXPECT_EQ(told("--nearest"), "none\nnone\nnone\n");
  EXPECT_EQ(told("--locate"), "outside\noutside\noutside\n");
  EXPECT_EQ(run_json({"delaunay", points, "--nearest", queries}).at("nearest").array[2].kind,
            JsonValue::Kind::null);
  test::put(points, "2 0 0\n1 0 0\n0 0 0\n1 0 0\n");
  EXPECT_EQ(told("--nearest"), "1\n1\n1\n");
  EXPECT_EQ(told("--locate"), "vertex 1\nedge 1 2\noutside\n");
  test::put(points, "0 -1 0\n2 -1 0\n0 1 0\n");
  EXPECT_EQ(told("--locate"), "edge 1 2\nfacet 0 1 2\noutside\n");
  test::put(queries, "");
  EXPECT_EQ(told("--nearest"), "");
}

TEST(DelaunayCommand, WritesTetsBesideAnswers) {
  TempFolder folder;
  test::put(folder.file("p.txt"), centred_octahedron());
  test::put(folder.file("q.txt"), "0 0 2\n");
  const std::string output = folder.file("o.vtu");
  const Outcome plain =
      run({"delaunay", folder.file("p.txt"), "--nearest", folder.file("q.txt"), "-o", output});
  EXPECT_EQ(plain.out, "4\n");
  const auto model = read_vtu(output);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->tets.size(), 8U);
}

TEST(DelaunayCommand, TellsWhatIsWrongWithQueries) {
  TempFolder folder;
  const std::string points = folder.file("p.txt");
  const std::string queries = folder.file("q.vtu");
  const std::string output = folder.file("o.vtu");
  test::put(points, centred_octahedron());
  expect_failure({"delaunay", points, "--nearest", points, "--locate", points}, 2, "usage",
                 "--nearest and --locate");
  expect_failure({"delaunay", "-", "--locate", "-"}, 2, "usage", "--locate");
  expect_failure({"delaunay", points, "--nearest", queries, "-o", queries}, 2, "usage",
                 "overwrite");
  expect_failure({"delaunay", points, "--nearest", folder.file("none"), "-o", output}, 4, "io",
                 "none", {output});
  const std::string bad = folder.file("bad.txt");
  test::put(bad, "0 0 0\n1 nan 0\n");
  expect_failure({"delaunay", points, "--locate", bad, "-o", output}, 3, "invalid_input",
                 bad + ":2", {output});
}

TEST(DelaunayCommand, TellsWhatIsWrong) {
  TempFolder folder;
  const std::string points = folder.file("p.txt");
  test::put(points, "0 0 0\n1 0\n");
  expect_failure({"delaunay", points, "-o", folder.file("o.vtu")}, 3, "invalid_input",
                 points + ":2", {folder.file("o.vtu")});
  test::put(points, "0 0 0\n1 0 nan\n");
  expect_failure({"delaunay", points}, 3, "invalid_input", points + ":2");
  expect_failure({"delaunay", folder.file("none")}, 4, "io", "none");
  expect_failure({"delaunay", points, "-o", folder.file("o.txt")}, 2, "usage", ".vtu");
  expect_failure({"delaunay", points, "-o", folder.file("x/o.vtu")}, 4, "io", "x/o.vtu");
  expect_failure({"delaunay", points, "--threads", "many"}, 2, "usage", "--threads");
}

}  // namespace
}  // namespace tetloft
