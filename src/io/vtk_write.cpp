// VTK XML files of one piece (VTK File Formats, "XML File Formats").
#include "io/vtk_write.hpp"

#include <string_view>

#include "io/xml_text.hpp"

namespace tetloft::internal::io {

namespace {

// The data of the whole have a count of their own: nothing else says how many they are.
std::string array_head(const VtkArray& array, bool of_whole) {
  std::string text =
      "<DataArray type=\"" + array.type + "\" Name=\"" + xml_text(array.name) + '"';
  if (array.components != 1) {
    text += " NumberOfComponents=\"" + std::to_string(array.components) + '"';
  }
  if (of_whole) text += " NumberOfTuples=\"" + std::to_string(array.tuples) + '"';
  return text;
}

// The elements of groups, one after the other: arrays as text, or where they are appended.
class HeadWriter {
 public:
  HeadWriter(Sink& sink, Encoding encoding) : sink_(sink), ascii_(encoding == Encoding::ascii) {}

  void append(const VtkGroup& group, bool of_whole = false) {
    sink_.append('<' + group.element + ">\n");
    for (const VtkArray& array : group.arrays) {
      if (ascii_) {
        sink_.append(array_head(array, of_whole) + " format=\"ascii\">\n");
        array.append_text(sink_);
        sink_.append("</DataArray>\n");
      } else {
        sink_.append(array_head(array, of_whole) + " format=\"appended\" offset=\"" +
                     std::to_string(offset_) + "\"/>\n");
        offset_ += sizeof(std::uint64_t) + array.bytes;
      }
    }
    sink_.append("</" + group.element + ">\n");
  }

 private:
  Sink& sink_;
  bool ascii_;
  std::uint64_t offset_ = 0;
};

void append_bytes(Sink& sink, const VtkGroup& group) {
  for (const VtkArray& array : group.arrays) {
    if (!sink.ok()) return;
    std::string count;
    append_little(count, static_cast<std::uint64_t>(array.bytes));
    sink.append(count);
    array.append_bytes(sink);
  }
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

void append_vtk_file(Sink& sink, const VtkFile& file, Encoding encoding) {
  sink.append("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + file.grid_type +
              "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" +
              file.grid_type + ">\n");
  HeadWriter head(sink, encoding);
  if (!file.field_data.arrays.empty()) head.append(file.field_data, true);
  sink.append("<Piece " + file.counts + ">\n");
  for (const VtkGroup& group : file.groups) head.append(group);
  sink.append("</Piece>\n</" + file.grid_type + ">\n");
  if (encoding != Encoding::ascii) {
    sink.append("<AppendedData encoding=\"raw\">\n_");
    append_bytes(sink, file.field_data);
    for (const VtkGroup& group : file.groups) append_bytes(sink, group);
    if (!sink.ok()) return;
    sink.append("\n</AppendedData>\n");
  }
  sink.append("</VTKFile>\n");
}

}  // namespace tetloft::internal::io
