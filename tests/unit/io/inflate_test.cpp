// DEFLATE: data made block by block here, and what the product's own compressor makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/prng.hpp"
#include "io/bytes/checksum.hpp"
#include "io/bytes/deflate.hpp"
#include "io/bytes/inflate.hpp"
#include "support/deflated.hpp"

namespace tetloft {

using namespace internal;
using namespace internal::io;
namespace {

using namespace test;

constexpr std::size_t kMost = std::size_t{1} << 24;

std::string unpacked(std::string_view bytes, Wrapping wrapping) {
  const Result<std::string> all = inflate(bytes, wrapping, kMost, "file");
  EXPECT_TRUE(all.ok()) << (all.ok() ? "" : to_string(all.error()));
  return all.ok() ? *all : std::string();
}

std::string refusal(std::string_view bytes, Wrapping wrapping, std::size_t most = kMost) {
  const Result<std::string> all = inflate(bytes, wrapping, most, "file");
  if (all.ok()) return "taken";
  EXPECT_EQ(all.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(all.error().where.file, "file");
  return all.error().message;
}

std::string raw_of(const BitWriter& out) { return unpacked(out.bytes(), Wrapping::raw); }

std::string noise(std::size_t size, std::uint64_t seed, unsigned values) {
  Prng prng(seed);
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(prng.below(values));
  return bytes;
}

// A complete code over `used` symbols with lengths 1, 2, 3 … the longest twice.
std::vector<unsigned> skewed(std::size_t symbols, const std::vector<std::size_t>& used) {
  std::vector<unsigned> lengths(symbols, 0);
  for (std::size_t i = 0; i < used.size(); ++i) {
    lengths[used[i]] = static_cast<unsigned>(std::min(i + 1, used.size() - 1));
  }
  return lengths;
}

TEST(Inflate, StoredBlocksAreCopied) {
  BitWriter out;
  put_stored(out, "one ", false);
  put_stored(out, "", false);
  put_stored(out, std::string(65535, 'x'), false);
  put_stored(out, "end", true);
  EXPECT_EQ(raw_of(out), "one " + std::string(65535, 'x') + "end");
}

TEST(Inflate, FixedBlocksHaveAllLiterals) {
  std::string all;
  for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
  BitWriter out;
  put_fixed(out, literals_of(all), true);
  EXPECT_EQ(raw_of(out), all);
}

TEST(Inflate, MatchesMayOverlapWhatTheyMake) {
  BitWriter out;
  std::vector<DeflateSymbol> symbols = literals_of("ab");
  symbols.push_back({.symbol = 285, .distance_symbol = 1});  // 258 bytes from 2 behind
  symbols.push_back({.symbol = 257, .distance_symbol = 0});  // 3 from 1
  put_fixed(out, symbols, true);
  std::string expected;
  for (int i = 0; i < 130; ++i) expected += "ab";
  EXPECT_EQ(raw_of(out), expected + "bbb");
}

TEST(Inflate, EveryLengthAndDistanceCodeHasItsRange) {
  // The first and the last of each range, over a text that never repeats.
  const std::string text = noise(65535, 5, 256);
  struct Coded {
    unsigned base, extra;
  };
  std::vector<Coded> lengths, distances;
  for (unsigned code = 0, base = 3; code < 28; ++code) {
    const unsigned extra = code < 8 ? 0 : code / 4 - 1;
    lengths.push_back({base, extra});
    base += 1U << extra;
  }
  lengths.push_back({258, 0});
  for (unsigned code = 0, base = 1; code < 30; ++code) {
    const unsigned extra = code < 4 ? 0 : code / 2 - 1;
    distances.push_back({base, extra});
    base += 1U << extra;
  }
  ASSERT_EQ(distances.back().base + (1U << distances.back().extra) - 1, 32768U);
  for (const bool last : {false, true}) {
    BitWriter out;
    put_stored(out, text, false);
    std::string expected = text;
    std::vector<DeflateSymbol> symbols;
    for (unsigned i = 0; i < 30; ++i) {
      const unsigned l = std::min(i, 28U);
      DeflateSymbol s{257 + l, 0, lengths[l].extra, i, 0, distances[i].extra};
      // The last code of 258 is that without extra bits.
      if (last) s.extra = (1U << s.extra_bits) - 1;
      if (last) s.distance_extra = (1U << s.distance_extra_bits) - 1;
      symbols.push_back(s);
      const std::size_t distance = distances[i].base + s.distance_extra;
      for (unsigned k = lengths[l].base + s.extra; k > 0; --k) {
        expected += expected[expected.size() - distance];
      }
    }
    put_fixed(out, symbols, true);
    EXPECT_EQ(raw_of(out), expected);
  }
}

TEST(Inflate, DynamicCodesAreUpToFifteenBitsLong) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < 15; ++i) used.push_back('a' + i);
  used.push_back(256);
  const std::vector<unsigned> literals = skewed(257, used);
  ASSERT_EQ(literals[256], 15U);
  BitWriter out;
  put_dynamic(out, literals_of("abcdefghijklmnoonm"), literals, {0}, false);
  put_dynamic(out, literals_of("oa"), literals, {1}, true);
  EXPECT_EQ(raw_of(out), "abcdefghijklmnoonmoa");
}

TEST(Inflate, RunsOfCodeLengths) {
  // Literals 'a' and 256 of one bit each, written with codes 1 (a length), 17 and 18 (zeros).
  BitWriter out;
  out.put(1, 1);
  out.put(2, 2);
  out.put(0, 5);       // 257 literals
  out.put(1, 5);       // 2 distances
  out.put(18 - 4, 4);  // up to the length of symbol 1
  for (const int symbol : {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1}) {
    out.put(symbol == 18 || symbol == 17 || symbol == 1 || symbol == 16 ? 2 : 0, 3);
  }
  // Canonical: 1 → 00, 16 → 01, 17 → 10, 18 → 11.
  const auto zeros = [&](unsigned count) { out.put_code(3, 2), out.put(count - 11, 7); };
  zeros(97);
  out.put_code(0, 2);  // 'a'
  zeros(138);
  out.put_code(2, 2), out.put(7, 3);  // ten zeros
  out.put_code(2, 2), out.put(7, 3);  // ten zeros: 98 + 138 + 20 = 256
  out.put_code(0, 2);                 // end of block
  out.put_code(0, 2);                 // distance 1 …
  out.put_code(0, 2);                 // … and 2
  out.put(0, 1);                      // 'a'
  out.put(1, 1);                      // end
  EXPECT_EQ(raw_of(out), "a");
}

TEST(Inflate, WhatIsReadDoesNotDependOnThePieces) {
  std::string text;
  for (unsigned values : {2U, 7U, 256U}) text += noise(70000, values, values);
  const std::string packed = io::zlib_compressed(text);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{1000}, std::size_t{32768},
                                  std::size_t{100000}, text.size() + 1}) {
    const std::string shifted = "head" + packed + "tail";
    const MemoryBytes source(shifted);
    Inflater inflater(source, 4, Wrapping::zlib, "file");
    std::string all;
    std::string to(piece, '\0');
    for (;;) {
      const Result<std::size_t> got = inflater.read(to);
      ASSERT_TRUE(got.ok());
      all.append(to, 0, *got);
      if (*got < piece) break;
    }
    EXPECT_EQ(all, text) << piece;
    EXPECT_EQ(inflater.position(), 4 + packed.size());
  }
}

TEST(Inflate, WhatTheCompressorMakesComesBack) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::string text = noise(seed * seed * 40, seed, 1U + static_cast<unsigned>(seed) * 6);
    EXPECT_EQ(unpacked(io::zlib_compressed(text), Wrapping::zlib), text);
  }
}

TEST(Inflate, GzipMembersInARowAreOne) {
  const std::string two = gzipped("one") + gzipped("") + gzipped("two");
  EXPECT_EQ(unpacked(two, Wrapping::gzip), "onetwo");
  EXPECT_EQ(unpacked(two + std::string(100, '\0'), Wrapping::gzip), "onetwo");
}

TEST(Inflate, GzipHeadersHaveNamesCommentsAndSums) {
  const std::string body = gzipped("text").substr(10);
  std::string head("\x1F\x8B\x08\x1F\0\0\0\0\0\x03", 10);
  head += std::string("\x03\0xyz", 5) + std::string("name\0", 5) + std::string("why\0", 4);
  const std::string sum = little_word(crc32_by_bits(head)).substr(0, 2);
  EXPECT_EQ(unpacked(head + sum + body, Wrapping::gzip), "text");
  EXPECT_EQ(refusal(head + "??" + body, Wrapping::gzip),
            "the checksum of the gzip header is wrong (byte 26)");
}

TEST(Inflate, AMatchDoesNotReachIntoTheMemberBefore) {
  BitWriter out;
  put_fixed(out, {{.symbol = 257, .distance_symbol = 0}}, true);
  EXPECT_NE(
      refusal(gzipped("aaa") + gzip_member(out.bytes(), "aaa"), Wrapping::gzip).find("before"),
      std::string::npos);
}

TEST(Inflate, ChecksumsAndSizesAreCompared) {
  std::string zlib = zlibbed("text");
  zlib.back() = static_cast<char>(zlib.back() ^ 1);
  EXPECT_NE(refusal(zlib, Wrapping::zlib).find("checksum"), std::string::npos);
  std::string gzip = gzipped("text");
  std::string other = gzip;
  other[gzip.size() - 8] = static_cast<char>(other[gzip.size() - 8] ^ 1);
  EXPECT_NE(refusal(other, Wrapping::gzip).find("checksum"), std::string::npos);
  gzip.back() = 1;
  EXPECT_NE(refusal(gzip, Wrapping::gzip).find("another size"), std::string::npos);
}

TEST(Inflate, WhatIsCutOffIsRefusedWhereverItIsCut) {
  const std::string whole = gzipped(noise(300, 1, 256));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(refusal(whole.substr(0, size), Wrapping::gzip), "taken") << size;
  }
  const std::string packed = io::zlib_compressed(noise(300, 1, 9));
  for (std::size_t size = 0; size < packed.size(); ++size) {
    EXPECT_NE(refusal(packed.substr(0, size), Wrapping::zlib), "taken") << size;
  }
}

TEST(Inflate, WhatComesBeforeAnErrorIsHandedOut) {
  BitWriter out;
  const std::string symbols = noise(300, 1, 256);
  put_fixed(out, literals_of(symbols), true);
  const std::string cut = out.bytes().substr(0, 100);
  const MemoryBytes source(cut);
  Inflater inflater(source, 0, Wrapping::raw, "file");
  std::string to(60, '\0');
  const Result<std::size_t> got = inflater.read(to);
  ASSERT_TRUE(got.ok());
  EXPECT_EQ(to, symbols.substr(0, 60));
  EXPECT_FALSE(inflater.read(to).ok());
  EXPECT_FALSE(inflater.read(to).ok());
}

TEST(Inflate, MoreThanAskedForIsRefused) {
  const std::string bomb = io::zlib_compressed(std::string(1 << 20, '\0'));
  EXPECT_EQ(refusal(bomb, Wrapping::zlib, 1000),
            "the compressed data unpack to more than 1000 bytes");
  EXPECT_EQ(unpacked(bomb, Wrapping::zlib), std::string(1 << 20, '\0'));
}

TEST(Inflate, WrongDataAreNamed) {
  const auto raw = [](const BitWriter& out) { return refusal(out.bytes(), Wrapping::raw); };
  BitWriter type;
  type.put(7, 3);
  EXPECT_EQ(raw(type), "the compressed data have a block of an unknown type (byte 1)");
  BitWriter stored;
  stored.put(1, 8), stored.put(4, 16), stored.put(4, 16);
  EXPECT_NE(raw(stored).find("stored block"), std::string::npos);
  BitWriter length;
  put_fixed(length, {{.symbol = 287}}, true);
  EXPECT_NE(raw(length).find("unknown length"), std::string::npos);
  BitWriter distance;
  std::vector<DeflateSymbol> far = literals_of("abc");
  far.push_back({.symbol = 257, .distance_symbol = 30});
  put_fixed(distance, far, true);
  EXPECT_NE(raw(distance).find("unknown distance"), std::string::npos);
  far.back().distance_symbol = 3;
  BitWriter before;
  put_fixed(before, far, true);
  EXPECT_NE(raw(before).find("before their beginning"), std::string::npos);
}

TEST(Inflate, ImpossibleCodesAreNamed) {
  const auto header = [](std::vector<unsigned> literals, const std::vector<unsigned>& distances) {
    literals.resize(std::max<std::size_t>(literals.size(), 257), 0);
    BitWriter out;
    put_dynamic_header(out, literals, distances, true);
    out.put(0, 32);
    return refusal(out.bytes(), Wrapping::raw);
  };
  std::vector<unsigned> fine(257, 0);
  fine['a'] = 1;
  fine[256] = 1;
  EXPECT_NE(header(fine, {0}).find("cut off"), std::string::npos);  // 'a' for ever
  EXPECT_NE(header(fine, {1, 1, 1}).find("impossible code"), std::string::npos);
  EXPECT_NE(header(fine, {2, 2, 2}).find("impossible code"), std::string::npos);
  std::vector<unsigned> over = fine;
  over['b'] = 1;
  EXPECT_NE(header(over, {0}).find("impossible code"), std::string::npos);
  std::vector<unsigned> endless(257, 0);
  endless['a'] = endless['b'] = 1;
  EXPECT_NE(header(endless, {0}).find("without end"), std::string::npos);
  EXPECT_NE(header(std::vector<unsigned>(287, 9), {0}).find("too many"), std::string::npos);
}

TEST(Inflate, WhatIsNoSuchWrappingIsRefused) {
  EXPECT_NE(refusal("BZh9", Wrapping::gzip).find("no gzip data"), std::string::npos);
  EXPECT_NE(refusal("BZh9", Wrapping::zlib).find("no zlib data"), std::string::npos);
  EXPECT_NE(refusal("\x78\xBB\0\0\0\0", Wrapping::zlib).find("preset"), std::string::npos);
  EXPECT_NE(refusal(std::string("\x1F\x8B\x07\0", 4), Wrapping::gzip).find("method"),
            std::string::npos);
}

TEST(Checksums, AreThoseOfTheDefinition) {
  EXPECT_EQ(crc32(kCrcOfNothing, "123456789"), 0xCBF43926U);
  EXPECT_EQ(adler32(kAdlerOfNothing, "Wikipedia"), 0x11E60398U);
  const std::string text(20000, '\xFF');
  EXPECT_EQ(adler32(kAdlerOfNothing, text), adler32_by_bytes(text));
  for (const std::size_t cut : {1U, 3U, 7U, 5552U, 19999U}) {
    const std::string_view all = text;
    EXPECT_EQ(crc32(crc32(kCrcOfNothing, all.substr(0, cut)), all.substr(cut)),
              crc32_by_bits(text));
    EXPECT_EQ(adler32(adler32(kAdlerOfNothing, all.substr(0, cut)), all.substr(cut)),
              adler32_by_bytes(text));
  }
}

}  // namespace
}  // namespace tetloft
