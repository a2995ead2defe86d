// The program's own pthread_create, which can be told to fail as where a limit is reached.
#pragma once

#include <cstddef>

namespace tetloft::test {

/// While it lives no more than `most` threads are made, in all.
class FewThreads {
 public:
  explicit FewThreads(std::size_t most);
  ~FewThreads();
  FewThreads(const FewThreads&) = delete;
  FewThreads& operator=(const FewThreads&) = delete;

  /// How many were refused so far.
  [[nodiscard]] static std::size_t refused();
};

}  // namespace tetloft::test
