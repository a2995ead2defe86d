// reconstruct of a folder, or of a list: which stacks, what is written, the log, and going on.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "cli/runner.hpp"

extern char** environ;

namespace tetloft {
namespace {

namespace fs = std::filesystem;

using test::expect_failure;
using test::get;
using test::JsonValue;
using test::kBowtie;
using test::kFork;
using test::kLeaning;
using test::kTube;
using test::put;
using test::run;
using test::run_json;
using test::TempFolder;

class BatchCommand : public ::testing::Test {
 protected:
  BatchCommand() {
    fs::create_directory(in_);
    put(stack("fork"), kFork);
    put(stack("leaning"), kLeaning);
    put(stack("tube"), kTube);
  }

  [[nodiscard]] std::string stack(const std::string& name) const {
    return in_ + '/' + name + ".cnt";
  }
  [[nodiscard]] std::string solid(const std::string& name) const {
    return out_ + '/' + name + ".vtu";
  }
  [[nodiscard]] std::string log() const { return out_ + "/tetloft.jsonl"; }
  [[nodiscard]] std::vector<JsonValue> lines() const {
    std::vector<JsonValue> lines;
    const std::string all = get(log());
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t end = all.find('\n', at);
      EXPECT_NE(end, std::string::npos) << "the last line has no end";
      if (end == std::string::npos) break;
      const auto value = test::parse_json(all.substr(at, end - at));
      EXPECT_TRUE(value.has_value()) << all.substr(at, end - at);
      lines.push_back(value.value_or(JsonValue{}));
      at = end + 1;
    }
    return lines;
  }
  // By name, what became of each.
  [[nodiscard]] static std::map<std::string, std::string> fates(const JsonValue& told) {
    std::map<std::string, std::string> fates;
    for (const JsonValue& one : told.at("stacks").array) {
      fates[fs::path(one.at("input").string).stem().string()] = one.at("outcome").string;
    }
    return fates;
  }
  [[nodiscard]] JsonValue batch(std::vector<std::string> options = {}, int code = 0) const {
    options.insert(options.begin(), {"reconstruct", in_, "-o", out_});
    return run_json(options, code);
  }

  TempFolder folder_;
  std::string in_ = folder_.file("in");
  std::string out_ = folder_.file("out");
};

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

TEST_F(BatchCommand, LogsWhatEachWasMadeOf) {
  put(stack("bowtie"), kBowtie);
  EXPECT_EQ(fates(batch({"--threads", "1"}, 3)).at("bowtie"), "failed");
  const std::vector<JsonValue> all = lines();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].at("input").string, stack("bowtie"));
  EXPECT_EQ(all[0].at("outcome").string, "failed");
  EXPECT_EQ(all[0].at("error").at("code").string, "invalid_input");
  EXPECT_EQ(all[0].at("error").at("where").at("line").number, 3);
  EXPECT_EQ(all[0].at("read").array.at(0).at("bytes").number, static_cast<double>(kBowtie.size()));
  const JsonValue& tube = all[3];
  EXPECT_EQ(tube.at("read").array.at(0).at("checksum").string.size(), 16U);
  EXPECT_EQ(tube.at("written").array.at(0).at("file").string, solid("tube"));
  EXPECT_EQ(tube.at("written").array.at(0).at("bytes").number,
            static_cast<double>(fs::file_size(solid("tube"))));
  EXPECT_EQ(tube.at("options").string, all[0].at("options").string);
  EXPECT_EQ(tube.at("slices").number, 2);
  EXPECT_EQ(tube.at("volume").number, 4);
  EXPECT_GE(tube.at("seconds").number, 0);
  EXPECT_TRUE(tube.has("warnings"));
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

TEST_F(BatchCommand, GoesOnWhereTheFoldersWereMoved) {
  EXPECT_EQ(batch().at("done").number, 3);
  const std::string in = folder_.file("in2"), out = folder_.file("out2");
  fs::rename(in_, in);
  fs::rename(out_, out);
  EXPECT_EQ(run_json({"reconstruct", in, "-o", out}).at("skipped").number, 3);
}

TEST_F(BatchCommand, CutsOffALineThatWasInterrupted) {
  EXPECT_EQ(batch().at("done").number, 3);
  const std::string whole = get(log());
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (const std::size_t left : {std::size_t{1}, std::size_t{8}, whole.size() - 1 - last}) {
    put(log(), whole.substr(0, last + left));
    const JsonValue told = batch();
    EXPECT_EQ(told.at("skipped").number, 2);
    EXPECT_EQ(told.at("done").number, 1);
    EXPECT_EQ(lines().size(), 3U);
  }
}

TEST_F(BatchCommand, LeavesAloneWhatIsNoLog) {
  for (const char* text : {"notes\n", "notes", "{\"a\":1}\n", "[1]\n", "{\"tetloft\":3}\n"}) {
    const std::string file = folder_.file("notes.txt");
    put(file, text);
    expect_failure({"reconstruct", in_, "-o", out_, "--log", file}, 3, "invalid_input",
                   "notes.txt:1: ", {solid("tube")});
    EXPECT_EQ(get(file), text);
  }
}

TEST_F(BatchCommand, TakesTheStacksOfAList) {
  fs::create_directory(folder_.file("a"));
  fs::create_directory(folder_.file("b"));
  put(folder_.file("a/x.cnt"), kTube);
  put(folder_.file("b/X.cnt"), kFork);
  const std::string list = folder_.file("stacks.list");
  put(list, "# two of one name\n" + folder_.file("a/x.cnt") + "\r\n\n" + folder_.file("b/X.cnt") +
                "\n  # and one that is not there\n" + stack("missing") + '\n' + stack("tube"));
  const JsonValue told = run_json({"reconstruct", list, "-o", out_}, 4);
  EXPECT_EQ(told.at("done").number, 3);
  EXPECT_EQ(told.at("stacks").array.at(2).at("error").at("code").string, "io");
  EXPECT_EQ(get(out_ + "/a-x.vtu"), get(solid("tube")));
  EXPECT_TRUE(fs::exists(out_ + "/b-X.vtu"));
  // The same under another name.
  const std::string text = folder_.file("stacks.txt");
  fs::rename(list, text);
  EXPECT_EQ(run_json({"reconstruct", text, "--list", "-o", out_}, 4).at("skipped").number, 3);
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
  // Beside its inputs a solid is none of them, nor is the log.
  EXPECT_EQ(run_json({"reconstruct", in_, "-o", in_}).at("done").number, 4);
  EXPECT_EQ(run_json({"reconstruct", in_, "-o", in_}).at("skipped").number, 4);
}

TEST_F(BatchCommand, IsOneAtATimeForALog) {
  EXPECT_EQ(batch().at("done").number, 3);
  const int held = open(log().c_str(), O_RDWR);
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  ASSERT_EQ(fcntl(held, F_SETLK, &lock), 0);
  const JsonValue told = batch({}, 4);
  EXPECT_NE(told.at("error").at("message").string.find("at work"), std::string::npos);
  close(held);
}

// Of enough vertices that there is time to be killed in.
std::string round_stack(int number) {
  constexpr int kVertices = 200;
  std::string text = "S 4\n";
  for (int s = 0; s < 4; ++s) {
    text += "v " + std::to_string(kVertices) + " z " + std::to_string(s) + "\n{\n";
    for (int v = 0; v < kVertices; ++v) {
      const double angle = 6.283185307179586 * v / kVertices;
      const double r = 10 + std::sin((number + 2) * angle + s);
      text +=
          std::to_string(r * std::cos(angle)) + ' ' + std::to_string(r * std::sin(angle)) + '\n';
    }
    text += "}\n";
  }
  return text;
}

TEST_F(BatchCommand, KilledItLeavesWholeSolidsAndGoesOn) {
  constexpr int kStacks = 8;
  for (int i = 0; i < kStacks; ++i) put(stack("round" + std::to_string(i)), round_stack(i));
  const std::string reference = folder_.file("reference");
  ASSERT_EQ(run({"reconstruct", in_, "-o", reference}).code, 0);
  std::map<std::string, std::string> expected;
  for (const auto& file : fs::directory_iterator(reference)) {
    if (file.path().extension() == ".vtu") {
      expected[file.path().filename().string()] = get(file.path().string());
    }
  }
  ASSERT_EQ(expected.size(), kStacks + 3U);
  std::vector<std::string> words{TETLOFT_EXECUTABLE, "reconstruct", in_, "-o", out_, "--quiet"};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int killed = 0;
  std::set<std::string> logged;
  for (const int number : {SIGKILL, SIGTERM, SIGKILL, SIGINT}) {
    pid_t child = 0;
    ASSERT_EQ(posix_spawn(&child, TETLOFT_EXECUTABLE, nullptr, nullptr, argv.data(), environ), 0);
    // Once it has made one more, whatever the speed of the machine.
    const auto size = [&] {
      std::error_code code;
      const auto bytes = fs::file_size(log(), code);
      return code ? std::uintmax_t{0} : bytes;
    };
    const std::uintmax_t before = size();
    int status = 0;
    while (size() == before && waitpid(child, &status, WNOHANG) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(child, number);
    waitpid(child, &status, 0);
    killed += WIFSIGNALED(status) ? 1 : 0;
    for (const auto& file : fs::directory_iterator(out_)) {
      const std::string name = file.path().filename().string();
      if (name == "tetloft.jsonl") continue;
      // Only the signal that nothing can catch may leave a whole file under another name.
      if (number == SIGKILL && file.path().extension() != ".vtu") continue;
      ASSERT_TRUE(expected.count(name)) << name;
      EXPECT_EQ(get(file.path().string()), expected[name]) << name;
    }
  }
  EXPECT_GT(killed, 0);
  const std::size_t made = lines().size();
  EXPECT_GT(made, 0U);
  const JsonValue told = batch();
  EXPECT_GE(told.at("skipped").number, 1);
  EXPECT_EQ(told.at("skipped").number + told.at("done").number, kStacks + 3);
  for (const auto& [name, bytes] : expected) EXPECT_EQ(get(out_ + '/' + name), bytes) << name;
  EXPECT_EQ(batch().at("skipped").number, kStacks + 3);
}

TEST_F(BatchCommand, EndsWhereTheLogCannotBeWritten) {
  // A limit of the size of files stands for a full disk: solids are below it, the log is not.
  const std::string before = "{\"tetloft\":\"0\",\"note\":\"" + std::string(100'000, 'x') + "\"}\n";
  fs::create_directory(out_);
  put(log(), before);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{before.size() + 10, limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const test::Outcome outcome = run({"reconstruct", in_, "-o", out_, "--threads", "1"});
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_NE(outcome.err.find("tetloft.jsonl: cannot be written"), std::string::npos) << outcome.err;
  EXPECT_EQ(get(log()), before);
  EXPECT_TRUE(fs::exists(solid("fork")));
  EXPECT_FALSE(fs::exists(solid("leaning")));
  EXPECT_EQ(batch().at("done").number, 3);
}

TEST_F(BatchCommand, WritesItsLogWhereItIsAskedTo) {
  const std::string beside = out_ + "/log.jsonl";
  EXPECT_EQ(batch({"--log", beside}).at("log").string, beside);
  const std::string elsewhere = folder_.file("log.jsonl");
  fs::rename(beside, elsewhere);
  EXPECT_EQ(batch({"--log", elsewhere}).at("skipped").number, 3);
  EXPECT_FALSE(fs::exists(log()));
  expect_failure({"reconstruct", in_, "-o", out_, "--log", folder_.file("no/such")}, 4, "io",
                 "folder does not exist");
}

TEST_F(BatchCommand, TakesNoDeviceForItsLog) {
  expect_failure({"reconstruct", in_, "-o", out_, "--log", "/dev/null"}, 4, "io", "regular file",
                 {solid("tube")});
}

}  // namespace
}  // namespace tetloft
