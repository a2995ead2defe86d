// What readers of drawings take of memory, over files made to take much.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "io/files.hpp"
#include "support/counted_memory.hpp"
#include "support/deflated.hpp"
#include "support/dicom_writer.hpp"
#include "support/imod_writer.hpp"

namespace tetloft {

using namespace internal;
using namespace test;
namespace {

constexpr std::size_t kSize = 400'000;
static_assert(kSize > kReaderBytes / kReaderMultiple * 10);

struct Family {
  const char* name;
  std::string bytes;
};

// `times` is the multiple of the file's size that is allowed.
void expect_bounded(const char* format, const std::vector<Family>& families,
                    std::size_t times = kReaderMultiple) {
  for (const Family& family : families) {
    const ReadOptions options{.format = format};
    const std::size_t bytes =
        std::max(peak_of([&] { static_cast<void>(inspect_bytes(family.bytes, "a", options)); }),
                 peak_of([&] {
                   ReadOptions unchecked = options;
                   unchecked.validity = Validity::unchecked;
                   static_cast<void>(parse_stack(family.bytes, "a", unchecked));
                 }));
    const std::size_t size = family.bytes.size();
    EXPECT_LE(bytes + size, times * size + kReaderBytes)
        << format << ", " << family.name << ": " << bytes / size << " times its " << size
        << " bytes";
  }
}

std::string many(const std::string& piece) { return repeated(piece, kSize); }

// A structure set of one structure in which these bytes are the items of ContourSequence.
std::string set_of(const std::string& contours) {
  const DicomWriter writer({.explicit_vr = false});
  DicomNode node = dicom_sequence(0x3006, 0x40, {});
  node.value = contours;
  return writer.bytes_of(
      dicom_structure_set({dicom_roi("1", "a")}, {{node, dicom_value(0x3006, 0x84, "IS", "1")}}));
}

// An item of ContourSequence with these contents.
std::string item_of(const DicomItem& item) {
  DicomNode node = dicom_sequence(0x3006, 0x40, {item});
  return DicomWriter({.explicit_vr = false}).bytes_of(node).substr(8);
}

TEST(DrawingMemory, OfStructureSetsIsBounded) {
  const DicomWriter writer({.explicit_vr = false});
  std::vector<DicomItem> empty_rois(kSize / 8);
  const std::string unending = writer.tag(0x3006, 0x39) + writer.number32(0xFFFFFFFF);
  const std::string item = writer.tag(0xFFFE, 0xE000) + writer.number32(0xFFFFFFFF);
  std::string points = "0\\0\\0";
  while (points.size() < kSize) points += "\\0\\0\\0";
  const std::string square = dicom_square(1, 0);
  expect_bounded(
      "rtstruct",
      {{"empty contours", set_of(many(item_of({})))},
       {"contours of a type",
        set_of(many(item_of({dicom_value(0x3006, 0x42, "CS", "CLOSEDPLANAR_XOR")})))},
       {"contours of unknown types",
        set_of(many(item_of({dicom_value(0x3006, 0x42, "CS", "AN UNKNOWN TYPE OF OUR OWN")})))},
       {"contours of a point", set_of(many(item_of({dicom_value(0x3006, 0x50, "DS", "0\\0\\0")})))},
       {"squares", set_of(many(item_of({dicom_value(0x3006, 0x50, "DS", square)})))},
       {"one contour", set_of(item_of({dicom_value(0x3006, 0x50, "DS", points)}))},
       {"separators", set_of(item_of({dicom_value(0x3006, 0x50, "DS", std::string(kSize, '\\'))}))},
       {"empty structures", writer.bytes_of(dicom_structure_set(empty_rois, {}))},
       {"empty items", writer.bytes_of(dicom_structure_set({}, empty_rois))},
       {"deep", writer.bytes_of(dicom_structure_set({}, {})) + many(unending + item)},
       {"elements", many(writer.bytes_of(dicom_value(0x0008, 0x0060, "CS", "")))},
       {"long name",
        writer.bytes_of(dicom_structure_set({dicom_roi("1", std::string(kSize, '\xE4'))}, {}))}});
}

// Of what they unpack to, which is bounded by their size in turn.
TEST(DrawingMemory, OfDeflatedStructureSetsIsBounded) {
  BitWriter out;
  std::vector<DeflateSymbol> symbols = literals_of(std::string(1, '\0'));
  for (int i = 0; i < 400'000; ++i) symbols.push_back({.symbol = 285, .distance_symbol = 0});
  put_fixed(out, symbols, true);
  expect_bounded("rtstruct", {{"zeros", dicom_part10("1.2.840.10008.1.2.1.99", out.bytes())}}, 130);
}

TEST(DrawingMemory, OfTextIsBounded) {
  const std::string names = "ROI_NAMES\n1||a\nEND_OF_ROI_NAMES\n";
  expect_bounded("cxt", {{"structures", "ROI_NAMES\n" + many("1||\n") + "END_OF_ROI_NAMES\n"},
                         {"contours", names + many("1|||||\n")},
                         {"other structures", names + many("2|||||\n")},
                         {"points", names + "1|||||" + many("0\\0\\0\\") + "\n"},
                         {"triangles", names + many("1|||||0\\0\\0\\0\\1\\0\\1\\0\\0\n")},
                         {"bars", names + many("|")},
                         {"keys", many("A\n")}});
  const std::string plane = "CSLC\n1 2\n1 1 99999999 0 0 1 0\n0 0 0\n";
  expect_bounded("csl", {{"planes", "CSLC\n99999999 1\n" + many("1 0 0 0 0 1 0\n")},
                         {"vertices", "CSLC\n1 2\n1 99999999 1 0 0 1 0\n" + many("0 0 0\n")},
                         {"components", plane + many("1 1 0\n")},
                         {"triangles", "CSLC\n1 2\n1 3 99999999 0 0 1 0\n0 0 0\n0 1 0\n1 0 0\n" +
                                           many("3 1 0 1 2\n")},
                         {"words", plane + many("1 ")},
                         {"comments", "CSLC\n" + many("#\n")}});
  const std::string slice = "slice 0\ncontour closed\n";
  expect_bounded("slc", {{"slices", many("slice 0\n")},
                         {"contours", "slice 0\n" + many("contour closed\nadjacent\n-1\n")},
                         {"points", slice + many("0 0\n")},
                         {"adjacency", slice + "adjacent\n" + many("0 ")},
                         {"adjacent lines", slice + "adjacent\n" + many("0\n")}});
}

TEST(DrawingMemory, OfAdjacencyThatHoldsIsBounded) {
  std::string file = "slice 0\ncontour closed\n0 0\n1 0\n0 1\nadjacent\n" + many("0 ") + "-1\n";
  file += "slice 1\ncontour closed\n0 0\n1 0\n0 1\nadjacent\n-1\n";
  expect_bounded("slc", {{"joins", file}});
}

TEST(DrawingMemory, OfModelsIsBounded) {
  const std::string begin = imod_header({}) + imod_object("a", 1);
  expect_bounded("imod", {{"objects", imod_header({}) + many(imod_object("", 0))},
                          {"contours", begin + many(imod_contour({}))},
                          {"contours of a point", begin + many(imod_contour({{0, 0, 0}}))},
                          {"pieces", begin + many(imod_piece("VIEW", ""))},
                          {"points", begin + imod_contour(std::vector<Point3>(kSize / 12))}});
}

}  // namespace
}  // namespace tetloft
