// Text from outside: strict UTF-8, and what is not passed on.
#include "core/text.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>

#include "core/prng.hpp"

namespace tetloft {

using namespace internal;
namespace {

// By the definition instead of the table: decode as the lead byte says, then require the shortest
// form and a scalar value.
std::optional<char32_t> decoded(const std::string& bytes) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::size_t length = 1;
  while (length < 5 && (at(0) & (0x80U >> length)) != 0) ++length;
  if (at(0) < 0x80) return bytes.size() == 1 ? std::optional<char32_t>(at(0)) : std::nullopt;
  if (length == 1 || length > 4 || bytes.size() != length) return std::nullopt;
  char32_t code = at(0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((at(i) & 0xC0U) != 0x80) return std::nullopt;
    code = code << 6U | (at(i) & 0x3FU);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool scalar = code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
  return scalar && code >= kLeast[length] ? std::optional(code) : std::nullopt;
}

std::string encoded(char32_t code) {
  std::string text;
  const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6U);
    add(0x80 | (code & 0x3FU));
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12U);
    add(0x80 | (code >> 6U & 0x3FU));
    add(0x80 | (code & 0x3FU));
  } else {
    add(0xF0 | code >> 18U);
    add(0x80 | (code >> 12U & 0x3FU));
    add(0x80 | (code >> 6U & 0x3FU));
    add(0x80 | (code & 0x3FU));
  }
  return text;
}

void expect_clean(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const TextUnit unit = first_unit(std::string_view(text).substr(i));
    ASSERT_TRUE(unit.valid);
    ASSERT_FALSE(misleads(unit.code));
    i += unit.length;
  }
}

TEST(FirstUnit, TakesEveryScalarValueAndNothingElse) {
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    const std::string text = encoded(code);
    const TextUnit unit = first_unit(text);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    ASSERT_EQ(unit.valid, !surrogate) << std::uint32_t{code};
    if (unit.valid) {
      ASSERT_EQ(unit.code, code);
      ASSERT_EQ(unit.length, text.size());
    }
  }
}

TEST(FirstUnit, AgreesWithTheDefinitionOnRandomBytes) {
  Prng prng(1);
  int valid = 0;
  for (int k = 0; k < 300'000; ++k) {
    std::string bytes;
    const std::size_t length = 1 + prng.below(4);
    for (std::size_t i = 0; i < length; ++i) {
      // Mostly what may follow a lead byte, so that long forms occur.
      const std::uint64_t byte =
          i == 0 ? 0x80 + prng.below(0x80) : 0x70 + prng.below(prng.below(8) == 0 ? 0x90 : 0x50);
      bytes += static_cast<char>(byte);
    }
    const TextUnit unit = first_unit(bytes);
    const auto expected = decoded(bytes);
    if (expected) {
      ++valid;
      ASSERT_TRUE(unit.valid);
      ASSERT_EQ(unit.code, *expected);
      ASSERT_EQ(unit.length, bytes.size());
    } else if (unit.valid) {
      ASSERT_LT(unit.length, bytes.size());
    } else {
      ASSERT_EQ(unit.length, 1U);
    }
  }
  EXPECT_GT(valid, 1000);
}

TEST(Printable, EscapesWhatMisleadsAndKeepsTheRest) {
  EXPECT_EQ(printable("a\x1b[31mb\n\x7f"), "a\\x1b[31mb\\x0a\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\x9b31m");
  EXPECT_EQ(printable("\x9B"), "\\x9b");
  EXPECT_EQ(printable("\xE2\x80\xAE"
                      "gnp.exe"),
            "\\u{202e}gnp.exe");
  EXPECT_EQ(printable("Zähne 歯 🦷 \\n"), "Zähne 歯 🦷 \\n");
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, IsCleanAndStableForEveryCharacterAndByte) {
  for (char32_t code = 0; code <= 0x10FFFF; code += code < 0x3000 ? 1 : 97) {
    const std::string shown = printable("a" + encoded(code) + "b");
    expect_clean(shown);
    ASSERT_EQ(printable(shown), shown);
  }
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const std::string bytes{static_cast<char>(first), static_cast<char>(second)};
      const std::string shown = printable(bytes);
      expect_clean(shown);
      ASSERT_EQ(printable(shown), shown);
    }
  }
}

TEST(ValidUtf8, IsWhatADocumentMayHold) {
  EXPECT_EQ(valid_utf8("Zähne\t🦷\n"), "Zähne\t🦷\n");
  EXPECT_EQ(valid_utf8(std::string("a\0b\xFF", 4)),
            "a\xEF\xBF\xBD"
            "b\xEF\xBF\xBD");
  EXPECT_EQ(valid_utf8("\xED\xA0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_EQ(valid_utf8("\xEF\xBF\xBF"), "\xEF\xBF\xBD");
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const std::string valid =
          valid_utf8(std::string{static_cast<char>(first), static_cast<char>(second)});
      for (std::size_t i = 0; i < valid.size();) {
        const TextUnit unit = first_unit(std::string_view(valid).substr(i));
        ASSERT_TRUE(unit.valid);
        ASSERT_TRUE(unit.code >= 0x20 || unit.code == '\t' || unit.code == '\n' ||
                    unit.code == '\r');
        i += unit.length;
      }
    }
  }
}

}  // namespace
}  // namespace tetloft
