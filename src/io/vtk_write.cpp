// VTK XML files of one piece (VTK File Formats, "XML File Formats").
#include "io/vtk_write.hpp"

#include <string_view>

#include "core/text.hpp"

namespace tetloft::io {

namespace {

// Names of arrays are the caller's.
std::string attribute_value(std::string_view text) {
  std::string value;
  for (const char c : valid_utf8(text)) {
    if (c == '&') {
      value += "&amp;";
    } else if (c == '<') {
      value += "&lt;";
    } else if (c == '"') {
      value += "&quot;";
    } else {
      value += c;
    }
  }
  return value;
}

std::string array_head(const VtkArray& array) {
  std::string text =
      "<DataArray type=\"" + array.type + "\" Name=\"" + attribute_value(array.name) + '"';
  if (array.components != 1) {
    text += " NumberOfComponents=\"" + std::to_string(array.components) + '"';
  }
  return text;
}

}  // namespace

void append_vtk_file(PendingFile& file, const std::string& grid_type, const std::string& counts,
                     const std::vector<VtkGroup>& groups, Encoding encoding) {
  const bool ascii = encoding == Encoding::ascii;
  file.append("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + grid_type +
              "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" +
              grid_type + ">\n<Piece " + counts + ">\n");
  std::uint64_t offset = 0;
  for (const VtkGroup& group : groups) {
    file.append('<' + group.element + ">\n");
    for (const VtkArray& array : group.arrays) {
      if (ascii) {
        file.append(array_head(array) + " format=\"ascii\">\n");
        array.append_text(file);
        file.append("</DataArray>\n");
      } else {
        file.append(array_head(array) + " format=\"appended\" offset=\"" + std::to_string(offset) +
                    "\"/>\n");
        offset += sizeof(std::uint64_t) + array.bytes;
      }
    }
    file.append("</" + group.element + ">\n");
  }
  file.append("</Piece>\n</" + grid_type + ">\n");
  if (!ascii) {
    file.append("<AppendedData encoding=\"raw\">\n_");
    for (const VtkGroup& group : groups) {
      for (const VtkArray& array : group.arrays) {
        if (!file.ok()) return;
        std::string count;
        append_little(count, static_cast<std::uint64_t>(array.bytes));
        file.append(count);
        array.append_bytes(file);
      }
    }
    file.append("\n</AppendedData>\n");
  }
  file.append("</VTKFile>\n");
}

}  // namespace tetloft::io
