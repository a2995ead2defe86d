#include "child.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <sstream>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tetloft::bench {

namespace {

// The first character of what a child sends.
constexpr char kDone = '+';
constexpr char kThrew = '!';

std::string message_of(const std::function<std::string()>& work) {
  try {
    return kDone + work();
  } catch (const std::exception& e) {
    return kThrew + std::string(e.what());
  } catch (...) {
    return kThrew + std::string("threw what is no std::exception");
  }
}

[[noreturn]] void send_and_exit(int pipe_end, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = write(pipe_end, text.data() + sent, text.size() - sent);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) _exit(1);
    sent += static_cast<std::size_t>(n);
  }
  _exit(0);
}

// All that comes until the pipe closes. False when the limit comes first.
bool receive(int pipe_end, double limit, std::string& text) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(limit);
  for (;;) {
    const double left = std::chrono::duration<double>(end - Clock::now()).count();
    if (left <= 0) return false;
    // At most a minute at a time: milliseconds of any limit fit an int.
    pollfd waiting{pipe_end, POLLIN, 0};
    const int ready = poll(&waiting, 1, static_cast<int>(1000 * std::min(left, 60.0)) + 1);
    if (ready <= 0) continue;
    char buffer[4096];
    const ssize_t n = read(pipe_end, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return true;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

std::string crash_of(int status) {
  if (WIFSIGNALED(status)) return std::string("crashed: ") + strsignal(WTERMSIG(status));
  return "exited with code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Child run_in_child(const std::function<std::string()>& work, double limit) {
  Child child;
  int ends[2];
  if (pipe(ends) != 0) {
    child.failure = "no pipe to a child process";
    return child;
  }
  const pid_t pid = fork();
  if (pid < 0) {
    close(ends[0]);
    close(ends[1]);
    child.failure = "no child process";
    return child;
  }
  if (pid == 0) {
    close(ends[0]);
    send_and_exit(ends[1], message_of(work));
  }
  close(ends[1]);
  std::string text;
  const bool in_time = receive(ends[0], limit, text);
  close(ends[0]);
  if (!in_time) kill(pid, SIGKILL);
  int status = 0;
  rusage usage{};
  while (wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  child.peak_megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  if (!in_time) {
    std::ostringstream told;
    told << "beyond the limit of " << limit << " s";
    child.failure = told.str();
  } else if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || text.empty()) {
    child.failure = crash_of(status);
  } else if (text[0] == kThrew) {
    child.failure = text.size() > 1 ? text.substr(1) : "threw";
  } else {
    child.output = text.substr(1);
  }
  return child;
}

}  // namespace tetloft::bench
