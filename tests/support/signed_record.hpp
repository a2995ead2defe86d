// Damaged records whose checksum matches, as nobody but an attacker writes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace tetloft::testing {

/// The bytes of a record with the checksum (core/record.hpp) that is theirs.
[[nodiscard]] inline std::string signed_again(std::string bytes) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (std::size_t i = 0; i + 8 < bytes.size(); ++i) {
    hash = (hash ^ static_cast<unsigned char>(bytes[i])) * 0x100000001B3U;
  }
  for (std::size_t i = 0; i < 8; ++i) {
    bytes[bytes.size() - 8 + i] = static_cast<char>(hash >> (8 * i));
  }
  return bytes;
}

}  // namespace tetloft::testing
