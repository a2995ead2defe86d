// A handler may use no memory that can move and few functions: the names stand in a table of
// fixed size, and unlink, sigaction and raise are all it calls (POSIX, signal-safety).
#include "cli/signals.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <string>

namespace tetloft::cli {

using namespace internal;

namespace {

// As many as a command has files open at once, and then some.
constexpr std::size_t kNames = 8;

struct Slot {
  std::atomic<bool> used{false};
  std::array<char, PATH_MAX> name{};
};

std::array<Slot, kNames> slots;
static_assert(std::atomic<bool>::is_always_lock_free);

class Watcher final : public io::TemporaryWatcher {
 public:
  void created(const std::string& name) override {
    if (name.size() >= PATH_MAX) return;
    for (Slot& slot : slots) {
      if (slot.used.load()) continue;
      std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
      slot.used.store(true);
      return;
    }
  }
  void gone(const std::string& name) override {
    for (Slot& slot : slots) {
      if (slot.used.load() && name == slot.name.data()) slot.used.store(false);
    }
  }
};

extern "C" void remove_and_end(int number) {
  for (const Slot& slot : slots) {
    if (slot.used.load()) unlink(slot.name.data());
  }
  struct sigaction standard {};
  standard.sa_handler = SIG_DFL;
  sigaction(number, &standard, nullptr);
  raise(number);  // pending until the handler returns
}

}  // namespace

void handle_signals() {
  struct sigaction action {};
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT}) {
    struct sigaction before {};
    if (sigaction(number, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
    action.sa_handler = remove_and_end;
    sigaction(number, &action, nullptr);
  }
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, nullptr);
}

io::TemporaryWatcher* temporary_watcher() {
  static Watcher watcher;
  return &watcher;
}

}  // namespace tetloft::cli
