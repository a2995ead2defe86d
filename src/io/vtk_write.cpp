// VTK XML files of one piece (VTK File Formats, "XML File Formats").
#include "io/vtk_write.hpp"

#include <string_view>

#include "core/text.hpp"

namespace tetloft::internal::io {

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

bool is_vtk_file(std::string_view bytes, std::string_view grid_type) {
  constexpr std::size_t kBeginning = 4096;  // room for comments before the tag
  const std::string_view head = bytes.substr(0, kBeginning);
  const std::size_t tag = head.find("<VTKFile");
  if (tag == std::string_view::npos) return false;
  const std::string_view attributes = head.substr(tag, head.find('>', tag) - tag);
  return attributes.find('"' + std::string(grid_type) + '"') != std::string_view::npos ||
         attributes.find('\'' + std::string(grid_type) + '\'') != std::string_view::npos;
}

void append_vtk_file(Sink& sink, const std::string& grid_type, const std::string& counts,
                     const std::vector<VtkGroup>& groups, Encoding encoding) {
  const bool ascii = encoding == Encoding::ascii;
  sink.append("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + grid_type +
              "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" +
              grid_type + ">\n<Piece " + counts + ">\n");
  std::uint64_t offset = 0;
  for (const VtkGroup& group : groups) {
    sink.append('<' + group.element + ">\n");
    for (const VtkArray& array : group.arrays) {
      if (ascii) {
        sink.append(array_head(array) + " format=\"ascii\">\n");
        array.append_text(sink);
        sink.append("</DataArray>\n");
      } else {
        sink.append(array_head(array) + " format=\"appended\" offset=\"" + std::to_string(offset) +
                    "\"/>\n");
        offset += sizeof(std::uint64_t) + array.bytes;
      }
    }
    sink.append("</" + group.element + ">\n");
  }
  sink.append("</Piece>\n</" + grid_type + ">\n");
  if (!ascii) {
    sink.append("<AppendedData encoding=\"raw\">\n_");
    for (const VtkGroup& group : groups) {
      for (const VtkArray& array : group.arrays) {
        if (!sink.ok()) return;
        std::string count;
        append_little(count, static_cast<std::uint64_t>(array.bytes));
        sink.append(count);
        array.append_bytes(sink);
      }
    }
    sink.append("\n</AppendedData>\n");
  }
  sink.append("</VTKFile>\n");
}

}  // namespace tetloft::internal::io
