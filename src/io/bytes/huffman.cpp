// Canonical codes: those of one length are consecutive numbers, in the order of the symbols.
#include "io/bytes/huffman.hpp"

#include <algorithm>

namespace tetloft::internal::io {

namespace {

unsigned reversed(unsigned code, unsigned length) {
  unsigned result = 0;
  for (unsigned i = 0; i < length; ++i) result |= (code >> i & 1U) << (length - 1 - i);
  return result;
}

}  // namespace

bool HuffmanCode::assign(std::span<const std::uint8_t> lengths) {
  count_.fill(0);
  quick_.fill(0);
  for (const std::uint8_t length : lengths) ++count_[length];
  count_[0] = 0;
  std::array<unsigned, kLongest + 2> next_code{};
  std::array<unsigned, kLongest + 2> next_place{};
  int free_codes = 1;
  unsigned used = 0;
  for (unsigned length = 1; length <= kLongest; ++length) {
    free_codes = 2 * free_codes - count_[length];
    if (free_codes < 0) return false;
    used += count_[length];
    next_code[length + 1] = (next_code[length] + count_[length]) << 1;
    next_place[length + 1] = next_place[length] + count_[length];
  }
  if (free_codes > 0 && !(used == 0 || (used == 1 && count_[1] == 1))) return false;
  for (unsigned symbol = 0; symbol < lengths.size(); ++symbol) {
    const unsigned length = lengths[symbol];
    if (length == 0) continue;
    symbols_[next_place[length]++] = static_cast<std::uint16_t>(symbol);
    const unsigned code = reversed(next_code[length]++, length);
    if (length > kQuickBits) continue;
    for (std::size_t i = code; i < kQuickEntries; i += std::size_t{1} << length) {
      quick_[i] = static_cast<std::uint16_t>(symbol << 4U | length);
    }
  }
  return true;
}

HuffmanCode::Symbol HuffmanCode::find_long(std::uint64_t bits) const {
  unsigned code = 0;
  unsigned first = 0;  // code of this length
  unsigned place = 0;  // of its symbol
  for (unsigned length = 1; length <= kLongest; ++length) {
    code |= static_cast<unsigned>(bits >> (length - 1) & 1U);
    if (code < first + count_[length]) return {symbols_[place + (code - first)], length};
    place += count_[length];
    first = (first + count_[length]) << 1;
    code <<= 1;
  }
  return {};
}

}  // namespace tetloft::internal::io
