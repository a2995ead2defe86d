// Little-endian bytes, whatever the machine's order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>

namespace tetloft::internal {

static_assert(std::endian::native == std::endian::little ||
              std::endian::native == std::endian::big);

/// The value stored at `bytes`, which need not be aligned.
template <class T>
[[nodiscard]] T load_little(const char* bytes) {
  char copy[sizeof(T)];
  std::memcpy(copy, bytes, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(copy, copy + sizeof(T));
  T value;
  std::memcpy(&value, copy, sizeof(T));
  return value;
}

template <class T>
void append_little(std::string& text, T value) {
  char copy[sizeof(T)];
  std::memcpy(copy, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(copy, copy + sizeof(T));
  text.append(copy, sizeof(T));
}

}  // namespace tetloft::internal
