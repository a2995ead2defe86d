// The progress line, on a terminal that the test is the other end of.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

// What the command shows there, at most as much as a terminal holds unread.
std::string shown_on_terminal(const std::string& words) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) return {};
  const char* const name = ptsname(terminal);
  // Held open, so that nothing is lost when the command ends.
  const int held = name == nullptr ? -1 : open(name, O_RDWR | O_NOCTTY);
  std::string text;
  if (held >= 0) {
    const std::string command =
        std::string(TETLOFT_EXECUTABLE) + ' ' + words + " >/dev/null 2>" + name;
    if (std::system(command.c_str()) == 0) {
      constexpr int kPatience = 200;  // milliseconds, for what is still on its way
      pollfd ready{terminal, POLLIN, 0};
      while (poll(&ready, 1, kPatience) > 0) {
        char piece[4096];
        const ssize_t got = read(terminal, piece, sizeof piece);
        if (got <= 0) break;
        text.append(piece, static_cast<std::size_t>(got));
      }
    }
    close(held);
  }
  close(terminal);
  return text;
}

TEST(Progress, RunsUpToAllAndLeavesNothingBehind) {
  const test::TempFolder folder;
  const std::string words =
      std::string("reconstruct ") + TETLOFT_DATA_DIR + "/torus.cnt -o " + folder.file("out.vtu");
  const std::string text = shown_on_terminal(words);
  if (text.empty()) GTEST_SKIP() << "no terminals here";
  const std::size_t last = text.rfind("100 %");
  ASSERT_NE(last, std::string::npos) << text;
  EXPECT_EQ(text.substr(text.size() - 4), "\r\x1b[K");
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(shown_on_terminal(words + " --quiet"), "");
}

}  // namespace
}  // namespace tetloft
