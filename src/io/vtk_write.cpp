// VTK XML files of one piece (VTK File Formats, "XML File Formats").
#include "io/vtk_write.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "io/base64.hpp"
#include "io/bytes/deflate.hpp"
#include "io/vtk_data.hpp"
#include "io/xml_text.hpp"

namespace tetloft::internal::io {

namespace {

// The data of the whole have a count of their own: nothing else says how many they are.
std::string array_head(const VtkArray& array, bool of_whole) {
  std::string text = "<DataArray type=\"" + array.type + "\" Name=\"" + xml_text(array.name) + '"';
  if (array.components != 1) {
    text += " NumberOfComponents=\"" + std::to_string(array.components) + '"';
  }
  if (of_whole) text += " NumberOfTuples=\"" + std::to_string(array.tuples) + '"';
  return text;
}

// Data in blocks, each a zlib stream of its own.
class BlockSink final : public Sink {
 public:
  void append(std::string_view bytes) override {
    while (!bytes.empty()) {
      const std::size_t taken = std::min(bytes.size(), kBlock - open_.size());
      open_ += bytes.substr(0, taken);
      bytes.remove_prefix(taken);
      if (open_.size() == kBlock) close();
    }
  }

  // Behind the number of blocks, their size, that of the last if it is less, and each one's packed.
  [[nodiscard]] std::string take() {
    const std::size_t last = open_.size();
    if (last != 0) close();
    std::string all;
    for (const std::uint64_t word :
         {std::uint64_t{packed_.size()}, std::uint64_t{kBlock}, std::uint64_t{last}}) {
      append_little(all, word);
    }
    for (const std::uint64_t size : packed_) append_little(all, size);
    return all + bytes_;
  }

 private:
  // As VTK has it: a window of DEFLATE.
  static constexpr std::size_t kBlock = std::size_t{1} << 15;

  void close() {
    const std::string packed = zlib_compressed(open_);
    packed_.push_back(packed.size());
    bytes_ += packed;
    open_.clear();
  }

  std::string open_;
  std::vector<std::uint64_t> packed_;
  std::string bytes_;
};

std::string packed_bytes(const VtkArray& array) {
  BlockSink sink;
  array.append_bytes(sink);
  return sink.take();
}

// visit(array), in the order of the file.
template <class Visit>
void for_each_array(const VtkFile& file, Visit&& visit) {
  for (const VtkArray& array : file.field_data.arrays) visit(array);
  for (const VtkGroup& group : file.groups) {
    for (const VtkArray& array : group.arrays) visit(array);
  }
}

// All arrays, in order; nothing where the reader would not take what they unpack to.
std::optional<std::vector<std::string>> packed_arrays(const VtkFile& file) {
  std::vector<std::string> packed;
  std::uint64_t size = 0;
  std::uint64_t cost = 0;
  for_each_array(file, [&](const VtkArray& array) {
    packed.push_back(packed_bytes(array));
    size += packed.back().size();
    cost += unpacked_cost(array.bytes, array.value_bytes);
  });
  if (cost > file.most_unpacked * size + kUnpackedBytes) return std::nullopt;
  return packed;
}

// How much of the appended data each array takes, in order.
std::vector<std::uint64_t> plain_lengths(const VtkFile& file) {
  std::vector<std::uint64_t> lengths;
  for_each_array(
      file, [&](const VtkArray& array) { lengths.push_back(sizeof(std::uint64_t) + array.bytes); });
  return lengths;
}

std::uint64_t base64_length(std::uint64_t bytes) { return (bytes + 2) / 3 * 4; }

// meshio 5 turns raw data to base64, array by array, and finds the next one by its offset: an array
// whose new offset is the old one of another is taken for that.
bool has_ambiguous_offsets(const VtkFile& file) {
  std::set<std::uint64_t> moved;
  std::uint64_t offset = 0;
  std::uint64_t moved_offset = 0;
  for (const std::uint64_t length : plain_lengths(file)) {
    if (moved.contains(offset)) return true;
    moved.insert(moved_offset);
    offset += length;
    moved_offset += base64_length(length);
  }
  return false;
}

// The elements of groups, one after the other: arrays as text, or where they are appended.
class HeadWriter {
 public:
  // `lengths`: of the appended arrays, in order.
  HeadWriter(Sink& sink, Encoding encoding, const std::vector<std::uint64_t>& lengths)
      : sink_(sink), encoding_(encoding), lengths_(lengths) {}

  void append(const VtkGroup& group, bool of_whole = false) {
    sink_.append('<' + group.element + ">\n");
    for (const VtkArray& array : group.arrays) {
      if (encoding_ == Encoding::ascii) {
        sink_.append(array_head(array, of_whole) + " format=\"ascii\">\n");
        array.append_text(sink_);
        sink_.append("</DataArray>\n");
      } else {
        sink_.append(array_head(array, of_whole) + " format=\"appended\" offset=\"" +
                     std::to_string(offset_) + "\"/>\n");
        offset_ += lengths_[number_++];
      }
    }
    sink_.append("</" + group.element + ">\n");
  }

 private:
  Sink& sink_;
  Encoding encoding_;
  const std::vector<std::uint64_t>& lengths_;
  std::size_t number_ = 0;  // of the next array
  std::uint64_t offset_ = 0;
};

void append_plain(Sink& sink, const VtkArray& array) {
  if (!sink.ok()) return;
  std::string count;
  append_little(count, static_cast<std::uint64_t>(array.bytes));
  sink.append(count);
  array.append_bytes(sink);
}

void append_base64(Sink& sink, const VtkArray& array) {
  StringSink bytes;
  append_plain(bytes, array);
  sink.append(encode_base64(bytes.take()));
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

std::vector<Warning> append_vtk_file(Sink& sink, const VtkFile& file, Encoding encoding) {
  std::vector<Warning> warnings;
  std::vector<std::string> packed;
  if (encoding == Encoding::compressed) {
    // Where an array begins is told before any of them, and depends on what those before it take.
    if (auto arrays = packed_arrays(file)) {
      packed = *std::move(arrays);
    } else {
      encoding = Encoding::binary;
      warnings.push_back({"written without compression: it would unpack to more than " +
                              std::to_string(file.most_unpacked) +
                              " times its size, which is refused when it is read",
                          {}});
    }
  }
  const bool is_packed = encoding == Encoding::compressed;
  const bool as_base64 = encoding == Encoding::binary && has_ambiguous_offsets(file);
  std::vector<std::uint64_t> lengths = plain_lengths(file);
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    if (is_packed) lengths[k] = packed[k].size();
    if (as_base64) lengths[k] = base64_length(lengths[k]);
  }
  sink.append("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + file.grid_type +
              "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"" +
              (is_packed ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<" + file.grid_type +
              ">\n");
  HeadWriter head(sink, encoding, lengths);
  if (!file.field_data.arrays.empty()) head.append(file.field_data, true);
  sink.append("<Piece " + file.counts + ">\n");
  for (const VtkGroup& group : file.groups) head.append(group);
  sink.append("</Piece>\n</" + file.grid_type + ">\n");
  if (encoding != Encoding::ascii) {
    sink.append(as_base64 ? "<AppendedData encoding=\"base64\">\n_"
                          : "<AppendedData encoding=\"raw\">\n_");
    if (is_packed) {
      for (const std::string& bytes : packed) sink.append(bytes);
    } else {
      const auto append = as_base64 ? append_base64 : append_plain;
      for_each_array(file, [&](const VtkArray& array) { append(sink, array); });
    }
    if (!sink.ok()) return warnings;
    sink.append("\n</AppendedData>\n");
  }
  sink.append("</VTKFile>\n");
  return warnings;
}

}  // namespace tetloft::internal::io
