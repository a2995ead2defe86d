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

/// Writes the sizeof(T) bytes at `bytes`.
template <class T>
void store_little(char* bytes, T value) {
  std::memcpy(bytes, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof(T));
}

template <class T>
void append_little(std::string& text, T value) {
  char copy[sizeof(T)];
  store_little(copy, value);
  text.append(copy, sizeof(T));
}

}  // namespace tetloft::internal
