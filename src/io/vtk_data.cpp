// Decoding DataArray elements (VTK File Formats, "XML File Formats").
#include "io/vtk_data.hpp"

#include <array>
#include <type_traits>
#include <utility>

#include "core/little_endian.hpp"
#include "io/base64.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

struct TypeRow {
  std::string_view name;
  ScalarType type;
  std::size_t bytes;
};
constexpr std::array<TypeRow, 10> kTypes{{{"Int8", ScalarType::int8, 1},
                                          {"UInt8", ScalarType::uint8, 1},
                                          {"Int16", ScalarType::int16, 2},
                                          {"UInt16", ScalarType::uint16, 2},
                                          {"Int32", ScalarType::int32, 4},
                                          {"UInt32", ScalarType::uint32, 4},
                                          {"Int64", ScalarType::int64, 8},
                                          {"UInt64", ScalarType::uint64, 8},
                                          {"Float32", ScalarType::float32, 4},
                                          {"Float64", ScalarType::float64, 8}}};

std::size_t bytes_of(ScalarType type) { return kTypes[static_cast<std::size_t>(type)].bytes; }

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

Result<Payload> raw_payload(const DataArray& array, const DataSource& source,
                            const XmlScanner& scanner) {
  const std::string_view all = *source.appended;
  if (array.offset > all.size() || all.size() - array.offset < source.header_bytes) {
    return too_short(array, scanner);
  }
  const std::string_view from = all.substr(array.offset);
  const std::uint64_t count = load_count(from.data(), source.header_bytes);
  if (count > from.size() - source.header_bytes) return too_short(array, scanner);
  return Payload{{}, from.substr(source.header_bytes, static_cast<std::size_t>(count))};
}

Result<Payload> base64_payload(const DataArray& array, std::string_view text,
                               const DataSource& source, const XmlScanner& scanner) {
  const auto foreign = [&] {
    return scanner.complain(array.position, array_name(array) + " is not valid base64");
  };
  const auto header = decode_base64(text, source.header_bytes);
  if (!header) return foreign();
  if (header->size() < source.header_bytes) return too_short(array, scanner);
  const std::uint64_t count = load_count(header->data(), source.header_bytes);
  if (count > text.size()) return too_short(array, scanner);
  const std::size_t wanted = source.header_bytes + static_cast<std::size_t>(count);
  auto bytes = decode_base64(text, wanted);
  if (!bytes) return foreign();
  if (bytes->size() < wanted) return too_short(array, scanner);
  // The header is cut off rather than stepped over: a view into a moved string would dangle.
  bytes->resize(wanted);
  bytes->erase(0, source.header_bytes);
  return Payload{*std::move(bytes), {}};
}

Result<Payload> binary_payload(const DataArray& array, const DataSource& source,
                               const XmlScanner& scanner) {
  if (!source.compressor.empty()) {
    return scanner.complain(array.position, "the data are compressed (" +
                                                in_quotes(source.compressor) +
                                                "); write the file without compression");
  }
  if (!source.little_endian) {
    return scanner.complain(array.position,
                            "big-endian data are not supported; write them little-endian or "
                            "as ascii");
  }
  if (array.format == DataArray::Format::binary) {
    return base64_payload(array, array.text, source, scanner);
  }
  if (!source.appended) {
    return scanner.complain(array.position,
                            array_name(array) + " refers to appended data, which are missing");
  }
  if (!source.appended_base64) return raw_payload(array, source, scanner);
  if (array.offset > source.appended->size()) return too_short(array, scanner);
  return base64_payload(array, source.appended->substr(array.offset), source, scanner);
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
  switch (type) {
    case ScalarType::int8: return convert<std::int8_t, T>(bytes);
    case ScalarType::uint8: return convert<std::uint8_t, T>(bytes);
    case ScalarType::int16: return convert<std::int16_t, T>(bytes);
    case ScalarType::uint16: return convert<std::uint16_t, T>(bytes);
    case ScalarType::int32: return convert<std::int32_t, T>(bytes);
    case ScalarType::uint32: return convert<std::uint32_t, T>(bytes);
    case ScalarType::int64: return convert<std::int64_t, T>(bytes);
    case ScalarType::uint64: return convert<std::uint64_t, T>(bytes);
    case ScalarType::float32: break;
    case ScalarType::float64: break;
  }
  // Integers never come here from floats: read_integers refuses them first.
  if constexpr (std::is_floating_point_v<T>) {
    return type == ScalarType::float32 ? convert<float, T>(bytes) : convert<double, T>(bytes);
  } else {
    return {};
  }
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
  const std::string_view bytes = payload->owned.empty() ? payload->bytes : payload->owned;
  if (bytes.size() % bytes_of(array.type) != 0) {
    return scanner.complain(array.position,
                            array_name(array) + " does not hold a whole number of values");
  }
  return convert<T>(array.type, bytes);
}

}  // namespace

std::optional<AppendedExtent> appended_extent(const DataArray& array, const DataSource& source) {
  if (array.format != DataArray::Format::appended || !source.appended) return std::nullopt;
  const std::string_view all = *source.appended;
  if (array.offset >= all.size()) return std::nullopt;
  const std::string_view from = all.substr(array.offset);
  std::string header(from.substr(0, source.header_bytes));
  if (source.appended_base64) header = decode_base64(from, source.header_bytes).value_or("");
  if (header.size() < source.header_bytes) return std::nullopt;
  const std::uint64_t count = load_count(header.data(), source.header_bytes);
  if (count == 0 || count > from.size()) return std::nullopt;
  std::size_t bytes = source.header_bytes + static_cast<std::size_t>(count);
  if (source.appended_base64) bytes = (bytes + 2) / 3 * 4;
  return AppendedExtent{array.offset, array.offset + bytes, &array};
}

Result<DataArray> declare_array(const XmlTag& tag, std::string_view name,
                                const XmlScanner& scanner) {
  DataArray array;
  array.position = tag.position;
  array.name = name;
  const std::string* const type = tag.find("type");
  bool known = false;
  for (const TypeRow& row : kTypes) {
    if (type == nullptr || *type != row.name) continue;
    array.type = row.type;
    known = true;
  }
  if (!known) {
    return scanner.complain(array.position, array_name(array) + " has no numeric type");
  }
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
