// What a program holds on the heap: counted by its own allocation functions, which it has where
// counted_memory.cpp is linked in.
#pragma once

#include <cstddef>
#include <string>

namespace tetloft::test {

[[nodiscard]] std::size_t live_bytes();
/// The most that was live since the last start_peak().
[[nodiscard]] std::size_t peak_bytes();
void start_peak();

/// The most that `work` held beyond what there was.
template <class Work>
std::size_t peak_of(Work&& work) {
  const std::size_t before = live_bytes();
  start_peak();
  work();
  return peak_bytes() - before;
}

/// `head`, then `piece` until there are `bytes` bytes, then `tail`.
inline std::string repeated(const std::string& piece, std::size_t bytes,
                            const std::string& head = "", const std::string& tail = "") {
  std::string text = head;
  text.reserve(head.size() + bytes + piece.size() + tail.size());
  while (text.size() < bytes) text += piece;
  return text + tail;
}

}  // namespace tetloft::test
