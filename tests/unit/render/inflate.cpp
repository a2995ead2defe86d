#include "unit/render/inflate.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace tetloft::test {

namespace {

struct Wrong {};

class Bits {
 public:
  explicit Bits(std::string_view bytes) : bytes_(bytes) {}
  unsigned take(unsigned count) {
    unsigned value = 0;
    for (unsigned k = 0; k < count; ++k) {
      if (at_ / 8 >= bytes_.size()) throw Wrong{};
      value |= (static_cast<unsigned char>(bytes_[at_ / 8]) >> at_ % 8 & 1U) << k;
      ++at_;
    }
    return value;
  }
  [[nodiscard]] std::size_t whole_bytes() const { return (at_ + 7) / 8; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

// (length, code) to symbol.
using Codes = std::map<std::pair<unsigned, unsigned>, unsigned>;

Codes codes_of(const std::vector<unsigned>& lengths) {
  Codes codes;
  unsigned code = 0;
  unsigned long taken = 0;  // in units of 2^-15
  for (unsigned length = 1; length <= 15; ++length) {
    for (unsigned symbol = 0; symbol < lengths.size(); ++symbol) {
      if (lengths[symbol] != length) continue;
      codes[{length, code++}] = symbol;
      taken += 1UL << (15 - length);
    }
    code <<= 1;
  }
  // Complete, but for a single code.
  if (taken > 1UL << 15 || (taken < 1UL << 15 && codes.size() > 1)) throw Wrong{};
  return codes;
}

unsigned decode(Bits& bits, const Codes& codes) {
  unsigned code = 0;
  for (unsigned length = 1; length <= 15; ++length) {
    code = code << 1 | bits.take(1);
    const auto found = codes.find({length, code});
    if (found != codes.end()) return found->second;
  }
  throw Wrong{};
}

std::vector<unsigned> code_lengths(Bits& bits, const Codes& codes, unsigned count) {
  std::vector<unsigned> lengths;
  while (lengths.size() < count) {
    const unsigned symbol = decode(bits, codes);
    if (symbol < 16) {
      lengths.push_back(symbol);
    } else if (symbol == 16) {
      if (lengths.empty()) throw Wrong{};
      lengths.insert(lengths.end(), 3 + bits.take(2), unsigned{lengths.back()});
    } else {
      lengths.insert(lengths.end(), symbol == 17 ? 3 + bits.take(3) : 11 + bits.take(7), 0);
    }
  }
  if (lengths.size() != count) throw Wrong{};
  return lengths;
}

// Lengths 257 … 285 and distances 0 … 29: the base is the sum of what came before.
unsigned length_of(Bits& bits, unsigned symbol) {
  if (symbol == 285) return 258;
  if (symbol > 285) throw Wrong{};
  unsigned base = 3;
  for (unsigned s = 257; s < symbol; ++s) base += 1U << (s < 265 ? 0 : (s - 261) / 4);
  return base + bits.take(symbol < 265 ? 0 : (symbol - 261) / 4);
}
unsigned distance_of(Bits& bits, unsigned symbol) {
  if (symbol > 29) throw Wrong{};
  unsigned base = 1;
  for (unsigned s = 0; s < symbol; ++s) base += 1U << (s < 4 ? 0 : s / 2 - 1);
  return base + bits.take(symbol < 4 ? 0 : symbol / 2 - 1);
}

std::string blocks(Bits& bits) {
  std::string out;
  for (bool last = false; !last;) {
    last = bits.take(1) != 0;
    if (bits.take(2) != 2) throw Wrong{};  // the only kind that is written
    const unsigned literals = bits.take(5) + 257;
    const unsigned distances = bits.take(5) + 1;
    const unsigned sent = bits.take(4) + 4;
    constexpr std::array<unsigned, 19> kOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                              11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::vector<unsigned> first(19, 0);
    for (unsigned k = 0; k < sent; ++k) first[kOrder[k]] = bits.take(3);
    const std::vector<unsigned> all = code_lengths(bits, codes_of(first), literals + distances);
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(literals);
    const Codes literal = codes_of({all.begin(), middle});
    const Codes distance = codes_of({middle, all.end()});
    for (;;) {
      const unsigned symbol = decode(bits, literal);
      if (symbol == 256) break;
      if (symbol < 256) {
        out += static_cast<char>(symbol);
        continue;
      }
      const unsigned length = length_of(bits, symbol);
      const unsigned back = distance_of(bits, decode(bits, distance));
      if (back > out.size() || back > 32768) throw Wrong{};
      for (unsigned k = 0; k < length; ++k) out += out[out.size() - back];
    }
  }
  return out;
}

}  // namespace

std::optional<std::string> inflate_bare(std::string_view stream) {
  try {
    Bits bits(stream);
    std::string out = blocks(bits);
    if (bits.whole_bytes() != stream.size()) return std::nullopt;
    return out;
  } catch (const Wrong&) {
    return std::nullopt;
  }
}

std::optional<std::string> inflate(std::string_view stream) {
  if (stream.size() < 6 || (stream[0] & 15) != 8) return std::nullopt;
  const unsigned header =
      static_cast<unsigned char>(stream[0]) * 256U + static_cast<unsigned char>(stream[1]);
  if (header % 31 != 0) return std::nullopt;
  std::optional<std::string> out = inflate_bare(stream.substr(2, stream.size() - 6));
  if (!out) return std::nullopt;
  unsigned long a = 1, b = 0;
  for (const char c : *out) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  unsigned long sum = 0;
  for (const char c : stream.substr(stream.size() - 4)) {
    sum = sum << 8 | static_cast<unsigned char>(c);
  }
  if (sum != (b << 16 | a)) return std::nullopt;
  return out;
}

}  // namespace tetloft::test
