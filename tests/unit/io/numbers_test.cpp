// Numbers as text. Expected values are C++ literals, thus the compiler's own conversion.
#include "io/numbers.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <utility>

#include "core/prng.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::internal::io {
namespace {

using test::bits;

TEST(ParseNumber, TakesEveryFormOfStrtod) {
  const std::vector<std::pair<const char*, double>> forms{
      {"0", 0.0},
      {"-0", -0.0},
      {"+1.5", 1.5},
      {"-1.", -1.0},
      {".5", 0.5},
      {"-.5e-3", -.5e-3},
      {"1E+05", 1e5},
      {"00012", 12.0},
      {"0x10", 16.0},
      {"0X1.8P+3", 12.0},
      {"-0x.8p-1", -0.25},
      {"0x1.", 1.0},
      {"1e22", 1e22},
      {"1.7976931348623157e308", std::numeric_limits<double>::max()},
      {"4.9e-324", 5e-324},
      {"0x1p-1074", 5e-324},
      {"0e99999999999999999999", 0.0},
      {"-0x0p99999999999999999999", -0.0}};
  for (const auto& [text, value] : forms) {
    const ParsedNumber number = parse_number(text);
    EXPECT_TRUE(number.ok()) << text;
    EXPECT_EQ(bits(number.value), bits(value)) << text;
  }
}

TEST(ParseNumber, RoundsHexadecimalOnceToEven) {
  const std::vector<std::pair<const char*, double>> forms{
      {"0x1.00000000000008p0", 0x1p0},                // a tie: down to even
      {"0x1.00000000000018p0", 0x1.0000000000002p0},  // a tie: up to even
      {"0x1.000000000000080000000000001p0", 0x1.0000000000001p0},
      {"0x1p-1075", 0.0},  // half of the least denormal
      {"0x1.8p-1075", 0x1p-1074},
      {"0x1.0000000000000000000001p-1075", 0x1p-1074},
      // To 53 bits first and to 51 then, the tie would go the other way.
      {"0x368.10a494aaff5p-1033", 0x0.6d021492955ffp-1022},
      {"0x1.fffffffffffff7p1023", std::numeric_limits<double>::max()}};
  for (const auto& [text, value] : forms) {
    const ParsedNumber number = parse_number(text);
    EXPECT_TRUE(number.ok()) << text;
    EXPECT_EQ(bits(number.value), bits(value)) << text;
  }
}

TEST(ParseNumber, TurnsWhatIsTooSmallIntoZeroOfItsSign) {
  for (const char* text : {"1e-400", "1e-99999999999999999999", "0x1p-99999999999999999999"}) {
    EXPECT_EQ(bits(parse_number(text).value), bits(0.0)) << text;
    EXPECT_TRUE(parse_number(text).ok()) << text;
  }
  EXPECT_EQ(bits(parse_number("-1e-400").value), bits(-0.0));
  EXPECT_TRUE(parse_number("0." + std::string(400, '0') + "1").ok());
  // 1e100 after all: many digits alone are not too large.
  EXPECT_EQ(parse_number("1" + std::string(400, '0') + "e-300").value, 1e100);
}

TEST(ParseNumber, RefusesWhatIsNotFinite) {
  for (const char* text :
       {"inf", "-inf", "nan", "INFINITY", "1e309", "-1e400", "0x1p1024", "0x1.fffffffffffff8p1023",
        "1e99999999999999999999", "0x1p99999999999999999999"}) {
    EXPECT_EQ(parse_number(text).status, NumberStatus::not_finite) << text;
  }
  EXPECT_EQ(parse_number("1" + std::string(400, '0')).status, NumberStatus::not_finite);
}

TEST(ParseNumber, RefusesWhatIsNoNumber) {
  for (const char* text : {"",     "+",     "-",   ".",     "abc",     "1e",  "1e+",  "+-1",
                           "--1",  "1,5",   "1_0", "1d5",   "0x",      "0x.", "0x1p", "0x1p+-3",
                           "0x-5", "0xinf", "0xg", "1.2.3", "0x1.2.3", " 1",  "1 ",   "1x"}) {
    EXPECT_EQ(parse_number(text).status, NumberStatus::malformed) << text;
  }
}

TEST(ParseNumber, IgnoresTheLocale) {
  // Where the locale is not installed this shows nothing, and costs nothing.
  const char* const set = setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(parse_number("1.5").value, 1.5);
  EXPECT_FALSE(parse_number("1,5").ok());
  std::string text;
  append_number(text, 1.5);
  EXPECT_EQ(text, "1.5");
  if (set != nullptr) setlocale(LC_ALL, "C");
}

TEST(AppendNumber, ReadsBackExactly) {
  Prng prng(20240611);
  std::vector<double> values = test::hard_doubles();
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(prng.next());
    if (std::isfinite(value)) values.push_back(value);
  }
  for (const double value : values) {
    std::string text;
    append_number(text, value);
    const ParsedNumber number = parse_number(text);
    ASSERT_TRUE(number.ok()) << text;
    ASSERT_EQ(bits(number.value), bits(value)) << text;
  }
}

TEST(ParseInteger, TakesWholeDecimalsOnly) {
  EXPECT_EQ(parse_integer("+12"), 12);
  EXPECT_EQ(parse_integer("-3"), -3);
  for (const char* text : {"", "+", "-", "1.0", "1e3", "0x1", "+-1", "99999999999999999999"}) {
    EXPECT_FALSE(parse_integer(text).has_value()) << text;
  }
}

TEST(InQuotes, IsShortAndPrintable) {
  EXPECT_EQ(in_quotes("a\x01\xFFz"), "'a\\x01\\xffz'");
  EXPECT_EQ(in_quotes("Zähne"), "'Zähne'");
  // Cut between characters: 39 bytes and a character of two.
  EXPECT_EQ(in_quotes(std::string(39, 'x') + "ä"), '\'' + std::string(39, 'x') + "…'");
  EXPECT_LT(in_quotes(std::string(1000, 'x')).size(), 60U);
}

}  // namespace
}  // namespace tetloft::internal::io
