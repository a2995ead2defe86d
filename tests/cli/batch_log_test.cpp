// The log of reconstruct of many stacks: what it says, and going on by it, also after being killed.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "cli/batch_folders.hpp"

extern char** environ;

namespace tetloft {
namespace {

namespace fs = std::filesystem;

using test::expect_failure;
using test::get;
using test::JsonValue;
using test::kBowtie;
using test::put;
using test::run;
using test::run_json;

class BatchLog : public test::BatchFolders {};

TEST_F(BatchLog, LogsWhatEachWasMadeOf) {
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

TEST_F(BatchLog, GoesOnWhereTheFoldersWereMoved) {
  EXPECT_EQ(batch().at("done").number, 3);
  const std::string in = folder_.file("in2"), out = folder_.file("out2");
  fs::rename(in_, in);
  fs::rename(out_, out);
  EXPECT_EQ(run_json({"reconstruct", in, "-o", out}).at("skipped").number, 3);
}

TEST_F(BatchLog, CutsOffALineThatWasInterrupted) {
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

TEST_F(BatchLog, LeavesAloneWhatIsNoLog) {
  for (const char* text : {"notes\n", "notes", "{\"a\":1}\n", "[1]\n", "{\"tetloft\":3}\n"}) {
    const std::string file = folder_.file("notes.txt");
    put(file, text);
    expect_failure({"reconstruct", in_, "-o", out_, "--log", file}, 3, "invalid_input",
                   "notes.txt:1: ", {solid("tube")});
    EXPECT_EQ(get(file), text);
  }
}

TEST_F(BatchLog, IsOneAtATimeForALog) {
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

TEST_F(BatchLog, KilledItLeavesWholeSolidsAndGoesOn) {
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
  // The last solid is a pipe that nobody reads: the first run, one stack after the other, cannot
  // end before it is killed.
  fs::create_directory(out_);
  ASSERT_EQ(mkfifo(solid("tube").c_str(), 0600), 0);
  std::string threads = "1";
  for (const int number : {SIGKILL, SIGTERM, SIGKILL, SIGINT}) {
    std::vector<std::string> words{TETLOFT_EXECUTABLE, "reconstruct", in_,    "-o", out_,
                                   "--quiet",          "--threads",   threads};
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
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
    bool ended = false;
    while (size() == before && !ended) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ended = waitpid(child, &status, WNOHANG) != 0;
    }
    if (!ended) {
      kill(child, number);
      waitpid(child, &status, 0);
    }
    if (threads == "1") {
      EXPECT_TRUE(WIFSIGNALED(status)) << status;
      fs::remove(solid("tube"));
      threads = "0";
    }
    for (const auto& file : fs::directory_iterator(out_)) {
      const std::string name = file.path().filename().string();
      if (name == "tetloft.jsonl") continue;
      // Only the signal that nothing can catch may leave a whole file under another name.
      if (number == SIGKILL && file.path().extension() != ".vtu") continue;
      ASSERT_TRUE(expected.count(name)) << name;
      EXPECT_EQ(get(file.path().string()), expected[name]) << name;
    }
  }
  const std::size_t made = lines().size();
  EXPECT_GT(made, 0U);
  const JsonValue told = batch();
  EXPECT_GE(told.at("skipped").number, 1);
  EXPECT_EQ(told.at("skipped").number + told.at("done").number, kStacks + 3);
  for (const auto& [name, bytes] : expected) EXPECT_EQ(get(out_ + '/' + name), bytes) << name;
  EXPECT_EQ(batch().at("skipped").number, kStacks + 3);
}

TEST_F(BatchLog, EndsWhereTheLogCannotBeWritten) {
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

TEST_F(BatchLog, WritesItsLogWhereItIsAskedTo) {
  const std::string beside = out_ + "/log.jsonl";
  EXPECT_EQ(batch({"--log", beside}).at("log").string, beside);
  const std::string elsewhere = folder_.file("log.jsonl");
  fs::rename(beside, elsewhere);
  EXPECT_EQ(batch({"--log", elsewhere}).at("skipped").number, 3);
  EXPECT_FALSE(fs::exists(log()));
  expect_failure({"reconstruct", in_, "-o", out_, "--log", folder_.file("no/such")}, 4, "io",
                 "folder does not exist");
}

TEST_F(BatchLog, TakesNoDeviceForItsLog) {
  expect_failure({"reconstruct", in_, "-o", out_, "--log", "/dev/null"}, 4, "io", "regular file",
                 {solid("tube")});
}

}  // namespace
}  // namespace tetloft
