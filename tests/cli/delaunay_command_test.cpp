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
