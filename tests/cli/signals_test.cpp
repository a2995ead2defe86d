// Named temporaries, where a file system has no unnamed ones, go with the program.
#include "cli/signals.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "unit/io/io_support.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

// A program that has written most of three files when it is asked to end.
[[noreturn]] void write_and_wait(const test::TempFolder& folder, int ready) {
  handle_signals();
  std::vector<io::PendingFile> files;
  for (const char* name : {"a", "b", "c"}) {
    files.emplace_back(folder.file(name), temporary_watcher(), io::Waiting::named);
    files.back().append(std::string(100'000, 'x'));
  }
  if (!files[1].commit().ok()) _exit(1);
  if (write(ready, "r", 1) != 1) _exit(1);
  for (;;) pause();
}

// How the child ended.
int end_by(int number, const test::TempFolder& folder) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) write_and_wait(folder, ends[1]);
  close(ends[1]);
  char c = 0;
  EXPECT_EQ(read(ends[0], &c, 1), 1);
  close(ends[0]);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.tmp0", "b", "c.tmp0"}));
  kill(child, number);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST(HandleSignals, RemovesNamedTemporariesAndEndsAsBefore) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT}) {
    const test::TempFolder folder;
    const int status = end_by(number, folder);
    ASSERT_TRUE(WIFSIGNALED(status)) << number;
    EXPECT_EQ(WTERMSIG(status), number);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"b"}) << number;
  }
}

TEST(HandleSignals, LeavesIgnoredWhatWasIgnored) {
  const auto before = signal(SIGHUP, SIG_IGN);
  const test::TempFolder folder;
  int status = 0;
  const pid_t child = fork();
  if (child == 0) {
    handle_signals();
    raise(SIGHUP);
    _exit(7);
  }
  waitpid(child, &status, 0);
  signal(SIGHUP, before);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

}  // namespace
}  // namespace tetloft::cli
