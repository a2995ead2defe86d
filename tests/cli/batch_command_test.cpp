// reconstruct of a folder, or of a list: which stacks, what is written, and what is done again.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/batch_folders.hpp"

namespace tetloft {
namespace {

namespace fs = std::filesystem;

using test::expect_failure;
using test::get;
using test::JsonValue;
using test::kBowtie;
using test::kFork;
using test::kTube;
using test::put;
using test::run;
using test::run_json;

class BatchCommand : public test::BatchFolders {};

using Fates = std::map<std::string, std::string>;

TEST_F(BatchCommand, MakesTheSolidOfEachStackAsIfItWereAlone) {
  put(in_ + "/README.md", "no stack\n");
  put(in_ + "/.hidden.cnt", kTube);
  fs::create_directory(in_ + "/deeper");
  put(in_ + "/deeper/further.cnt", kTube);
  std::map<std::string, std::string> bytes;
  for (const char* threads : {"1", "3"}) {
    fs::remove_all(out_);
    const JsonValue told = batch({"--between", "none", "--threads", threads});
    EXPECT_EQ(fates(told), (Fates{{"fork", "done"}, {"leaning", "done"}, {"tube", "done"}}));
    EXPECT_EQ(told.at("done").number, 3);
    EXPECT_EQ(told.at("stacks").array.at(2).at("volume").number, 4);
    EXPECT_EQ(told.at("left_out").array.size(), 1U);
    EXPECT_EQ(lines().size(), 3U);
    for (const char* name : {"fork", "leaning", "tube"}) {
      const std::string alone = folder_.file("alone.vtu");
      EXPECT_EQ(run({"reconstruct", stack(name), "-o", alone, "--between", "none"}).code, 0);
      EXPECT_EQ(get(alone), get(solid(name))) << name;
    }
  }
  const test::Outcome plain = run({"reconstruct", in_, "-o", out_ + "/"});
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_NE(plain.out.find("3 stacks: 3 done, 0 skipped"), std::string::npos) << plain.out;
  EXPECT_NE(plain.out.find("1 file of the folder left out"), std::string::npos) << plain.out;
}

TEST_F(BatchCommand, KeepsFailuresApartAndTriesThemAgain) {
  put(stack("bowtie"), kBowtie);
  const test::Outcome first = run({"reconstruct", in_, "-o", out_});
  EXPECT_EQ(first.code, 3);
  EXPECT_NE(first.err.find("bowtie.cnt"), std::string::npos) << first.err;
  EXPECT_FALSE(fs::exists(solid("bowtie")));
  EXPECT_EQ(
      fates(batch({}, 3)),
      (Fates{
          {"bowtie", "failed"}, {"fork", "skipped"}, {"leaning", "skipped"}, {"tube", "skipped"}}));
  put(stack("bowtie"), kFork);
  EXPECT_EQ(fates(batch()).at("bowtie"), "done");
  EXPECT_EQ(get(solid("bowtie")), get(solid("fork")));
}

TEST_F(BatchCommand, SkipsByContentAndNotByDate) {
  EXPECT_EQ(batch().at("done").number, 3);
  const std::string made = get(solid("tube"));
  // Later than its solid, and the same.
  fs::last_write_time(stack("tube"), fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_EQ(batch().at("skipped").number, 3);
  EXPECT_EQ(lines().size(), 3U);
  // Of the same size and date, and another.
  const auto date = fs::last_write_time(stack("fork"));
  std::string other = kFork;
  other.replace(other.find("z 1"), 3, "z 2");
  put(stack("fork"), other);
  fs::last_write_time(stack("fork"), date);
  EXPECT_EQ(fates(batch()), (Fates{{"fork", "done"}, {"leaning", "skipped"}, {"tube", "skipped"}}));
  // Solids that are gone, or damaged.
  std::string damaged = made;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  put(solid("tube"), damaged);
  fs::remove(solid("leaning"));
  EXPECT_EQ(fates(batch()), (Fates{{"fork", "skipped"}, {"leaning", "done"}, {"tube", "done"}}));
  EXPECT_EQ(get(solid("tube")), made);
  // Other options make other solids; how many threads make them does not.
  EXPECT_EQ(batch({"--threads", "2", "--quiet"}).at("skipped").number, 3);
  EXPECT_EQ(batch({"--ends", "half"}).at("done").number, 3);
  EXPECT_EQ(batch({"--ends", "half"}).at("skipped").number, 3);
  EXPECT_EQ(batch().at("done").number, 3);
}

TEST_F(BatchCommand, TakesTheStacksOfAList) {
  fs::create_directory(folder_.file("a"));
  fs::create_directory(folder_.file("b"));
  put(folder_.file("a/x.cnt"), kTube);
  put(folder_.file("b/X.cnt"), kFork);
  const std::string list = folder_.file("stacks.list");
  put(list, "\xEF\xBB\xBF# two of one name\n" + folder_.file("a/x.cnt") + "\r\n\n" +
                folder_.file("b/X.cnt") + "\n  # and one that is not there\n" + stack("missing") +
                '\n' + stack("tube"));
  const JsonValue told = run_json({"reconstruct", list, "-o", out_}, 4);
  EXPECT_EQ(told.at("done").number, 3);
  EXPECT_EQ(told.at("stacks").array.at(2).at("error").at("code").string, "io");
  EXPECT_EQ(get(out_ + "/a-x.vtu"), get(solid("tube")));
  EXPECT_TRUE(fs::exists(out_ + "/b-X.vtu"));
  const test::Outcome plain = run({"reconstruct", list, "-o", out_});
  EXPECT_NE(plain.err.find("missing.cnt: cannot be opened: No such file"), std::string::npos)
      << plain.err;
  // The same under another name.
  const std::string text = folder_.file("stacks.txt");
  fs::rename(list, text);
  EXPECT_EQ(run_json({"reconstruct", text, "--list", "-o", out_}, 4).at("skipped").number, 3);
  put(list, in_);
  const JsonValue folder = run_json({"reconstruct", list, "-o", out_}, 4);
  EXPECT_NE(
      folder.at("stacks").array.at(0).at("error").at("message").string.find("no regular file"),
      std::string::npos);
  put(list, stack("tube") + '\n' + stack("tube") + '\n');
  expect_failure({"reconstruct", list, "-o", out_}, 3, "invalid_input", "stacks.list:2: ");
  put(list, "# nothing\n");
  expect_failure({"reconstruct", list, "-o", out_}, 3, "invalid_input", "no stack");
}

TEST_F(BatchCommand, NamesStacksOfOneStemByTheirExtensions) {
  EXPECT_EQ(run({"convert", stack("tube"), "-o", in_ + "/tube.csl"}).code, 0);
  EXPECT_EQ(batch().at("done").number, 4);
  EXPECT_TRUE(fs::exists(out_ + "/tube.cnt.vtu"));
  EXPECT_TRUE(fs::exists(out_ + "/tube.csl.vtu"));
  EXPECT_TRUE(fs::exists(solid("fork")));
}

TEST_F(BatchCommand, WritesTheFormatThatIsAskedFor) {
  const JsonValue told = batch({"--to", "tetgen"});
  EXPECT_EQ(told.at("stacks").array.at(0).at("written").array.size(), 3U);
  EXPECT_TRUE(fs::exists(out_ + "/tube.ele"));
  EXPECT_EQ(batch({"--to", "tetgen"}).at("skipped").number, 3);
  fs::remove(out_ + "/tube.node");
  EXPECT_EQ(fates(batch({"--to", "tetgen"})).at("tube"), "done");
  EXPECT_EQ(batch({"--to", "stl"}).at("done").number, 3);
  const std::string alone = folder_.file("alone.stl");
  EXPECT_EQ(run({"reconstruct", stack("fork"), "--surface", alone}).code, 0);
  EXPECT_EQ(get(alone), get(out_ + "/fork.stl"));
}

// 4 x 4 x 2 voxels, a block of ones in each slice, in a file of their own.
TEST_F(BatchCommand, KnowsTheDataOfAVolumeAsPartOfIt) {
  for (const char* name : {"fork", "leaning", "tube"}) fs::remove(stack(name));
  std::string voxels(32, '\1');
  for (const std::size_t at : {0U, 1U, 2U, 3U, 16U, 17U, 18U, 19U}) voxels[at] = '\2';
  // A name, too, by which it would be taken for a stack.
  const std::string data = in_ + "/grid.img";
  put(data, voxels);
  put(in_ + "/grid.mhd",
      "ObjectType = Image\nNDims = 3\nDimSize = 4 4 2\nElementType = MET_UCHAR\n"
      "ElementSpacing = 1 1 1\nElementDataFile = grid.img\n");
  const JsonValue told = batch({"--label", "1"});
  ASSERT_EQ(told.at("stacks").array.size(), 1U);
  EXPECT_TRUE(told.at("left_out").array.empty());
  ASSERT_EQ(lines().at(0).at("read").array.size(), 2U);
  EXPECT_EQ(lines().at(0).at("read").array.at(1).at("file").string, data);
  EXPECT_EQ(batch({"--label", "1"}).at("skipped").number, 1);
  voxels[4] = '\2';
  put(data, voxels);
  EXPECT_EQ(batch({"--label", "1"}).at("done").number, 1);
}

TEST_F(BatchCommand, RefusesWhatIsOfOneStack) {
  for (const char* option : {"--surface", "--repaired", "--labels"}) {
    expect_failure({"reconstruct", in_, "-o", out_, option, folder_.file("a.stl")}, 2, "usage",
                   option, {out_});
  }
  expect_failure({"reconstruct", in_, "-o", out_, "--method", "geiger"}, 2, "usage", "geiger",
                 {out_});
  expect_failure({"reconstruct", in_, "-o", out_, "--roi", "all"}, 2, "usage", "--roi", {out_});
  expect_failure({"reconstruct", in_, "-o", out_, "--plan", "p", "--slabs", "0:1"}, 2, "usage",
                 "--plan", {out_});
  expect_failure({"reconstruct", in_}, 2, "usage", "FOLDER");
  expect_failure({"reconstruct", in_, "-o", stack("tube")}, 2, "usage", "no folder");
  expect_failure({"reconstruct", in_, "-o", folder_.file("no/such")}, 4, "io", "folder");
  expect_failure({"reconstruct", stack("tube"), "-o", folder_.file("a.vtu"), "--to", "vtu"}, 2,
                 "usage", "many stacks");
  expect_failure({"reconstruct", in_, "-o", out_, "--log", stack("tube")}, 2, "usage",
                 "one of the inputs", {out_});
  EXPECT_EQ(get(stack("tube")), kTube);
  fs::create_directory(folder_.file("empty"));
  expect_failure({"reconstruct", folder_.file("empty"), "-o", out_}, 3, "invalid_input",
                 "recognised", {out_});
}

TEST_F(BatchCommand, OverwritesNoInput) {
  // Of .vtp are stacks and boundaries.
  const std::string there = in_ + "/lines.vtp";
  EXPECT_EQ(run({"convert", stack("tube"), "-o", there}).code, 0);
  const std::string before = get(there);
  expect_failure({"reconstruct", in_, "-o", in_, "--to", "vtp"}, 2, "usage", "would overwrite",
                 {in_ + "/tube.vtp"});
  EXPECT_EQ(get(there), before);
  // Nor the voxels of one, whatever they are called.
  const std::string voxels(32, '\1');
  put(in_ + "/tube.vtu", voxels);
  put(in_ + "/grid.mhd",
      "ObjectType = Image\nNDims = 3\nDimSize = 4 4 2\nElementType = MET_UCHAR\n"
      "ElementSpacing = 1 1 1\nElementDataFile = tube.vtu\n");
  expect_failure({"reconstruct", in_, "-o", in_, "--label", "1"}, 2, "usage", "would overwrite");
  EXPECT_EQ(get(in_ + "/tube.vtu"), voxels);
  fs::remove(in_ + "/grid.mhd");
  fs::remove(in_ + "/tube.vtu");
  // Beside its inputs a solid is none of them, nor is the log.
  EXPECT_EQ(run_json({"reconstruct", in_, "-o", in_}).at("done").number, 4);
  EXPECT_EQ(run_json({"reconstruct", in_, "-o", in_}).at("skipped").number, 4);
}

}  // namespace
}  // namespace tetloft
