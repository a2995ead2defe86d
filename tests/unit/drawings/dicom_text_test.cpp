// Names in the character sets of DICOM. The bytes are those of the code tables of ISO 8859, JIS
// and KS, written down here by hand.
#include "io/drawing/dicom_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/dicom_writer.hpp"
#include "unit/drawings/drawing_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

void expect_text(const std::string& set, const std::string& bytes, const std::string& utf8) {
  const auto text = io::DicomCharacters(set).decode(bytes);
  EXPECT_EQ(text.text, utf8) << set;
  EXPECT_EQ(text.odd, "") << set;
}

void expect_odd(const std::string& set, const std::string& bytes, const std::string& shown) {
  const auto text = io::DicomCharacters(set).decode(bytes);
  EXPECT_EQ(text.text, shown) << set;
  EXPECT_NE(text.odd, "") << set;
}

TEST(DicomText, AsciiIsTheSameInAll) {
  for (const char* const set : {"", "ISO_IR 6", "ISO_IR 100", "ISO_IR 192", "GB18030", "nonsense",
                                "\\ISO 2022 IR 87", "ISO 2022 IR 6\\ISO 2022 IR 149"}) {
    expect_text(set, "  Left lung ~\\[1] ", "Left lung ~\\[1]");
  }
  expect_text("ISO_IR 100", std::string("a\0", 2), "a");
}

TEST(DicomText, PartsOfIso8859) {
  expect_text("ISO_IR 100", "Bl\xE4schen\xFF", "Bläschenÿ");
  expect_text("ISO_IR 101", "P\xEC\xBB\xE1tko \xA3", "Pěťátko Ł");
  expect_text("ISO_IR 109", "\xA1\xF8\xFD", "Ħĝŭ");
  expect_text("ISO_IR 110", "\xA2\xBF\xFE", "ĸŋū");
  expect_text("ISO_IR 144", "\xBC\xDE\xD7\xD3 \xF0", "Мозг №");
  expect_text("ISO_IR 127", "\xC7\xE4\xF2", "\xD8\xA7\xD9\x84\xD9\x92");
  expect_text("ISO_IR 126", "\xD3\xF9\xED\xE1", "Σωνα");
  expect_text("ISO_IR 138", "\xE0\xFA", "את");
  expect_text("ISO_IR 148", "\xD0\xDD\xDE\xFD\xFE", "ĞİŞış");
  expect_text("ISO_IR 203", "\xA4\xBD", "€œ");
  expect_text("ISO_IR 166", "\xA1\xDF\xFB", "ก฿๛");
  expect_text("ISO_IR 13", "\xD4\xCF\xC0\xDE", "ﾔﾏﾀﾞ");
}

TEST(DicomText, NamesOfSetsAreTakenAsWritersHaveThem) {
  for (const char* const set : {"ISO_IR 144", "ISO-IR 144", "ISO IR 144", "iso_ir 144", "ISO_IR144",
                                "ISO 2022 IR 144", " ISO_IR 144 "}) {
    expect_text(set, "\xBC", "М");
  }
}

TEST(DicomText, Utf8) {
  expect_text("ISO_IR 192", "前立腺 Ødem", "前立腺 Ødem");
  expect_odd("ISO_IR 192", "Bl\xE4schen", "Bl\\xe4schen");
}

TEST(DicomText, BytesOfNoSetAreUtf8OrLatin1) {
  expect_odd("", "Bl\xE4schen", "Bläschen");
  expect_odd("", "Bläschen", "Bläschen");
  expect_odd("ISO_IR 6", "\xE9", "é");
}

TEST(DicomText, BytesThatStandForNothingAreShown) {
  expect_odd("ISO_IR 138",
             "a\xBF"
             "b",
             "a\\xbf"
             "b");
  expect_odd("ISO_IR 100", "a\x85", "a\\x85");
  expect_odd("nonsense", "a\xE4", "a\\xe4");
  // A byte of a pair may look like ASCII.
  expect_odd("GB18030",
             "a\xB0\x5C"
             "b",
             "a\\xb0\\x5c"
             "b");
  expect_odd("GBK", "\xB0", "\\xb0");
}

TEST(DicomText, EscapeSequences) {
  expect_text("\\ISO 2022 IR 144", "Brain \x1B-L\xBC\xDE\xD7\xD3", "Brain Мозг");
  expect_text("ISO 2022 IR 100\\ISO 2022 IR 126", "\xE4 \x1B-F\xD3 \x1B-A\xE4", "ä Σ ä");
  expect_text("ISO 2022 IR 13\\ISO 2022 IR 87", "\x1B)I\xD4\x1B(J", "ﾔ");
  // Japanese of two bytes, and Korean: shown, and what is ASCII after them read again.
  expect_odd("\\ISO 2022 IR 87", "a\x1B$B;3\x1B(Bb",
             "a\\x1b\\x24\\x42\\x3b\\x33"
             "b");
  expect_odd("\\ISO 2022 IR 149",
             "a\x1B$)C\xB1\xE8"
             "b",
             "a\\x1b\\x24\\x29\\x43\\xb1\\xe8"
             "b");
  expect_odd("\\ISO 2022 IR 87", "a\x1B", "a\\x1b");
  expect_odd("\\ISO 2022 IR 87", "a\x1B$", "a\\x1b\\x24");
}

TEST(DicomText, NamesOfStructuresAreDecoded) {
  using namespace test;
  const auto read = inspected(DicomWriter({}).bytes_of(
      dicom_structure_set({dicom_roi("1", "\xBC"), dicom_roi("2", "\x85")}, {}, "ISO_IR 144")));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->structures[0].name, "М");
  EXPECT_EQ(read->structures[1].name, "\\x85");
  expect_warning(read->warnings, {"ROI 2", "ISO_IR 144"});
}

}  // namespace
}  // namespace tetloft
