// A process of its own for a piece of work: what it breaks, leaks or takes is not ours.
#pragma once

#include <functional>
#include <string>

namespace tetloft::bench {

struct Child {
  std::string output;   // what the work returned; nothing if it failed
  std::string failure;  // how it failed; empty unless it did
  double peak_megabytes = 0;
};

/// Runs `work` in a child process, killed after `limit` seconds. Whatever it throws, and a
/// signal that ends it, is told in `failure`.
[[nodiscard]] Child run_in_child(const std::function<std::string()>& work, double limit);

}  // namespace tetloft::bench
