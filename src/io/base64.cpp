#include "io/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "io/cursor.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::uint8_t kForeign = 0xFF;

constexpr std::array<std::uint8_t, 256> make_table() {
  std::array<std::uint8_t, 256> table{};
  for (auto& entry : table) entry = kForeign;
  std::uint8_t value = 0;
  for (unsigned c = 'A'; c <= 'Z'; ++c) table[c] = value++;
  for (unsigned c = 'a'; c <= 'z'; ++c) table[c] = value++;
  for (unsigned c = '0'; c <= '9'; ++c) table[c] = value++;
  table['+'] = value++;
  table['/'] = value;
  return table;
}

// Value of each character; kForeign outside the alphabet.
constexpr std::array<std::uint8_t, 256> kTable = make_table();

}  // namespace

std::optional<std::string> decode_base64(std::string_view text, std::size_t wanted) {
  std::string bytes;
  bytes.reserve(std::min(wanted, text.size() / 4 * 3 + 3));
  std::uint32_t group = 0;
  int digits = 0;
  int padding = 0;
  for (const char c : text) {
    if (is_white(c)) continue;
    // Data of the appended block end where its closing tag begins.
    if (c == '<') break;
    if (c == '=') {
      ++padding;
      group <<= 6;
    } else {
      const std::uint8_t value = kTable[static_cast<unsigned char>(c)];
      if (value == kForeign || padding != 0) return std::nullopt;
      group = group << 6 | value;
    }
    if (++digits < 4) continue;
    if (padding > 2) return std::nullopt;
    for (int i = 0; i < 3 - padding; ++i) {
      bytes += static_cast<char>(group >> (16 - 8 * i) & 0xFFU);
    }
    group = 0;
    digits = 0;
    padding = 0;
    if (bytes.size() >= wanted) break;
  }
  return bytes;
}

std::string encode_base64(std::string_view bytes) {
  constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      group = group << 8 | (i < n ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i > n ? '=' : kAlphabet[group >> (18 - 6 * i) & 63U];
    }
  }
  return text;
}

}  // namespace tetloft::internal::io
