// DEFLATE data and their wrappings as tests make them, block by block: stored, fixed, and dynamic
// with whatever code lengths a test asks for. Shares no code with the product.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetloft::test {

class BitWriter {
 public:
  /// The low `count` bits, the lowest first, as all but codes are written.
  void put(std::uint32_t value, unsigned count) {
    for (unsigned i = 0; i < count; ++i) put_bit(value >> i & 1U);
  }
  /// A prefix code: the highest bit first.
  void put_code(std::uint32_t code, unsigned count) {
    for (unsigned i = count; i-- > 0;) put_bit(code >> i & 1U);
  }
  void align() { used_ = 0; }
  void put_bytes(std::string_view bytes) {
    align();
    bytes_ += bytes;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void put_bit(std::uint32_t bit) {
    if (used_ == 0) bytes_ += '\0';
    bytes_.back() = static_cast<char>(static_cast<unsigned char>(bytes_.back()) | bit << used_);
    used_ = (used_ + 1) % 8;
  }
  std::string bytes_;
  unsigned used_ = 0;
};

/// Canonical codes of the symbols with these code lengths (0: none).
inline std::vector<std::uint32_t> canonical_codes(const std::vector<unsigned>& lengths) {
  std::vector<std::uint32_t> codes(lengths.size(), 0);
  std::uint32_t code = 0;
  for (unsigned length = 1; length <= 15; ++length) {
    for (std::size_t s = 0; s < lengths.size(); ++s) {
      if (lengths[s] == length) codes[s] = code++;
    }
    code <<= 1;
  }
  return codes;
}

/// A literal, or a match of `length` at `distance`, whose code, base and extra bits are said by the
/// test.
struct DeflateSymbol {
  unsigned symbol = 0;
  unsigned extra = 0;
  unsigned extra_bits = 0;
  unsigned distance_symbol = 0;
  unsigned distance_extra = 0;
  unsigned distance_extra_bits = 0;
};

inline std::vector<DeflateSymbol> literals_of(std::string_view text) {
  std::vector<DeflateSymbol> symbols;
  for (const char c : text) symbols.push_back({.symbol = static_cast<unsigned char>(c)});
  return symbols;
}

inline std::vector<unsigned> fixed_literal_lengths() {
  std::vector<unsigned> lengths(288, 8);
  for (std::size_t s = 144; s < 256; ++s) lengths[s] = 9;
  for (std::size_t s = 256; s < 280; ++s) lengths[s] = 7;
  return lengths;
}

inline void put_stored(BitWriter& out, std::string_view bytes, bool last) {
  out.put(last ? 1 : 0, 1);
  out.put(0, 2);
  out.align();
  const auto size = static_cast<std::uint32_t>(bytes.size());
  out.put(size, 16);
  out.put(~size, 16);
  out.put_bytes(bytes);
}

inline void put_symbols(BitWriter& out, const std::vector<DeflateSymbol>& symbols,
                        const std::vector<unsigned>& literals,
                        const std::vector<unsigned>& distances) {
  const std::vector<std::uint32_t> literal_codes = canonical_codes(literals);
  const std::vector<std::uint32_t> distance_codes = canonical_codes(distances);
  for (const DeflateSymbol& s : symbols) {
    out.put_code(literal_codes[s.symbol], literals[s.symbol]);
    if (s.symbol < 256) continue;
    out.put(s.extra, s.extra_bits);
    out.put_code(distance_codes[s.distance_symbol], distances[s.distance_symbol]);
    out.put(s.distance_extra, s.distance_extra_bits);
  }
  out.put_code(literal_codes[256], literals[256]);
}

inline void put_fixed(BitWriter& out, const std::vector<DeflateSymbol>& symbols, bool last) {
  out.put(last ? 1 : 0, 1);
  out.put(1, 2);
  put_symbols(out, symbols, fixed_literal_lengths(), std::vector<unsigned>(32, 5));
}

/// Lengths of both codes, each as a symbol of four bits, no runs.
inline void put_dynamic_header(BitWriter& out, const std::vector<unsigned>& literals,
                               const std::vector<unsigned>& distances, bool last) {
  out.put(last ? 1 : 0, 1);
  out.put(2, 2);
  out.put(static_cast<std::uint32_t>(literals.size() - 257), 5);
  out.put(static_cast<std::uint32_t>(distances.size() - 1), 5);
  out.put(19 - 4, 4);
  for (const int symbol : {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15}) {
    out.put(symbol < 16 ? 4 : 0, 3);
  }
  for (const unsigned length : literals) out.put_code(length, 4);
  for (const unsigned length : distances) out.put_code(length, 4);
}

inline void put_dynamic(BitWriter& out, const std::vector<DeflateSymbol>& symbols,
                        const std::vector<unsigned>& literals,
                        const std::vector<unsigned>& distances, bool last) {
  put_dynamic_header(out, literals, distances, last);
  put_symbols(out, symbols, literals, distances);
}

/// CRC-32 and Adler-32 by definition, bit by bit and byte by byte.
inline std::uint32_t crc32_by_bits(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int i = 0; i < 8; ++i) crc = (crc & 1U) != 0 ? crc >> 1 ^ 0xEDB88320U : crc >> 1;
  }
  return ~crc;
}

inline std::uint32_t adler32_by_bytes(std::string_view bytes) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

inline std::string little_word(std::uint32_t word) {
  std::string bytes;
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(word >> 8 * i & 0xFFU);
  return bytes;
}

/// A gzip member of DEFLATE data that unpack to `content`.
inline std::string gzip_member(std::string_view deflated, std::string_view content) {
  return std::string("\x1F\x8B\x08\0\0\0\0\0\0\xFF", 10) + std::string(deflated) +
         little_word(crc32_by_bits(content)) +
         little_word(static_cast<std::uint32_t>(content.size()));
}

inline std::string zlib_stream(std::string_view deflated, std::string_view content) {
  const std::string sum = little_word(adler32_by_bytes(content));
  return std::string("\x78\x9C") + std::string(deflated) + std::string(sum.rbegin(), sum.rend());
}

/// In stored blocks, whatever the size.
inline std::string deflated_stored(std::string_view bytes) {
  BitWriter out;
  do {
    const std::string_view piece = bytes.substr(0, 65535);
    bytes.remove_prefix(piece.size());
    put_stored(out, piece, bytes.empty());
  } while (!bytes.empty());
  return out.bytes();
}

inline std::string gzipped(std::string_view bytes) {
  return gzip_member(deflated_stored(bytes), bytes);
}
inline std::string zlibbed(std::string_view bytes) {
  return zlib_stream(deflated_stored(bytes), bytes);
}

}  // namespace tetloft::test
