// Prefix codes of RFC 1951: given by the length of each symbol's code, read from the low bit on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tetloft::internal::io {

class HuffmanCode {
 public:
  static constexpr unsigned kLongest = 15;
  /// The alphabet of literals and lengths is the largest, two symbols of which are never used.
  static constexpr std::size_t kMostSymbols = 288;

  /// lengths[s] of symbol s, 0: unused. False where no prefix code has these lengths, or one that
  /// leaves bits without meaning: but one code of one bit, and none at all, are allowed, as writers
  /// of data without matches make them.
  [[nodiscard]] bool assign(std::span<const std::uint8_t> lengths);

  struct Symbol {
    unsigned value = 0;
    unsigned length = 0;  ///< 0: no code begins so
  };
  /// The symbol whose code `bits` begin with; at least kLongest of them, zeros where there are no
  /// more.
  [[nodiscard]] Symbol find(std::uint64_t bits) const {
    const unsigned known = quick_[bits & (kQuickEntries - 1)];
    if (known != 0) return {known >> 4U, known & 15U};
    return find_long(bits);
  }

 private:
  [[nodiscard]] Symbol find_long(std::uint64_t bits) const;

  static constexpr unsigned kQuickBits = 10;
  static constexpr std::size_t kQuickEntries = std::size_t{1} << kQuickBits;

  /// By the next kQuickBits: symbol · 16 + length; 0 where the code is longer, or there is none.
  std::array<std::uint16_t, kQuickEntries> quick_{};
  std::array<std::uint16_t, kLongest + 1> count_{};    ///< codes of each length
  std::array<std::uint16_t, kMostSymbols> symbols_{};  ///< by length, then by value
};

}  // namespace tetloft::internal::io
