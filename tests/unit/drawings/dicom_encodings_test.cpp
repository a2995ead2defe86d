// DICOM data sets in every encoding, and what is wrong with them.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/formats.hpp>

#include "support/deflated.hpp"
#include "support/dicom_writer.hpp"
#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

using namespace test;

const std::string kImplicit = "1.2.840.10008.1.2";
const std::string kExplicit = "1.2.840.10008.1.2.1";
const std::string kBig = "1.2.840.10008.1.2.2";
const std::string kDeflate = "1.2.840.10008.1.2.1.99";

DicomItem two_structures() {
  return dicom_structure_set({dicom_roi("1", "bladder"), dicom_roi("7", "rectum")},
                             {dicom_roi_contour("7", {{dicom_square(2, 0)}, {dicom_square(2, 3)}}),
                              dicom_roi_contour("1", {{dicom_square(5, 0)}})});
}

std::string written(DicomStyle style) { return DicomWriter(style).bytes_of(two_structures()); }

std::string deflated(const std::string& bytes) {
  BitWriter out;
  put_fixed(out, literals_of(bytes), true);
  return out.bytes();
}

void expect_two_structures(const std::string& bytes, std::size_t warnings = 0) {
  const auto read = inspected(bytes);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, "rtstruct");
  EXPECT_EQ(read->unit, "mm");
  EXPECT_EQ(read->warnings.size(), warnings) << warnings_of(read->warnings);
  ASSERT_EQ(read->structures.size(), 2U);
  const StructureSummary& bladder = read->structures[0];
  const StructureSummary& rectum = read->structures[1];
  EXPECT_EQ(bladder.number, 1);
  EXPECT_EQ(bladder.name, "bladder");
  EXPECT_EQ(bladder.contours, 1U);
  EXPECT_EQ(bladder.points, 4U);
  EXPECT_EQ(rectum.number, 7);
  EXPECT_EQ(rectum.contours, 2U);
  EXPECT_EQ(rectum.points, 8U);
  EXPECT_EQ(rectum.planes, 2U);
}

std::vector<DicomStyle> styles(bool explicit_vr, bool big_endian) {
  std::vector<DicomStyle> all;
  for (const bool sequences : {false, true}) {
    for (const bool items : {false, true}) {
      all.push_back({explicit_vr, big_endian, sequences, items});
    }
  }
  return all;
}

TEST(DicomEncodings, AllReadTheSame) {
  for (const DicomStyle& style : styles(false, false)) {
    expect_two_structures(dicom_part10(kImplicit, written(style)));
  }
  for (const DicomStyle& style : styles(true, false)) {
    expect_two_structures(dicom_part10(kExplicit, written(style)));
    expect_two_structures(dicom_part10(kDeflate, deflated(written(style))));
  }
  for (const DicomStyle& style : styles(true, true)) {
    expect_two_structures(dicom_part10(kBig, written(style)));
  }
}

TEST(DicomEncodings, NeedNoPreamble) {
  expect_two_structures(dicom_part10(kImplicit, written({.explicit_vr = false}), false));
  expect_two_structures(dicom_part10(kBig, written({.big_endian = true}), false));
  expect_two_structures(dicom_part10(kDeflate, deflated(written({})), false));
}

TEST(DicomEncodings, AreGuessedWithoutMetaInformation) {
  for (const bool big_endian : {false, true}) {
    for (const DicomStyle& style : styles(true, big_endian)) expect_two_structures(written(style));
  }
  for (const DicomStyle& style : styles(false, false)) expect_two_structures(written(style));
  // Behind a preamble, too.
  expect_two_structures(std::string(128, '\0') + "DICM" + written({}));
}

TEST(DicomEncodings, AreThoseOfTheDataSetWhereTheMetaInformationIsWrong) {
  expect_two_structures(dicom_part10(kExplicit, written({.explicit_vr = false})), 1);
  expect_two_structures(dicom_part10(kImplicit, written({})), 1);
  expect_two_structures(dicom_part10(kImplicit, written({.big_endian = true})), 1);
  // Of a packed image, of which a structure set has none.
  expect_two_structures(dicom_part10("1.2.840.10008.1.2.4.70", written({})), 1);
}

TEST(DicomEncodings, UnknownOnesAreNamed) {
  expect_error(dicom_part10("1.2.840.113619.5.2", written({})),
               {"1.2.840.113619.5.2", "transfer syntax"});
}

TEST(DicomEncodings, PaddingAtTheEndIsNone) {
  expect_two_structures(written({}) + std::string(6, '\0'));
  expect_two_structures(written({}) + DicomWriter({}).bytes_of(dicom_value(0xFFFC, 0xFFFC, "OB",
                                                                           std::string(20, '\0'))));
}

// A sequence that is written as of unknown kind is implicit, little endian, inside; with some
// writers as all else is.
TEST(DicomEncodings, SequencesMayBeHiddenAsUnknown) {
  const auto hidden = [](DicomStyle outside, DicomStyle inside) {
    DicomItem set = two_structures();
    for (DicomNode& node : set) {
      if (node.vr != "SQ" || (node.element != 0x20 && node.element != 0x39)) continue;
      node.value = DicomWriter(inside).bytes_of(node).substr(inside.explicit_vr ? 12 : 8);
      node.vr = "UN";
      node.items.clear();
    }
    return DicomWriter(outside).bytes_of(set);
  };
  expect_two_structures(hidden({}, {.explicit_vr = false}));
  expect_two_structures(hidden({.big_endian = true}, {.explicit_vr = false}));
  expect_two_structures(hidden({}, {}));
  expect_two_structures(hidden({.big_endian = true}, {.big_endian = true}));
}

// Pixel data in fragments stand between, in a file that is otherwise fine.
TEST(DicomEncodings, FragmentsArePassedOver) {
  const DicomWriter writer({});
  std::string pixels =
      writer.tag(0x7FE0, 0x10) + "OB" + std::string(2, '\0') + writer.number32(0xFFFFFFFF);
  for (int i = 0; i < 3; ++i) {
    pixels += writer.tag(0xFFFE, 0xE000) + writer.number32(4) + "\xFE\xFF\x01\x02";
  }
  expect_two_structures(written({}) + pixels + writer.tag(0xFFFE, 0xE0DD) + writer.number32(0));
  expect_error(written({}) + pixels, {"(7fe0,0010)", "ends within"});
}

TEST(DicomEncodings, SingleElementsMayBeImplicit) {
  const std::string odd =
      DicomWriter({.explicit_vr = false}).bytes_of(dicom_value(0x300E, 0x0002, "CS", "APPROVED"));
  expect_two_structures(written({}) + odd);
}

// A delimiter that is missing, or one too many.
TEST(DicomEncodings, DelimitersAreForgiven) {
  const DicomWriter writer({});
  const std::string end_of_item = writer.tag(0xFFFE, 0xE00D) + writer.number32(0);
  const std::string end = writer.tag(0xFFFE, 0xE0DD) + writer.number32(0);
  expect_two_structures(written({}) + end_of_item + end);
  std::string bytes = written({.undefined_sequences = true, .undefined_items = true});
  const std::size_t last = bytes.rfind(end_of_item + end);
  ASSERT_NE(last, std::string::npos);
  bytes.erase(last, end_of_item.size());
  expect_two_structures(bytes);
}

TEST(DicomEncodings, EveryCutIsAnErrorOrEndsBetweenElements) {
  for (const DicomStyle& style :
       {DicomStyle{}, DicomStyle{false, false, true, true}, DicomStyle{true, true, true, false}}) {
    const std::string bytes = written(style);
    std::size_t read_anyway = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const auto read = inspected(bytes.substr(0, size), "rtstruct");
      if (read) {
        ++read_anyway;
        continue;
      }
      EXPECT_EQ(read.error().where.file, "a.file");
      EXPECT_NE(read.error().message, "");
    }
    // Elements of the top: cut between them nothing tells, but that one of modality or class, or
    // of contours, has come.
    EXPECT_LE(read_anyway, 20U);
    EXPECT_GE(read_anyway, 3U);
  }
}

TEST(DicomEncodings, WrongLengthsAreNamedWithElementAndByte) {
  const DicomWriter writer({});
  DicomItem set = two_structures();
  const std::string good = writer.bytes_of(set);
  // The length of an element in an item, larger than its item.
  std::string bytes = good;
  const std::string name = "\x06\x30\x26";  // (3006,0026), with its third byte
  const std::size_t at = bytes.find(name);
  ASSERT_NE(at, std::string::npos);
  bytes[at + 6] = '\x40';
  expect_error(bytes, {"byte " + std::to_string(at), "(3006,0026)", "64 bytes", "(3006,0020)"});
  // Beyond the end of the file.
  bytes = good;
  const std::size_t modality = bytes.find(std::string("\x08\x00\x60\x00", 4));
  bytes[modality + 7] = '\x7F';
  expect_error(bytes, {"byte " + std::to_string(modality), "(0008,0060)", "cut off"});
  // Something else where an item has to be.
  bytes = good;
  const std::size_t item = bytes.find(std::string("\x06\x30\x20\x00SQ", 6)) + 12;
  bytes[item + 2] = '\x55';
  expect_error(bytes, {"byte " + std::to_string(item), "expected an item", "(3006,0020)"});
  // A representation that there is not.
  bytes = good;
  bytes[modality + 4] = 'X';
  expect_error(bytes, {"byte " + std::to_string(modality), "'XS'"});
}

TEST(DicomEncodings, DeflatedDataAreBounded) {
  BitWriter out;
  // A literal, then matches of the longest length at distance one.
  std::vector<DeflateSymbol> symbols = literals_of(std::string(1, '\0'));
  for (int i = 0; i < 40'000; ++i) symbols.push_back({.symbol = 285, .distance_symbol = 0});
  put_fixed(out, symbols, true);
  const std::string bytes = dicom_part10(kDeflate, out.bytes());
  expect_error(bytes, {"unpacks to more than"});
  expect_error(dicom_part10(kDeflate, deflated(written({})).substr(0, 100)), {"a.file"});
}

TEST(DicomEncodings, DeepNestingIsNoMatter) {
  const DicomWriter writer({});
  const std::string begin = writer.tag(0x3006, 0x10) + "SQ" + std::string(2, '\0') +
                            writer.number32(0xFFFFFFFF) + writer.tag(0xFFFE, 0xE000) +
                            writer.number32(0xFFFFFFFF);
  const std::string end = writer.tag(0xFFFE, 0xE00D) + writer.number32(0) +
                          writer.tag(0xFFFE, 0xE0DD) + writer.number32(0);
  std::string begins, ends;
  for (int i = 0; i < 100'000; ++i) {
    begins += begin;
    ends += end;
  }
  expect_two_structures(written({}) + begins + ends);
  expect_error(written({}) + begins, {"ends within"});
}

TEST(DicomEncodings, OtherFilesAreNotTakenForDicom) {
  EXPECT_FALSE(inspected("S 1\nv 3 z 0\n{ 0 0 1 0 0 1 }\n")->format == "rtstruct");
  expect_error("no DICOM at all", {"no DICOM file"}, "rtstruct");
  expect_error("", {"no DICOM file"}, "rtstruct");
  expect_error(std::string("\x08\0\x05\0", 4), {"no DICOM file"}, "rtstruct");
}

}  // namespace
}  // namespace tetloft
