// tetloft reconstruct.
#include <gtest/gtest.h>

#include <tetloft/io.hpp>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::JsonValue;
using test::Outcome;
using test::run;
using test::run_json;
using test::TempFolder;

class ReconstructCommand : public testing::Test {
 protected:
  ReconstructCommand() { test::put(in_, test::kFork); }

  TempFolder folder_;
  std::string in_ = folder_.file("a.cnt");
  std::string out_ = folder_.file("o.vtu");
};

TEST_F(ReconstructCommand, WritesASolidThatPassesItsCheck) {
  const Outcome made = run({"reconstruct", in_, "-o", out_, "--verify"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("1 component"), std::string::npos) << made.out;
  EXPECT_TRUE(made.err.empty()) << made.err;
  EXPECT_EQ(run({"check", out_, in_}).code, 0);
  EXPECT_EQ(folder_.names().size(), 2U);
}

TEST_F(ReconstructCommand, TellsInJsonWhatTheFileHolds) {
  const JsonValue json = run_json({"reconstruct", in_, "-o", out_});
  const auto model = read_vtu(out_);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(json.at("slices").number, 2);
  EXPECT_EQ(json.at("contours").number, 3);
  EXPECT_EQ(json.at("input_vertices").number, 12);
  EXPECT_EQ(json.at("vertices").number, static_cast<double>(model->points.size()));
  EXPECT_EQ(json.at("tets").number, static_cast<double>(model->tets.size()));
  EXPECT_EQ(json.at("components").number, static_cast<double>(model->component_count));
  EXPECT_NEAR(json.at("volume").number, volume(*model), 1e-9);
  EXPECT_EQ(json.at("split_vertices").kind, JsonValue::Kind::number);
  EXPECT_EQ(json.at("smallest_lift").kind, JsonValue::Kind::number);
  EXPECT_GT(json.at("seconds").at("total").number, 0);
  for (const char* step : {"read", "sections", "delaunay", "correspondence", "complex",
                           "subdivision", "contact", "assembly", "verify", "write"}) {
    EXPECT_EQ(json.at("seconds").at(step).kind, JsonValue::Kind::number) << step;
  }
  EXPECT_TRUE(json.at("rules").has("merge_sheets"));
  EXPECT_EQ(json.at("warnings").kind, JsonValue::Kind::array);
  EXPECT_TRUE(json.at("warnings").array.empty());
  EXPECT_FALSE(json.has("snap"));
}

TEST_F(ReconstructCommand, IsSilentWhenQuiet) {
  const Outcome quiet = run({"reconstruct", in_, "-o", out_, "--quiet"});
  EXPECT_EQ(quiet.code, 0);
  EXPECT_TRUE(quiet.out.empty());
  EXPECT_TRUE(quiet.err.empty());
}

TEST_F(ReconstructCommand, MakesTheSameFileWithAnyNumberOfThreads) {
  ASSERT_EQ(run({"reconstruct", in_, "-o", out_, "--threads", "1"}).code, 0);
  const std::string one = test::get(out_);
  ASSERT_EQ(run({"reconstruct", in_, "-o", out_, "--threads", "3"}).code, 0);
  EXPECT_EQ(test::get(out_), one);
}

TEST_F(ReconstructCommand, MakesTheSameFileWithEitherEngine) {
  ASSERT_EQ(run({"reconstruct", in_, "-o", out_}).code, 0);
  const std::string automatic = test::get(out_);
  for (const char* engine : {"slab", "incremental"}) {
    ASSERT_EQ(run({"reconstruct", in_, "-o", out_, "--delaunay", engine}).code, 0);
    EXPECT_EQ(test::get(out_), automatic);
  }
  expect_failure({"reconstruct", in_, "-o", out_, "--delaunay", "quick"}, 2, "usage", "--delaunay");
}

TEST_F(ReconstructCommand, WritesTheSameModelAsText) {
  ASSERT_EQ(run({"reconstruct", in_, "-o", out_}).code, 0);
  ASSERT_EQ(run({"reconstruct", in_, "-o", folder_.file("t.vtu"), "--ascii"}).code, 0);
  const auto binary = read_vtu(out_);
  const auto text = read_vtu(folder_.file("t.vtu"));
  ASSERT_TRUE(binary.ok() && text.ok());
  test::expect_same(*binary, *text);
  EXPECT_NE(test::get(folder_.file("t.vtu")).find("format=\"ascii\""), std::string::npos);
}

TEST_F(ReconstructCommand, WritesSurfaces) {
  for (const char* name : {"s.obj", "s.ply", "s.vtp", "s.stl"}) {
    const std::string surface = folder_.file(name);
    const Outcome made = run({"reconstruct", in_, "-o", out_, "--surface", surface});
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_GT(std::filesystem::file_size(surface), 100U) << name;
  }
  EXPECT_EQ(folder_.names().size(), 6U);
}

TEST_F(ReconstructCommand, WarnsWhereStlIsTooCoarse) {
  // A tube of width 2^-20 at 1.
  test::put(in_,
            "S 2\nv 4 z 0\n{ 1 0 0x1.000002p0 0 0x1.000002p0 1 1 1 }\n"
            "v 4 z 1\n{ 1 0 0x1.0000008p0 0 0x1.0000008p0 1 1 1 }\n");
  const Outcome made = run({"reconstruct", in_, "-o", out_, "--surface", folder_.file("s.stl")});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.err.find("warning: "), std::string::npos);
  EXPECT_NE(made.err.find("float32"), std::string::npos);
}

TEST_F(ReconstructCommand, RepairsWhereAskedTo) {
  test::put(in_, test::kBowtie);
  const Outcome refused = run({"reconstruct", in_, "-o", out_});
  EXPECT_EQ(refused.code, 3);
  EXPECT_NE(refused.err.find("--repair may mend it"), std::string::npos) << refused.err;
  const Outcome made = run({"reconstruct", in_, "-o", out_, "--repair"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.err.find(in_ + ":3: section 0, contour 0 (5, 5, 0): repaired: crossing"),
            std::string::npos)
      << made.err;
  const JsonValue json = run_json({"reconstruct", in_, "-o", out_, "--repair"});
  EXPECT_EQ(json.at("repair").at("changes").number, 2);
  EXPECT_EQ(json.at("warnings").array.size(), 2U);
  EXPECT_EQ(run({"check", out_, in_, "--repair"}).code, 0);
  EXPECT_EQ(run({"check", out_, in_}).code, 3);
  expect_failure({"reconstruct", in_, "-o", out_ + "2.vtu", "--repair-distance", "1"}, 2, "usage",
                 "--repair");
  expect_failure(
      {"reconstruct", in_, "-o", out_ + "2.vtu", "--repair", "--repair-distance", "1e-300"}, 3,
      "invalid_input", "cannot be repaired");
}

TEST_F(ReconstructCommand, WarnsOfMendedSlips) {
  test::put(in_, "S 3\nv 4 z 0\n{ 0 0 2 0 2 2 0 2 0 0 }\nv 4 z 1\n{ 0 0 2 0 2 2 0 2 }\n");
  const Outcome made = run({"reconstruct", in_, "-o", out_});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.err.find(in_ + ":3: section 0, contour 0"), std::string::npos) << made.err;
  const JsonValue json = run_json({"reconstruct", in_, "-o", out_});
  EXPECT_EQ(json.at("warnings").array.size(), 3U);
  EXPECT_EQ(json.at("warnings").array[0].at("where").at("file").string, in_);
  EXPECT_EQ(json.at("input_vertices").number, 8);
}

TEST_F(ReconstructCommand, MakesASolidOfASingleSection) {
  test::put(in_, "S 1\nv 4 z 5\n{ 0 0 2 0 2 2 0 2 }\n");
  const JsonValue thick = run_json({"reconstruct", in_, "-o", out_, "--thickness", "3"});
  EXPECT_TRUE(thick.at("warnings").array.empty());
  EXPECT_NEAR(thick.at("volume").number, 12, 1e-9);
  const JsonValue unsaid = run_json({"reconstruct", in_, "-o", out_});
  EXPECT_EQ(unsaid.at("warnings").array.size(), 1U);
  EXPECT_NEAR(unsaid.at("volume").number, 0.8, 1e-9);
}

TEST_F(ReconstructCommand, EndsHalfAGapBeyond) {
  test::put(in_, test::kTube);
  const double flat =
      run_json({"reconstruct", in_, "-o", out_, "--ends", "flat"}).at("volume").number;
  const double half =
      run_json({"reconstruct", in_, "-o", out_, "--ends", "half"}).at("volume").number;
  // Two prisms over squares of area 4, each of half a gap.
  EXPECT_NEAR(half - flat, 4, 1e-9);
}

TEST_F(ReconstructCommand, SaysWhatSnappingMoved) {
  test::put(in_,
            "S 2\nv 5 z 0\n{ 0.1 0 2 0 2 2 1.00000001 2 1 2 }\nv 4 z 1\n{ 0 0 2 0 2 2 0 2 }\n");
  const JsonValue json = run_json({"reconstruct", in_, "-o", out_, "--snap", "10"});
  const JsonValue& snap = json.at("snap");
  EXPECT_EQ(snap.at("bits").number, 10);
  EXPECT_EQ(snap.at("moved").number, 3);  // the removed one too
  EXPECT_EQ(snap.at("removed").number, 1);
  EXPECT_EQ(json.at("input_vertices").number, 8);
  ASSERT_EQ(snap.at("first_moved").array.size(), 3U);
  EXPECT_EQ(snap.at("first_moved").array[0].at("from").array[0].number, 0.1);
  const Outcome plain = run({"reconstruct", in_, "-o", out_, "--snap", "10"});
  EXPECT_NE(plain.out.find("3 vertices moved"), std::string::npos) << plain.out;
  EXPECT_EQ(run({"check", out_, in_, "--snap", "10"}).code, 0);
  EXPECT_EQ(run({"check", out_, in_}).code, 1);
}

TEST_F(ReconstructCommand, FollowsLabels) {
  const std::string labels = folder_.file("l.txt");
  test::put(labels, "# the two branches belong apart\n1 0 1\n1 1 2\n");
  const JsonValue json = run_json({"reconstruct", in_, "-o", out_, "--labels", labels});
  EXPECT_EQ(json.at("components").number, 2);
  EXPECT_EQ(run({"check", out_, in_, "--labels", labels}).code, 0);
  EXPECT_EQ(run({"check", out_, in_}).code, 1);
  test::put(labels, "1 0 1\n1 x 2\n");
  expect_failure({"reconstruct", in_, "-o", folder_.file("p.vtu"), "--labels", labels}, 3,
                 "invalid_input", labels + ":2", {folder_.file("p.vtu")});
  test::put(labels, "1 7 1\n");
  expect_failure({"reconstruct", in_, "-o", folder_.file("p.vtu"), "--labels", labels}, 3,
                 "invalid_input", "contour 7", {folder_.file("p.vtu")});
  expect_failure({"reconstruct", in_, "-o", folder_.file("p.vtu"), "--labels", "none.txt"}, 4, "io",
                 "none.txt", {folder_.file("p.vtu")});
}

TEST_F(ReconstructCommand, LeavesTheOldFileWhenItFails) {
  test::put(in_, test::kBowtie);
  test::put(out_, "old");
  const Outcome failed = run({"reconstruct", in_, "-o", out_});
  EXPECT_EQ(failed.code, 3);
  EXPECT_NE(failed.err.find(in_ + ":3: section 0, contour 0, vertex "), std::string::npos)
      << failed.err;
  EXPECT_EQ(test::get(out_), "old");
  EXPECT_EQ(folder_.names().size(), 2U);
}

TEST_F(ReconstructCommand, TellsTheErrorsPlaceInJson) {
  test::put(in_, test::kBowtie);
  const JsonValue json = run_json({"reconstruct", in_, "-o", out_}, 3);
  const JsonValue& where = json.at("error").at("where");
  EXPECT_EQ(where.at("file").string, in_);
  EXPECT_EQ(where.at("line").number, 3);
  EXPECT_EQ(where.at("section").number, 0);
  EXPECT_EQ(where.at("contour").number, 0);
  EXPECT_EQ(where.at("vertex").kind, JsonValue::Kind::number);
  EXPECT_EQ(where.at("point").array.size(), 3U);
}

TEST_F(ReconstructCommand, TellsOfFilesThatCannotBeReadOrWritten) {
  expect_failure({"reconstruct", folder_.file("none.cnt"), "-o", out_}, 4, "io", "none.cnt",
                 {out_});
  expect_failure({"reconstruct", folder_.file(""), "-o", out_}, 2, "usage", "many stacks", {out_});
  expect_failure({"reconstruct", in_, "-o", folder_.file("none/o.vtu")}, 4, "io", "none/o.vtu");
  std::filesystem::create_directory(folder_.file("f.vtu"));
  expect_failure({"reconstruct", in_, "-o", folder_.file("f.vtu")}, 4, "io", "f.vtu");
  expect_failure({"reconstruct", in_, "-o", out_, "--surface", folder_.file("none/s.ply")}, 4, "io",
                 "none/s.ply", {out_});
}

TEST_F(ReconstructCommand, LeavesNoFileWhenTheSurfaceCannotBeWritten) {
  // Beyond float32, which shows only when the surface is written.
  test::put(in_, "S 2\nv 3 z 0\n{ 0 0 1e40 0 0 1e40 }\nv 3 z 1e40\n{ 0 0 1e40 0 0 1e40 }\n");
  expect_failure({"reconstruct", in_, "-o", out_, "--surface", folder_.file("s.stl")}, 3,
                 "invalid_input", "float32", {out_, folder_.file("s.stl")});
  EXPECT_EQ(folder_.names().size(), 1U);
  test::put(out_, "old");
  EXPECT_EQ(run({"reconstruct", in_, "-o", out_, "--surface", folder_.file("s.stl")}).code, 3);
  EXPECT_EQ(test::get(out_), "old");
}

TEST_F(ReconstructCommand, HintsAtRemediesInWarnings) {
  // A square of side 4, and one turned by 45 degrees; then apart from it.
  test::put(in_, "S 2\nv 4 z 0\n{ 0 0 4 0 4 4 0 4 }\nv 4 z 1\n{ 2 -1 5 2 2 5 -1 2 }\n");
  EXPECT_TRUE(run({"reconstruct", in_, "-o", out_}).err.empty());  // it is divided
  const Outcome coarse = run({"reconstruct", in_, "-o", out_, "--no-divide"});
  EXPECT_EQ(coarse.code, 0);
  EXPECT_NE(coarse.err.find("warning: " + in_ + ": contours have few vertices"), std::string::npos)
      << coarse.err;
  EXPECT_TRUE(run({"reconstruct", in_, "-o", out_, "--no-divide", "--refine", "0.5"}).err.empty());
  test::put(in_, "S 2\nv 4 z 0\n{ 0 0 4 0 4 4 0 4 }\nv 4 z 1\n{ 9 0 13 0 13 4 9 4 }\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"reconstruct", in_, "-o", out_}, {"links", in_}}) {
    const JsonValue json = run_json(words);
    ASSERT_EQ(json.at("warnings").array.size(), 1U);
    EXPECT_EQ(
        json.at("warnings").array[0].at("message").string,
        "2 of 2 regions meet none of a neighbouring section, as they lie or as they move: the "
        "gap, 1, over the size of a region, 4, is 0.25; sections are too far apart, or z has "
        "another unit than x and y");
  }
}

TEST_F(ReconstructCommand, DividesCoarseContours) {
  const std::string loft = std::string(TETLOFT_DATA_DIR) + "/cases/loft.cnt";
  const JsonValue divided = run_json({"reconstruct", loft, "-o", out_});
  EXPECT_EQ(divided.at("dividing_vertices").number, 24);
  EXPECT_GT(divided.at("volume").number, 1800);
  EXPECT_EQ(run({"check", out_, loft}).code, 0);
  const JsonValue as_given = run_json({"reconstruct", loft, "-o", out_, "--no-divide"});
  EXPECT_EQ(as_given.at("dividing_vertices").number, 0);
  EXPECT_LT(as_given.at("volume").number, 1600);
  EXPECT_EQ(as_given.at("warnings").array.size(), 1U);
  EXPECT_NE(run({"reconstruct", loft, "-o", out_}).out.find("24 of them to divide coarse ones"),
            std::string::npos);
  expect_failure({"reconstruct", loft, "-o", out_, "--no-divide", "--method", "geiger"}, 2, "usage",
                 "--no-divide");
}

TEST_F(ReconstructCommand, RefinesLongEdges) {
  const std::string bars = std::string(TETLOFT_DATA_DIR) + "/cases/crossed_bars.cnt";
  const JsonValue json = run_json({"reconstruct", bars, "-o", out_, "--refine", "2.5"});
  EXPECT_EQ(json.at("refine").at("inserted").number, 32);
  const Outcome checked = run({"check", out_, bars, "--refine", "2.5"});
  EXPECT_EQ(checked.code, 0);
  EXPECT_NE(checked.out.find("genus of boundary surfaces: 1"), std::string::npos) << checked.out;
  expect_failure({"reconstruct", bars, "-o", out_, "--refine", "0"}, 2, "usage", "--refine");
  expect_failure({"reconstruct", bars, "-o", out_, "--refine", "1e-9"}, 2, "usage", "2^26");
}

}  // namespace
}  // namespace tetloft
