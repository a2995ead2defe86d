// Decoding DataArray elements (VTK File Formats, "XML File Formats").
#include "io/vtk_data.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "core/little_endian.hpp"
#include "io/base64.hpp"
#include "io/bytes/inflate.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// In the order of ScalarType.
constexpr std::array<std::string_view, 10> kTypes{
    "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Float32", "Float64"};

std::string array_name(const DataArray& array) { return "the array " + in_quotes(array.name); }

// Bytes of an array: where they are, and what owns them if they had to be decoded.
struct Payload {
  std::string owned;
  std::string_view bytes;
};

std::uint64_t load_count(const char* bytes, std::size_t header_bytes) {
  return header_bytes == 8 ? load_little<std::uint64_t>(bytes) : load_little<std::uint32_t>(bytes);
}

Error too_short(const DataArray& array, const XmlScanner& scanner) {
  return scanner.complain(array.position,
                          array_name(array) + " claims more data than the file holds");
}

// The bytes of an array as they stand, from its header on: a view, or decoded as far as wanted.
class EncodedBytes {
 public:
  // Requires that binary data are there.
  EncodedBytes(const DataArray& array, const DataSource& source)
      : base64_(array.format == DataArray::Format::binary || source.appended_base64) {
    text_ = array.text;
    if (array.format == DataArray::Format::appended) {
      text_ = source.appended->substr(std::min(array.offset, source.appended->size()));
    }
  }

  // The first `count` bytes; fewer where the data end. Nothing where they are no base64.
  [[nodiscard]] std::optional<Payload> first(std::size_t count) const {
    if (!base64_) return Payload{{}, text_.substr(0, count)};
    auto bytes = decode_base64(text_, count);
    if (!bytes) return std::nullopt;
    if (bytes->size() > count) bytes->resize(count);
    return Payload{*std::move(bytes), {}};
  }

  // An upper bound of how many bytes there can be.
  [[nodiscard]] std::size_t most() const { return text_.size(); }
  // How much of the text the header and the data behind it take: each is encoded apart where data
  // are packed.
  [[nodiscard]] std::size_t extent(std::size_t header, std::size_t data, bool apart) const {
    const auto encoded = [](std::size_t n) { return (n + 2) / 3 * 4; };
    if (!base64_) return header + data;
    return apart ? encoded(header) + encoded(data) : encoded(header + data);
  }

 private:
  bool base64_;
  std::string_view text_;
};

std::string_view view_of(const Payload& payload) {
  return payload.owned.empty() ? payload.bytes : std::string_view(payload.owned);
}

// What stands before the data: their size; of packed data, the blocks'.
struct BlockHeader {
  std::size_t bytes = 0;   // of the header
  std::size_t packed = 0;  // of the data in the file
  std::uint64_t unpacked = 0;
  std::vector<std::uint64_t> block;  // packed sizes
  std::uint64_t of_block = 0;        // unpacked size of each, but for the last
  std::uint64_t of_last = 0;         // 0: as the others
};

enum class HeaderFault : std::uint8_t { none, not_base64, too_short };

// Sizes are compared with what there is, and no sum overflows.
HeaderFault read_header(const EncodedBytes& encoded, const DataSource& source,
                        BlockHeader& header) {
  const std::size_t word = source.header_bytes;
  const auto words = [&](std::size_t count, std::vector<std::uint64_t>& values) {
    const std::optional<Payload> bytes = encoded.first(count * word);
    if (!bytes) return HeaderFault::not_base64;
    const std::string_view all = view_of(*bytes);
    if (all.size() < count * word) return HeaderFault::too_short;
    for (std::size_t i = 0; i < count; ++i) {
      values.push_back(load_count(all.data() + i * word, word));
    }
    return HeaderFault::none;
  };
  std::vector<std::uint64_t> first;
  if (const HeaderFault fault = words(1, first); fault != HeaderFault::none) return fault;
  const std::size_t most = encoded.most();
  if (!source.packed) {
    header.bytes = word;
    if (first[0] > most) return HeaderFault::too_short;
    header.packed = static_cast<std::size_t>(first[0]);
    header.unpacked = first[0];
    return HeaderFault::none;
  }
  if (first[0] > most / word) return HeaderFault::too_short;
  const auto blocks = static_cast<std::size_t>(first[0]);
  header.bytes = (blocks == 0 ? 1 : 3 + blocks) * word;
  if (blocks == 0) return HeaderFault::none;
  std::vector<std::uint64_t> all;
  if (const HeaderFault fault = words(3 + blocks, all); fault != HeaderFault::none) return fault;
  header.of_block = all[1];
  header.of_last = all[2];
  constexpr std::uint64_t kMostBlock = std::uint64_t{1} << 32;
  if (header.of_block > kMostBlock || header.of_last > kMostBlock) return HeaderFault::too_short;
  header.block.assign(all.begin() + 3, all.end());
  for (const std::uint64_t size : header.block) {
    if (size > most || header.packed + size > most) return HeaderFault::too_short;
    header.packed += static_cast<std::size_t>(size);
  }
  const std::uint64_t last = header.of_last == 0 ? header.of_block : header.of_last;
  header.unpacked = header.of_block * (blocks - 1) + last;
  return HeaderFault::none;
}

Result<Payload> unpack(const DataArray& array, const BlockHeader& header, std::string_view bytes,
                       const XmlScanner& scanner) {
  Payload payload;
  payload.owned.reserve(static_cast<std::size_t>(header.unpacked));
  std::size_t at = 0;
  for (std::size_t i = 0; i < header.block.size(); ++i) {
    const bool shorter = i + 1 == header.block.size() && header.of_last != 0;
    const auto due = static_cast<std::size_t>(shorter ? header.of_last : header.of_block);
    const auto size = static_cast<std::size_t>(header.block[i]);
    const Result<std::string> block =
        inflate(bytes.substr(at, size), Wrapping::zlib, due, scanner.name());
    if (!block || block->size() != due) {
      return scanner.complain(array.position,
                              array_name(array) + ": block " + std::to_string(i) +
                                  " does not unpack to what is announced" +
                                  (block ? "" : " (" + block.error().message + ')'));
    }
    payload.owned += *block;
    at += size;
  }
  return payload;
}

Result<Payload> binary_payload(const DataArray& array, const DataSource& source,
                               const XmlScanner& scanner) {
  if (!source.little_endian) {
    return scanner.complain(array.position,
                            "big-endian data are not supported; write them little-endian or "
                            "as ascii");
  }
  if (source.packed && source.compressor != "vtkZLibDataCompressor") {
    return scanner.complain(array.position, "the data are compressed by " +
                                                in_quotes(source.compressor) +
                                                "; only vtkZLibDataCompressor is read");
  }
  const bool appended = array.format == DataArray::Format::appended;
  if (appended && !source.appended) {
    return scanner.complain(array.position,
                            array_name(array) + " refers to appended data, which are missing");
  }
  const EncodedBytes encoded(array, source);
  BlockHeader header;
  const HeaderFault fault = read_header(encoded, source, header);
  const std::size_t wanted = header.bytes + header.packed;
  std::optional<Payload> bytes;
  if (fault == HeaderFault::none) bytes = encoded.first(wanted);
  if (fault == HeaderFault::not_base64 || (fault == HeaderFault::none && !bytes)) {
    return scanner.complain(array.position, array_name(array) + " is not valid base64");
  }
  if (fault == HeaderFault::too_short || view_of(*bytes).size() < wanted) {
    return too_short(array, scanner);
  }
  if (source.packed) return unpack(array, header, view_of(*bytes).substr(header.bytes), scanner);
  // The header is cut off rather than stepped over: a view into a moved string would dangle.
  if (bytes->owned.empty()) return Payload{{}, bytes->bytes.substr(header.bytes)};
  bytes->owned.erase(0, header.bytes);
  return *std::move(bytes);
}

template <class Stored, class T>
std::vector<T> convert(std::string_view bytes) {
  std::vector<T> values(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<T>(load_little<Stored>(bytes.data() + i * sizeof(Stored)));
  }
  return values;
}

template <class T>
std::vector<T> convert(ScalarType type, std::string_view bytes) {
  return visit_scalar(type, [&](auto stored) -> std::vector<T> {
    // Integers never come here from floats: read_integers refuses them first.
    if constexpr (std::is_floating_point_v<decltype(stored)> && !std::is_floating_point_v<T>) {
      return {};
    } else {
      return convert<decltype(stored), T>(bytes);
    }
  });
}

template <class T>
std::optional<T> parse(std::string_view token) {
  if constexpr (std::is_floating_point_v<T>) {
    const ParsedNumber number = parse_number(token);
    if (!number.ok()) return std::nullopt;
    return number.value;
  } else {
    return parse_integer(token);
  }
}

std::size_t count_tokens(std::string_view text) {
  std::size_t count = 0;
  bool white = true;
  for (const char c : text) {
    if (white && !is_white(c)) ++count;
    white = is_white(c);
  }
  return count;
}

template <class T>
Result<std::vector<T>> parse_text(const DataArray& array, const XmlScanner& scanner) {
  std::vector<T> values;
  values.reserve(count_tokens(array.text));
  TextCursor cursor(array.text);
  for (cursor.skip_white(); !cursor.at_end(); cursor.skip_white()) {
    const std::string_view token = cursor.token();
    const auto value = parse<T>(token);
    if (!value) {
      return scanner.complain(
          array.position, array_name(array) + ": " + in_quotes(token) + " is not a finite number");
    }
    // A Float32 array means the float nearest to its digits.
    if constexpr (std::is_floating_point_v<T>) {
      values.push_back(
          array.type == ScalarType::float32 ? static_cast<T>(static_cast<float>(*value)) : *value);
    } else {
      values.push_back(*value);
    }
  }
  return values;
}

template <class T>
Result<std::vector<T>> read_values(const DataArray& array, const DataSource& source,
                                   const XmlScanner& scanner) {
  if (array.format == DataArray::Format::ascii) return parse_text<T>(array, scanner);
  Result<Payload> payload = binary_payload(array, source, scanner);
  if (!payload) return payload.error();
  const std::string_view bytes = view_of(*payload);
  if (bytes.size() % size_of(array.type) != 0) {
    return scanner.complain(array.position,
                            array_name(array) + " does not hold a whole number of values");
  }
  return convert<T>(array.type, bytes);
}

}  // namespace

std::optional<AppendedExtent> appended_extent(const DataArray& array, const DataSource& source) {
  if (array.format != DataArray::Format::appended || !source.appended) return std::nullopt;
  if (array.offset >= source.appended->size()) return std::nullopt;
  const EncodedBytes encoded(array, source);
  BlockHeader header;
  if (read_header(encoded, source, header) != HeaderFault::none) return std::nullopt;
  if (header.packed == 0) return std::nullopt;
  return AppendedExtent{array.offset,
                        array.offset + encoded.extent(header.bytes, header.packed, source.packed),
                        &array};
}

Result<void> check_unpacking(const std::vector<const DataArray*>& arrays, const DataSource& source,
                             std::size_t multiple, const XmlScanner& scanner) {
  if (!source.packed) return {};
  std::size_t left = multiple * scanner.size() + kUnpackedBytes;
  for (const DataArray* array : arrays) {
    const bool inside = array->format == DataArray::Format::binary;
    if (!inside && (array->format == DataArray::Format::ascii || !source.appended)) continue;
    BlockHeader header;
    // What is wrong is told by who reads it.
    if (read_header(EncodedBytes(*array, source), source, header) != HeaderFault::none) continue;
    // Above the limit the cost, nine times this at most, is not asked for: it might overflow.
    const std::uint64_t cost =
        header.unpacked > left ? 0 : unpacked_cost(header.unpacked, size_of(array->type));
    if (header.unpacked > left || cost > left) {
      return scanner.complain(array->position, array_name(*array) +
                                                   ": the file unpacks to more than " +
                                                   std::to_string(multiple) +
                                                   " times its size; write it without compression");
    }
    left -= static_cast<std::size_t>(cost);
  }
  return {};
}

Result<DataSource> declare_source(const XmlTag& tag, std::string_view grid_type,
                                  const XmlScanner& scanner) {
  DataSource source;
  const std::string* const type = tag.find("type");
  if (type == nullptr || *type != grid_type) {
    return scanner.complain(tag.position, "this VTK file is no " + std::string(grid_type) +
                                              (type == nullptr ? "" : " but " + in_quotes(*type)));
  }
  const std::string* const order = tag.find("byte_order");
  source.little_endian = order == nullptr || *order == "LittleEndian";
  const std::string* const header = tag.find("header_type");
  if (header != nullptr && *header != "UInt32" && *header != "UInt64") {
    return scanner.complain(tag.position, "unknown header_type " + in_quotes(*header));
  }
  source.header_bytes = header != nullptr && *header == "UInt64" ? 8 : 4;
  if (const std::string* compressor = tag.find("compressor")) source.compressor = *compressor;
  source.packed = !source.compressor.empty();
  return source;
}

Result<void> take_appended_data(const XmlTag& tag, XmlScanner& scanner, DataSource& source) {
  if (source.appended) {
    return scanner.complain(tag.position, "the file has two elements 'AppendedData'");
  }
  const std::string* const encoding = tag.find("encoding");
  if (encoding == nullptr || (*encoding != "raw" && *encoding != "base64")) {
    return scanner.complain(tag.position, "the appended data have no known encoding");
  }
  source.appended_base64 = *encoding == "base64";
  source.appended = std::string_view();
  if (tag.kind != XmlTag::Kind::open) return {};
  std::string_view rest = scanner.rest();
  const std::size_t end = rest.rfind("</AppendedData");
  if (end == std::string_view::npos) {
    return scanner.complain(tag.position,
                            "the appended data do not end: the end of the file is missing");
  }
  scanner.pass_over(end);
  rest = rest.substr(0, end);
  while (!rest.empty() && is_white(rest.front())) rest.remove_prefix(1);
  if (rest.empty() || rest.front() != '_') {
    return scanner.complain(tag.position, "the appended data do not begin with '_'");
  }
  source.appended = rest.substr(1);
  return {};
}

Result<DataArray> declare_array(const XmlTag& tag, std::string_view name,
                                const XmlScanner& scanner) {
  DataArray array;
  array.position = tag.position;
  array.name = name;
  const std::string* const type = tag.find("type");
  const auto known =
      type == nullptr ? kTypes.end() : std::find(kTypes.begin(), kTypes.end(), *type);
  if (known == kTypes.end()) {
    return scanner.complain(array.position, array_name(array) + " has no numeric type");
  }
  array.type = static_cast<ScalarType>(known - kTypes.begin());
  const auto read_size = [&](std::string_view key, std::size_t& size) {
    const std::string* const text = tag.find(key);
    if (text == nullptr) return true;
    const auto value = parse_integer(*text);
    if (!value || *value < 0) return false;
    size = static_cast<std::size_t>(*value);
    return true;
  };
  std::size_t tuples = 0;
  const bool sizes = read_size("NumberOfComponents", array.components) &&
                     read_size("NumberOfTuples", tuples) && read_size("offset", array.offset);
  if (tag.find("NumberOfTuples") != nullptr) array.tuples = tuples;
  const std::string* const format = tag.find("format");
  if (format == nullptr || *format == "ascii") {
    array.format = DataArray::Format::ascii;
  } else if (*format == "binary") {
    array.format = DataArray::Format::binary;
  } else if (*format == "appended" && tag.find("offset") != nullptr) {
    array.format = DataArray::Format::appended;
  } else {
    return scanner.complain(array.position, array_name(array) + " has no known format");
  }
  if (!sizes) {
    return scanner.complain(array.position, array_name(array) + " has a malformed size");
  }
  return array;
}

Result<std::vector<double>> read_doubles(const DataArray& array, const DataSource& source,
                                         const XmlScanner& scanner) {
  return read_values<double>(array, source, scanner);
}

Result<std::vector<std::int64_t>> read_integers(const DataArray& array, const DataSource& source,
                                                const XmlScanner& scanner) {
  if (is_float(array.type)) {
    return scanner.complain(array.position, array_name(array) + " must hold integers");
  }
  return read_values<std::int64_t>(array, source, scanner);
}

}  // namespace tetloft::internal::io
