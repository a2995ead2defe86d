// Stacks that need mending, from the file to a model that check finds right: options, what is told,
// and the mended stack as a file.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

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

using Words = std::vector<std::string>;

const std::string kOverlap =
    "S 2\nv 8 z 0\n{ 0 0 10 0 10 10 0 10 }\n{ 6 3 16 3 16 13 6 13 }\n"
    "v 8 z 3\n{ 0 0 10 0 10 10 0 10 }\n{ 6 3 16 3 16 13 6 13 }\n";
const std::string kKeyhole =
    "S 2\n"
    "v 12 z 0\n{ 0 0 10 0 10 4.9 7 4.9 7 3 3 3 3 7 7 7 7 5.1 10 5.1 10 10 0 10 }\n"
    "v 12 z 3\n{ 0 0 10 0 10 4.9 7 4.9 7 3 3 3 3 7 7 7 7 5.1 10 5.1 10 10 0 10 }\n";
const std::string kDescending = "S 2\nv 4 z 1\n{ 0 0 2 0 2 2 0 2 }\nv 4 z 0\n{ 0 0 2 0 2 2 0 2 }\n";
const std::string kSplit =
    "S 3\nv 4 z 1\n{ 5 0 7 0 7 2 5 2 }\nv 8 z 0\n{ 0 0 2 0 2 2 0 2 }\n{ 5 0 7 0 7 2 5 2 }\n"
    "v 4 z 1.0001\n{ 0 0 2 0 2 2 0 2 }\n";

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

class MendingCommand : public testing::Test {
 protected:
  [[nodiscard]] Words reconstruct(const Words& options) const {
    return Words{"reconstruct", in_, "-o", out_} + options;
  }

  // Reconstructs with these options, and expects the model right for the input mended likewise and
  // for the mended stack that was written. Returns what was told.
  [[nodiscard]] JsonValue made(const std::string& in, const Words& options) const {
    JsonValue told =
        run_json(Words{"reconstruct", in, "-o", out_, "--repaired", mended_} + options);
    EXPECT_EQ(run(Words{"check", out_, in} + options).code, 0);
    const Outcome checked = run({"check", out_, mended_});
    EXPECT_EQ(checked.code, 0) << checked.err;
    return told;
  }

  TempFolder folder_;
  std::string in_ = folder_.file("in.cnt");
  std::string out_ = folder_.file("out.vtu");
  std::string mended_ = folder_.file("mended.cnt");
};

TEST_F(MendingCommand, FillRulesSayWhatOverlapsAre) {
  test::put(in_, kOverlap);
  const JsonValue united = made(in_, {"--fill", "union"});
  EXPECT_EQ(united.at("volume").number, 516);
  EXPECT_EQ(united.at("components").number, 1);
  EXPECT_EQ(united.at("repair").at("fill").string, "union");
  EXPECT_EQ(united.at("repair").at("area_before").number, 344);
  EXPECT_EQ(united.at("repair").at("area_after").number, 344);
  EXPECT_EQ(read_cnt(mended_).value().stack.contour_count(), 2U);
  EXPECT_EQ(made(in_, {"--repair", "--fill=winding"}).at("volume").number, 516);
  const JsonValue odd = made(in_, {"--repair"});
  EXPECT_EQ(odd.at("components").number, 2);
  EXPECT_NEAR(odd.at("volume").number, 432, 0.01);
  const Outcome told = run(reconstruct({"--repair"}));
  EXPECT_NE(told.err.find("overlaps contour 1, and what lies in both is left out"),
            std::string::npos);
  EXPECT_NE(told.out.find("area 288 before"), std::string::npos) << told.out;
  expect_failure(reconstruct({"--fill", "even"}), 2, "usage", "--fill");
}

TEST_F(MendingCommand, WhatVanishesIsToldAndNoModelIsEmpty) {
  const std::string halves = "{ 0 0 1 0 1 1 0 1 }\n{ 1 0 2 0 2 1 1 1 }\n{ 0 0 2 0 2 1 0 1 }\n";
  test::put(in_,
            "S 2\nv 16 z 0\n" + halves + "{ 5 0 7 0 7 2 5 2 }\nv 4 z 1\n{ 5 0 7 0 7 2 5 2 }\n");
  const JsonValue some = made(in_, {"--repair"});
  ASSERT_EQ(some.at("repair").at("lost").array.size(), 3U);
  EXPECT_EQ(some.at("repair").at("lost").array[2].at("section").number, 0);
  EXPECT_EQ(some.at("repair").at("lost").array[2].at("contour").number, 2);
  EXPECT_EQ(some.at("repair").at("lost").array[2].at("area").number, 2);
  const Outcome told = run(reconstruct({"--repair"}));
  EXPECT_NE(told.err.find("NOTHING IS LEFT of this contour"), std::string::npos) << told.err;
  EXPECT_NE(told.out.find("NOTHING IS LEFT of 3 contours"), std::string::npos) << told.out;
  test::put(in_, "S 2\nv 12 z 0\n" + halves + "v 12 z 1\n" + halves);
  const std::string none = folder_.file("none.vtu");
  expect_failure({"reconstruct", in_, "-o", none, "--repair", "--repaired", folder_.file("n.cnt")},
                 3, "invalid_input", "no contour", {none, folder_.file("n.cnt")});
  expect_failure({"reconstruct", folder_.file("in.cnt"), "-o", none}, 3, "invalid_input",
                 "--repair may mend it", {none});
}

TEST_F(MendingCommand, KeyholesAreClosedUpToTheWidth) {
  test::put(in_, kKeyhole);
  const JsonValue closed = made(in_, {"--keyholes", "0.25"});
  EXPECT_EQ(closed.at("repair").at("channels").number, 2);
  EXPECT_NEAR(closed.at("volume").number, 252, 1e-9);
  EXPECT_EQ(run_json({"check", out_, mended_}).at("genus").array[0].number, 1);
  const JsonValue left = made(in_, {"--keyholes", "0.15"});
  EXPECT_EQ(left.at("repair").at("channels").number, 0);
  expect_failure(reconstruct({"--keyholes", "0"}), 2, "usage", "above 0");
}

TEST_F(MendingCommand, PlanesArePutInOrder) {
  test::put(in_, kDescending);
  for (const char* rule : {"sort", "flip", "merge=0.5"}) {
    const JsonValue told = made(in_, {"--planes", rule});
    EXPECT_EQ(told.at("volume").number, 4);
    EXPECT_EQ(told.at("planes").at("sections_before").number, 2);
  }
  expect_failure(reconstruct({}), 3, "invalid_input", "(--planes flip does that)");
  expect_failure(reconstruct({"--repair"}), 3, "invalid_input", "(--planes flip does that)");
  test::put(in_, kSplit);
  expect_failure(reconstruct({}), 3, "invalid_input", "(--planes sort does that)");
  expect_failure(reconstruct({"--planes", "flip"}), 3, "invalid_input", "does not decrease");
  const JsonValue merged = made(in_, {"--planes", "merge=0.001"});
  EXPECT_EQ(merged.at("slices").number, 2);
  EXPECT_EQ(merged.at("components").number, 2);
  EXPECT_EQ(merged.at("volume").number, 8);
  ASSERT_EQ(merged.at("warnings").array.size(), 1U);
  EXPECT_NE(merged.at("warnings").array[0].at("message").string.find("sections 0 and 2 are one"),
            std::string::npos);
  EXPECT_EQ(made(in_, {"--planes", "sort"}).at("slices").number, 3);
}

TEST_F(MendingCommand, LinesOfTheFileAreToldWhereSectionsMoved) {
  test::put(in_, "S 2\nv 4 z 1\n{ 0 0 2 2 2 0 0 2 }\nv 4 z 0\n{ 0 0 2 0 2 2 0 2 }\n");
  const Outcome refused = run(reconstruct({"--planes", "flip"}));
  EXPECT_EQ(refused.code, 3);
  EXPECT_NE(refused.err.find(in_ + ":3: section 1, contour 0"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--repair may mend it"), std::string::npos) << refused.err;
  const Outcome repaired = run(reconstruct({"--planes", "flip", "--repair"}));
  EXPECT_EQ(repaired.code, 0);
  EXPECT_NE(repaired.err.find(in_ + ":3: section 1, contour 0"), std::string::npos) << repaired.err;
}

TEST_F(MendingCommand, LabelsAreOfTheArrangedStack) {
  test::put(in_,
            "S 3\nv 4 z 2\n{ 0 0 2 0 2 2 0 2 }\nv 4 z 1\n{ 9 0 11 0 11 2 9 2 }\n"
            "v 4 z 0\n{ 0 0 2 0 2 2 0 2 }\n");
  const std::string labels = folder_.file("l.labels");
  test::put(labels, "part 1 0 0\npart 0 0 0\n");
  EXPECT_EQ(run(reconstruct({"--planes", "sort", "--labels", labels})).code, 0);
  // Written as it is worked on, beside the links.
  EXPECT_EQ(run({"links", in_, "--planes", "flip", "--repaired", mended_}).code, 0);
  EXPECT_EQ(read_cnt(mended_).value().stack.sections[SectionId(2)].z, 2);
}

TEST_F(MendingCommand, OptionsThatMakeNoSenseAreRefused) {
  test::put(in_, kOverlap);
  for (const char* bad : {"merge", "sort=1", "merge=0", "merge=x", "up", "merge=-1", "merge=nan"}) {
    expect_failure(reconstruct({"--planes", bad}), 2, "usage", "--planes");
  }
  expect_failure(reconstruct({"--repair", "--repaired", in_}), 2, "usage", "overwrite");
  expect_failure(reconstruct({"--repair", "--repaired", folder_.file("m.vtu")}), 2, "usage",
                 "must end in");
  expect_failure(reconstruct({"--repair", "--repaired", folder_.file("no/m.cnt")}), 4, "io",
                 "folder");
  expect_failure(reconstruct({"--repair-distance", "1"}), 2, "usage", "--repair");
}

TEST_F(MendingCommand, TheMendedStackIsWrittenSnappedAndRefinedToo) {
  test::put(in_, kOverlap);
  const JsonValue told = made(in_, {"--fill", "union", "--snap", "12", "--refine", "2"});
  EXPECT_EQ(told.at("volume").number, 516);
  EXPECT_GT(read_cnt(mended_).value().stack.vertex_count(), 40U);
  EXPECT_EQ(run({"reconstruct", in_, "-o", out_, "--method", "geiger", "--fill", "union",
                 "--repaired", mended_})
                .code,
            0);
  EXPECT_EQ(read_cnt(mended_).value().stack.vertex_count(), 16U);
}

// The rows of the folder about overlapping, keyhole, planes and ends.
struct Reported {
  const char* file;
  Words options;
  double volume;
  double tolerance;
  double components;
  double genus;  // of the first boundary surface
};

TEST_F(MendingCommand, WhatWasReportedComesOutAsWanted) {
  const std::filesystem::path folder = std::filesystem::path(TETLOFT_SHARED_DATA_DIR) / "reported";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  const std::vector<Reported> rows{
      {"overlapping_dup_min", {"--repair"}, 300, 1e-9, 1, 0},
      {"overlapping_dup_min2", {"--repair"}, 600, 1e-9, 1, 0},
      {"overlapping_near_min", {"--repair"}, 300, 0.1, 1, 0},
      {"overlapping_near_min", {"--fill", "union"}, 300, 0.1, 1, 0},
      {"overlapping_overlap_min", {"--fill", "union"}, 516, 1e-9, 1, 0},
      {"overlapping_overlap_min", {"--fill", "winding"}, 516, 1e-9, 1, 0},
      {"keyhole_zero", {"--repair"}, 18206, 1, 1, 1},
      {"keyhole_zero", {"--keyholes", "0.01"}, 18206, 1, 1, 1},
      {"keyhole_two", {"--repair"}, 23398, 1, 1, 2},
      {"keyhole_two", {"--keyholes", "0.01"}, 23398, 1, 1, 2},
      {"keyhole_thin", {"--keyholes", "0.001"}, 18206, 1, 1, 1},
      {"keyhole_thin", {"--keyholes", "0.5"}, 18206, 1, 1, 1},
      {"planes_desc", {"--planes", "flip"}, 11725.1, 0.1, 2, 0},
      {"planes_desc", {"--planes", "sort"}, 11725.1, 0.1, 2, 0},
      {"planes_mixed", {"--planes", "sort"}, 11725.1, 0.1, 2, 0},
      {"planes_samez", {"--planes", "sort"}, 7816.72, 0.1, 2, 0},
      {"planes_split", {"--planes", "merge=0.001"}, 11725.1, 0.1, 2, 0},
  };
  for (const Reported& row : rows) {
    SCOPED_TRACE(row.file + row.options.front());
    const std::string file = (folder / row.file).string() + ".cnt";
    const JsonValue told = made(file, row.options);
    EXPECT_NEAR(told.at("volume").number, row.volume, row.tolerance);
    EXPECT_EQ(told.at("components").number, row.components);
    const JsonValue checked = run_json({"check", out_, mended_});
    EXPECT_EQ(checked.at("genus").array.size(), static_cast<std::size_t>(row.components));
    EXPECT_EQ(checked.at("genus").array[0].number, row.genus);
  }
  const Outcome split = run({"reconstruct", (folder / "planes_split.cnt").string(), "-o", out_});
  EXPECT_NE(split.err.find("(--planes merge=TOL does that)"), std::string::npos) << split.err;
  for (const char* file : {"planes_desc", "planes_mixed", "planes_samez"}) {
    expect_failure({"reconstruct", (folder / file).string() + ".cnt", "-o", folder_.file("x.vtu")},
                   3, "invalid_input", "(--planes ");
  }
  const std::string empty = (folder / "ends_allempty.cnt").string();
  for (const Words& options : {Words{}, Words{"--repair"}}) {
    expect_failure(Words{"reconstruct", empty, "-o", folder_.file("x.vtu")} + options, 3,
                   "invalid_input", "no contour", {folder_.file("x.vtu")});
  }
}

}  // namespace
}  // namespace tetloft
