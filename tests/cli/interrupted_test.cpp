// Killed midway, or the disk full: the earlier file is still whole.
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <tetloft/io.hpp>

#include "cli/runner.hpp"

extern char** environ;

namespace tetloft {
namespace {

using test::run;

// Columns of many vertices, so that there is time to be killed in every phase.
std::string large_stack() {
  std::string text = "S 6\n";
  constexpr int kVertices = 600;
  for (int s = 0; s < 6; ++s) {
    text += "v 600 z " + std::to_string(s) + "\n{\n";
    for (int v = 0; v < kVertices; ++v) {
      const double angle = 6.283185307179586 * v / kVertices;
      const double r = 10 + std::sin(7 * angle + s);
      text +=
          std::to_string(r * std::cos(angle)) + ' ' + std::to_string(r * std::sin(angle)) + '\n';
    }
    text += "}\n";
  }
  return text;
}

class Interrupted : public ::testing::Test {
 protected:
  Interrupted() {
    test::put(in_, large_stack());
    EXPECT_EQ(run({"reconstruct", in_, "-o", out_, "--ascii"}).code, 0);
    // The earlier file differs from what is written next.
    earlier_ = test::get(out_);
    EXPECT_EQ(run({"reconstruct", in_, "-o", folder_.file("new.vtu")}).code, 0);
    later_ = test::get(folder_.file("new.vtu"));
    EXPECT_NE(earlier_, later_);
  }

  test::TempFolder folder_;
  std::string in_ = folder_.file("in.cnt");
  std::string out_ = folder_.file("out.vtu");
  std::string earlier_;
  std::string later_;
};

TEST_F(Interrupted, KilledAtAnyTimeItLeavesAWholeFile) {
  const std::vector<std::string> names = folder_.names();
  int killed = 0;
  for (const int number :
       {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGQUIT, SIGXFSZ, SIGALRM, SIGUSR1}) {
    for (int milliseconds = number % 7; milliseconds < 60; milliseconds += 7) {
      test::put(out_, earlier_);
      std::vector<std::string> words{TETLOFT_EXECUTABLE, "reconstruct", in_, "-o", out_, "--quiet"};
      std::vector<char*> argv;
      for (std::string& word : words) argv.push_back(word.data());
      argv.push_back(nullptr);
      pid_t child = 0;
      ASSERT_EQ(posix_spawn(&child, TETLOFT_EXECUTABLE, nullptr, nullptr, argv.data(), environ), 0);
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      kill(child, number);
      int status = 0;
      waitpid(child, &status, 0);
      if (WIFSIGNALED(status)) {
        ++killed;
        EXPECT_EQ(WTERMSIG(status), number);
      }
      const std::string now = test::get(out_);
      EXPECT_TRUE(now == earlier_ || now == later_)
          << "signal " << number << " after " << milliseconds << " ms: " << now.size();
      // A whole file has a name of its own for the moment before it takes the earlier one's place;
      // only the signal that nothing can catch may leave it there.
      if (const std::string left = out_ + ".tmp0";
          number == SIGKILL && std::filesystem::exists(left)) {
        EXPECT_EQ(test::get(left), later_);
        std::filesystem::remove(left);
      }
      EXPECT_EQ(folder_.names(), names) << "signal " << number << " after " << milliseconds;
    }
  }
  EXPECT_GT(killed, 0);
  EXPECT_EQ(run({"reconstruct", in_, "-o", out_}).code, 0);
  EXPECT_EQ(test::get(out_), later_);
}

TEST_F(Interrupted, WithoutRoomForTheFileItSaysSoAndLeavesTheEarlierOne) {
  // A limit of the size of files stands for a full disk. Both it and what is done with its
  // signal are handed down to the program, whose message must find room.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  for (const auto disposition : {SIG_IGN, SIG_DFL}) {
    for (const rlim_t bytes : {1000U, 20000U, 65536U, 100000U}) {
      ASSERT_LT(bytes, later_.size());
      const rlimit small{bytes, before.rlim_max};
      const auto handler = ::signal(SIGXFSZ, disposition);
      ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
      const test::Outcome outcome = run({"reconstruct", in_, "-o", out_});
      ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
      ::signal(SIGXFSZ, handler);
      EXPECT_EQ(outcome.code, 4) << outcome.err;
      EXPECT_NE(outcome.err.find("cannot be written: File too large"), std::string::npos)
          << outcome.err;
      EXPECT_EQ(test::get(out_), earlier_);
      EXPECT_EQ(folder_.names().size(), 3U);
    }
  }
}

// What has no room are its temporaries, beside the file: no fault of the stack.
TEST_F(Interrupted, WithoutRoomForAStreamOrAPlanItNamesTheFileThatWasToAppear) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  using Words = std::vector<std::string>;
  for (const Words& words :
       {Words{"reconstruct", in_, "--stream", "-o", out_}, Words{"plan", in_, "-o", out_}}) {
    const rlimit small{1000, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const test::Outcome outcome = run(words);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("error: " + out_ + ": "), std::string::npos) << outcome.err;
    EXPECT_EQ(test::get(out_), earlier_);
  }
  ::signal(SIGXFSZ, handler);
}

// A file system of 64 KB of its own, seen by the child alone. Everything worth knowing comes
// back as its exit code.
enum Verdict { all_well, no_file_system, no_first_file, wrong_code, wrong_message, changed, left };

Verdict on_a_tiny_file_system(const std::string& folder, const std::string& in) {
  if (unshare(CLONE_NEWNS) != 0) {  // not the superuser
    const std::string uid = std::to_string(getuid()), gid = std::to_string(getgid());
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return no_file_system;
    test::put("/proc/self/uid_map", "0 " + uid + " 1");
    test::put("/proc/self/setgroups", "deny");
    test::put("/proc/self/gid_map", "0 " + gid + " 1");
  }
  if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return no_file_system;
  if (mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=64k") != 0) return no_file_system;
  const std::string out = folder + "/out.vtu";
  test::put(out, "the earlier file");
  if (test::get(out) != "the earlier file") return no_first_file;
  const test::Outcome outcome = run({"reconstruct", in, "-o", out});
  if (outcome.code != 4) return wrong_code;
  if (outcome.err.find("cannot be written") == std::string::npos) return wrong_message;
  if (test::get(out) != "the earlier file") return changed;
  const std::filesystem::directory_iterator files(folder);
  return std::distance(begin(files), end(files)) == 1 ? all_well : left;
}

TEST_F(Interrupted, OnAFullDiskTheEarlierFileStaysAndNothingElse) {
  ASSERT_GT(later_.size(), 65536U);
  const std::string tiny = folder_.file("tiny");
  std::filesystem::create_directory(tiny);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) _exit(on_a_tiny_file_system(tiny, in_));
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == no_file_system) GTEST_SKIP() << "no file system may be mounted here";
  EXPECT_EQ(WEXITSTATUS(status), all_well);
}

}  // namespace
}  // namespace tetloft
