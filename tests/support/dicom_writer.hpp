// DICOM data sets as tests make them, in any encoding. Shares no code with the product.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetloft::test {

struct DicomNode;
using DicomItem = std::vector<DicomNode>;

/// An element: of SQ the items, else the value, padded to an even length when written.
struct DicomNode {
  std::uint16_t group = 0;
  std::uint16_t element = 0;
  std::string vr;
  std::string value;
  std::vector<DicomItem> items;
};

inline DicomNode dicom_value(std::uint16_t group, std::uint16_t element, std::string vr,
                             std::string value) {
  return {group, element, std::move(vr), std::move(value), {}};
}
inline DicomNode dicom_sequence(std::uint16_t group, std::uint16_t element,
                                std::vector<DicomItem> items) {
  return {group, element, "SQ", {}, std::move(items)};
}

struct DicomStyle {
  bool explicit_vr = true;
  bool big_endian = false;
  bool undefined_sequences = false;
  bool undefined_items = false;
};

class DicomWriter {
 public:
  explicit DicomWriter(DicomStyle style) : style_(style) {}

  [[nodiscard]] std::string bytes_of(const DicomItem& item) const {
    std::string bytes;
    for (const DicomNode& node : item) bytes += bytes_of(node);
    return bytes;
  }

  [[nodiscard]] std::string bytes_of(const DicomNode& node) const {
    std::string body = node.value;
    if (body.size() % 2 != 0) body += node.vr == "UI" || node.vr == "OB" ? '\0' : ' ';
    const bool sequence = node.vr == "SQ";
    for (const DicomItem& item : node.items) body += item_bytes(item);
    const bool undefined = sequence && style_.undefined_sequences;
    if (undefined) body += tag(0xFFFE, 0xE0DD) + number32(0);
    const std::uint32_t length = undefined ? 0xFFFFFFFF : static_cast<std::uint32_t>(body.size());
    return tag(node.group, node.element) + representation(node.vr, length) + body;
  }

  [[nodiscard]] std::string tag(std::uint16_t group, std::uint16_t element) const {
    return number16(group) + number16(element);
  }
  [[nodiscard]] std::string number16(std::uint32_t value) const { return number(value, 2); }
  [[nodiscard]] std::string number32(std::uint32_t value) const { return number(value, 4); }

 private:
  [[nodiscard]] std::string number(std::uint32_t value, unsigned count) const {
    std::string bytes;
    for (unsigned i = 0; i < count; ++i) {
      const unsigned shift = 8 * (style_.big_endian ? count - 1 - i : i);
      bytes += static_cast<char>(value >> shift & 0xFFU);
    }
    return bytes;
  }

  [[nodiscard]] std::string representation(const std::string& vr, std::uint32_t length) const {
    if (!style_.explicit_vr) return number32(length);
    const bool wide = vr == "SQ" || vr == "UN" || vr == "OB" || vr == "OW" || vr == "UT";
    return vr + (wide ? std::string(2, '\0') + number32(length) : number16(length));
  }

  [[nodiscard]] std::string item_bytes(const DicomItem& item) const {
    const std::string body = bytes_of(item);
    if (!style_.undefined_items) {
      return tag(0xFFFE, 0xE000) + number32(static_cast<std::uint32_t>(body.size())) + body;
    }
    return tag(0xFFFE, 0xE000) + number32(0xFFFFFFFF) + body + tag(0xFFFE, 0xE00D) + number32(0);
  }

  DicomStyle style_;
};

/// Preamble and meta information in front of a data set; no preamble on request.
inline std::string dicom_part10(const std::string& syntax, const std::string& data_set,
                                bool preamble = true) {
  const DicomWriter writer({});
  const std::string meta =
      writer.bytes_of(DicomItem{dicom_value(2, 1, "OB", std::string("\0\1", 2)),
                                dicom_value(2, 2, "UI", "1.2.840.10008.5.1.4.1.1.481.3"),
                                dicom_value(2, 0x10, "UI", syntax)});
  const std::string length = writer.bytes_of(
      dicom_value(2, 0, "UL", writer.number32(static_cast<std::uint32_t>(meta.size()))));
  return (preamble ? std::string(128, '\0') + "DICM" : std::string()) + length + meta + data_set;
}

struct DicomContour {
  std::string data;
  std::string type = "CLOSED_PLANAR";
  std::string points = {};  ///< NumberOfContourPoints; empty: left out
  std::string vr = "DS";    ///< of the data
};

inline DicomNode dicom_contours(const std::vector<DicomContour>& contours) {
  std::vector<DicomItem> items;
  for (const DicomContour& contour : contours) {
    DicomItem item;
    if (!contour.type.empty()) item.push_back(dicom_value(0x3006, 0x42, "CS", contour.type));
    if (!contour.points.empty()) item.push_back(dicom_value(0x3006, 0x46, "IS", contour.points));
    if (!contour.data.empty()) item.push_back(dicom_value(0x3006, 0x50, contour.vr, contour.data));
    items.push_back(item);
  }
  return dicom_sequence(0x3006, 0x40, items);
}

inline DicomItem dicom_roi(const std::string& number, const std::string& name) {
  return {dicom_value(0x3006, 0x22, "IS", number), dicom_value(0x3006, 0x26, "LO", name)};
}

inline DicomItem dicom_roi_contour(const std::string& number,
                                   const std::vector<DicomContour>& contours) {
  return {dicom_contours(contours), dicom_value(0x3006, 0x84, "IS", number)};
}

/// A structure set; `characters` is its Specific Character Set, left out where empty.
inline DicomItem dicom_structure_set(const std::vector<DicomItem>& rois,
                                     const std::vector<DicomItem>& roi_contours,
                                     const std::string& characters = {}) {
  DicomItem set;
  if (!characters.empty()) set.push_back(dicom_value(8, 5, "CS", characters));
  set.push_back(dicom_value(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.481.3"));
  set.push_back(dicom_value(8, 0x60, "CS", "RTSTRUCT"));
  // What readers pass over: private data, unknown ones, a sequence of another kind.
  set.push_back(dicom_value(9, 0x10, "LO", "OUR OWN"));
  set.push_back(dicom_value(9, 0x1001, "UN", std::string("\xFE\xFF\x00\xE0", 4)));
  set.push_back(dicom_sequence(
      0x3006, 0x10,
      {{dicom_value(0x20, 0x52, "UI", "1.2.3"), dicom_sequence(0x3006, 0x12, {{}})}}));
  set.push_back(dicom_sequence(0x3006, 0x20, rois));
  set.push_back(dicom_sequence(0x3006, 0x39, roi_contours));
  set.push_back(dicom_sequence(0x3006, 0x80, {{dicom_value(0x3006, 0x84, "IS", "1")}}));
  return set;
}

/// A square of side 2 · `half` at `z`, as ContourData.
inline std::string dicom_square(int half, int z) {
  const std::string a = std::to_string(-half);
  const std::string b = std::to_string(half);
  const std::string c = '\\' + std::to_string(z);
  return a + '\\' + a + c + '\\' + b + '\\' + a + c + '\\' + b + '\\' + b + c + '\\' + a + '\\' +
         b + c;
}

}  // namespace tetloft::test
