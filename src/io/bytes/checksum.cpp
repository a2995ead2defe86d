// CRC-32 by tables, four bytes a step; Adler-32.
#include "io/bytes/checksum.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tetloft::internal::io {

namespace {

// kCrc[k][b]: what byte b becomes when k zero bytes follow it.
constexpr auto kCrc = [] {
  std::array<std::array<std::uint32_t, 256>, 4> table{};
  for (std::uint32_t b = 0; b < 256; ++b) {
    std::uint32_t crc = b;
    for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    table[0][b] = crc;
  }
  for (std::size_t k = 1; k < 4; ++k) {
    for (std::size_t b = 0; b < 256; ++b) {
      table[k][b] = (table[k - 1][b] >> 8) ^ table[0][table[k - 1][b] & 0xFFU];
    }
  }
  return table;
}();

std::uint32_t unsigned_of(char c) { return static_cast<unsigned char>(c); }

}  // namespace

std::uint32_t crc32(std::uint32_t sum, std::string_view bytes) {
  std::uint32_t crc = ~sum;
  std::size_t i = 0;
  for (; i + 4 <= bytes.size(); i += 4) {
    crc ^= unsigned_of(bytes[i]) | unsigned_of(bytes[i + 1]) << 8 |
           unsigned_of(bytes[i + 2]) << 16 | unsigned_of(bytes[i + 3]) << 24;
    crc = kCrc[3][crc & 0xFFU] ^ kCrc[2][crc >> 8 & 0xFFU] ^ kCrc[1][crc >> 16 & 0xFFU] ^
          kCrc[0][crc >> 24];
  }
  for (; i < bytes.size(); ++i) crc = (crc >> 8) ^ kCrc[0][(crc ^ unsigned_of(bytes[i])) & 0xFFU];
  return ~crc;
}

std::uint32_t adler32(std::uint32_t sum, std::string_view bytes) {
  constexpr std::uint32_t kModulus = 65521;
  // The most bytes of 255 after which the second sum still fits in 32 bits.
  constexpr std::size_t kRun = 5552;
  std::uint32_t a = sum & 0xFFFFU;
  std::uint32_t b = sum >> 16;
  for (std::size_t from = 0; from < bytes.size(); from += kRun) {
    for (const char c : bytes.substr(from, kRun)) {
      a += unsigned_of(c);
      b += a;
    }
    a %= kModulus;
    b %= kModulus;
  }
  return b << 16 | a;
}

}  // namespace tetloft::internal::io
