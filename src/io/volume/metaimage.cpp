// MetaImage: .mha, and .mhd with its data in files beside it. World coordinates are LPS, the one
// that ITK reads and writes.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/volume/data_files.hpp"
#include "io/volume/file_volume.hpp"
#include "io/volume/header_text.hpp"
#include "io/volume/placement.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kMostDataFiles = std::size_t{1} << 16;

/// "Key = value" lines, up to that of the data.
struct MetaHeader {
  struct Field {
    std::string value;
    std::size_t line = 0;
  };
  std::string name;
  std::map<std::string, Field> fields;  ///< by key in lower case
  std::vector<std::string> listed;      ///< lines behind "ElementDataFile = LIST"
  std::uint64_t data = 0;               ///< behind the line "ElementDataFile = LOCAL"

  /// Of the first of these keys that there is; null if none is.
  [[nodiscard]] const Field* find(std::initializer_list<const char*> keys) const {
    for (const char* key : keys) {
      if (const auto at = fields.find(key); at != fields.end()) return &at->second;
    }
    return nullptr;
  }
  [[nodiscard]] bool is_true(std::initializer_list<const char*> keys, bool otherwise) const {
    const Field* const field = find(keys);
    if (field == nullptr || field->value.empty()) return otherwise;
    const char c = field->value.front();
    return c == 'T' || c == 't' || c == '1' || c == 'Y' || c == 'y';
  }
  [[nodiscard]] Error complain(const Field* field, const std::string& message) const {
    return volume_error(name, message,
                        field == nullptr ? std::nullopt : std::optional<std::size_t>(field->line));
  }
  /// All numbers of a field, `count` of them; empty where there is no such field.
  [[nodiscard]] Result<std::vector<double>> numbers(std::initializer_list<const char*> keys,
                                                    std::size_t count) const {
    std::vector<double> numbers;
    const Field* const field = find(keys);
    if (field == nullptr) return numbers;
    for (const std::string& word : words_of(field->value)) {
      const ParsedNumber number = parse_number(word);
      if (!number.ok()) return complain(field, complaint(word, number.status));
      numbers.push_back(number.value);
    }
    if (numbers.size() >= count) return numbers;
    return complain(field, std::string(*keys.begin()) + " has " + std::to_string(numbers.size()) +
                               " numbers, and should have " + std::to_string(count));
  }
};

// The first line that says anything is one of these.
bool recognise_metaimage(std::string_view bytes) {
  const std::string_view text = trimmed(bytes.substr(0, 256));
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return false;
  const std::string key = lower_case(trimmed(text.substr(0, equals)));
  if (key == "objecttype") {
    return lower_case(trimmed(text.substr(equals + 1, 16))).substr(0, 5) == "image";
  }
  return key == "ndims";
}

Result<MetaHeader> read_meta_header(const ByteSource& file, const std::string& name) {
  MetaHeader header;
  header.name = name;
  HeaderLines lines(file, name);
  bool in_list = false;
  for (;;) {
    const Result<bool> next = lines.next();
    if (!next) return next.error();
    if (!*next) break;
    const std::string_view line = trimmed(lines.text());
    if (line.empty() || line.front() == '#') continue;
    if (in_list) {
      header.listed.emplace_back(line);
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      return volume_error(name, in_quotes(line) + " is no line \"key = value\"", lines.number());
    }
    const std::string key = lower_case(trimmed(line.substr(0, equals)));
    const std::string_view value = trimmed(line.substr(equals + 1));
    header.fields[key] = {std::string(value), lines.number()};
    if (key != "elementdatafile") continue;
    header.data = lines.position();
    in_list = value == "LIST" || value.substr(0, 5) == "LIST ";
    if (!in_list) return header;
  }
  if (in_list) return header;
  return volume_error(name, "the header has no ElementDataFile");
}

Result<SampleType> element_type(const MetaHeader& meta) {
  const MetaHeader::Field* const field = meta.find({"elementtype"});
  if (field == nullptr) return meta.complain(field, "the header has no ElementType");
  struct Named {
    const char* name;
    SampleType type;
  };
  // MET_LONG has four bytes in files, on every system.
  constexpr std::array<Named, 12> kTypes{{{"met_char", SampleType::int8},
                                          {"met_uchar", SampleType::uint8},
                                          {"met_short", SampleType::int16},
                                          {"met_ushort", SampleType::uint16},
                                          {"met_int", SampleType::int32},
                                          {"met_uint", SampleType::uint32},
                                          {"met_long", SampleType::int32},
                                          {"met_ulong", SampleType::uint32},
                                          {"met_long_long", SampleType::int64},
                                          {"met_ulong_long", SampleType::uint64},
                                          {"met_float", SampleType::float32},
                                          {"met_double", SampleType::float64}}};
  const std::string wanted = lower_case(field->value);
  for (const Named& known : kTypes) {
    if (wanted == known.name) return known.type;
  }
  return meta.complain(field, "voxels of type " + in_quotes(field->value) + " are not read");
}

// Channels of a voxel are volumes, as are dimensions behind the third.
Result<std::size_t> set_meta_sizes(const MetaHeader& meta, VolumeHeader& header) {
  const MetaHeader::Field* const field = meta.find({"dimsize"});
  if (field == nullptr) return meta.complain(field, "the header has no DimSize");
  std::vector<std::uint64_t> sizes;
  for (const std::string& word : words_of(field->value)) {
    const auto size = parse_integer(word);
    if (!size || *size < 1) return meta.complain(field, in_quotes(word) + " is no size of an axis");
    sizes.push_back(static_cast<std::uint64_t>(*size));
  }
  const MetaHeader::Field* const dims = meta.find({"ndims"});
  const auto dimensions = parse_integer(dims == nullptr ? std::string_view() : dims->value);
  if (!dimensions || *dimensions < 1 || *dimensions > 10) {
    return meta.complain(dims, "the header has no NDims from 1 to 10");
  }
  if (sizes.size() != static_cast<std::size_t>(*dimensions)) {
    return meta.complain(field, "DimSize has " + std::to_string(sizes.size()) +
                                    " sizes, and NDims is " + std::to_string(*dimensions));
  }
  std::uint64_t channels = 1;
  if (const MetaHeader::Field* const count = meta.find({"elementnumberofchannels"})) {
    const auto number = parse_integer(count->value);
    if (!number || *number < 1 || *number > 65535) {
      return meta.complain(count, in_quotes(count->value) + " is no number of channels");
    }
    channels = static_cast<std::uint64_t>(*number);
  }
  header.sizes.assign(sizes.begin(), sizes.end());
  std::vector<std::uint64_t> all = sizes;
  all.push_back(channels);
  if (!product_up_to(all, kMostSamples)) {
    return meta.complain(field, "DimSize announces too many voxels");
  }
  header.size = {1, 1, 1};
  header.layers = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto size = static_cast<std::size_t>(sizes[i]);
    if (i < 3) header.size[i] = size;
    if (i >= 3) header.layers *= size;
  }
  if (channels > 1 && header.layers > channels) {
    return meta.complain(field, "voxels of several channels and four dimensions are not read");
  }
  return static_cast<std::size_t>(channels);
}

// x = offset + R S (i − c) + c, R of the direction of an index axis in each triple, S the spacings,
// c the centre of rotation; it is 0 in all files but old ones, whose c is passed over as ITK does.
Result<void> set_meta_space(const MetaHeader& meta, VolumeHeader& header) {
  const std::size_t n = header.sizes.size();
  const std::size_t spatial = std::min<std::size_t>(n, 3);
  const auto spacing = meta.numbers({"elementspacing", "elementsize"}, spatial);
  const auto origin = meta.numbers({"offset", "position", "origin"}, spatial);
  const auto rotation = meta.numbers({"transformmatrix", "rotation", "orientation"}, n * n);
  for (const auto* read : {&spacing, &origin, &rotation}) {
    if (!*read) return read->error();
  }
  header.space = "LPS";
  header.matrix[3][3] = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double step = axis < spacing->size() && axis < n ? (*spacing)[axis] : 1;
    header.spacing[axis] = std::abs(step);
    for (std::size_t row = 0; row < 3; ++row) {
      const bool given = !rotation->empty() && axis < n && row < n;
      const double direction = given ? (*rotation)[axis * n + row] : axis == row ? 1.0 : 0.0;
      header.matrix[row][axis] = direction == 0 ? 0 : direction * step;
    }
    if (axis < origin->size() && axis < n) header.matrix[axis][3] = (*origin)[axis];
  }
  const auto units = meta.find({"distanceunits"});
  if (units != nullptr && units->value != "?") header.unit = units->value;
  return check_matrix(header, "TransformMatrix, ElementSpacing or Offset", meta.name);
}

// Names of the files of data, in order, and how many dimensions each has.
struct MetaNames {
  std::vector<std::string> names;
  std::size_t dimension = 0;
};

Result<std::size_t> files_dimension(const MetaHeader& meta, const std::string& word) {
  const auto number = parse_integer(word);
  if (number && *number >= 1 && *number <= 10) return static_cast<std::size_t>(*number);
  return meta.complain(meta.find({"elementdatafile"}),
                       in_quotes(word) + " is no dimension of a file");
}

// "PATTERN MIN MAX STEP"; no names where it is none such.
Result<MetaNames> numbered_slices(const MetaHeader& meta, const VolumeHeader& header) {
  const MetaHeader::Field& field = *meta.find({"elementdatafile"});
  const std::vector<std::string> words = words_of(field.value);
  MetaNames data{{}, header.sizes.size() - 1};
  if (words.size() < 2 || !is_pattern(words[0])) return data;
  std::array<std::int64_t, 3> range{1, 1, 1};
  range[1] = static_cast<std::int64_t>(header.sizes.back());
  for (std::size_t i = 1; i < words.size() && i < 4; ++i) {
    const auto number = parse_integer(words[i]);
    if (!number || std::abs(*number) > 1'000'000'000) return MetaNames{};
    range[i - 1] = *number;
  }
  const auto [from, to, step] = range;
  if (step == 0 || (to - from) / step < 0 ||
      static_cast<std::size_t>((to - from) / step) >= kMostDataFiles) {
    return meta.complain(&field, "the numbers of files do not go from the first to the last");
  }
  for (std::int64_t i = from; step > 0 ? i <= to : i >= to; i += step) {
    data.names.push_back(numbered(words[0], i));
  }
  return data;
}

Result<MetaNames> data_names(const MetaHeader& meta, const VolumeHeader& header) {
  const MetaHeader::Field& field = *meta.find({"elementdatafile"});
  const std::vector<std::string> words = words_of(field.value);
  if (!words.empty() && words[0] == "LIST") {
    MetaNames data{meta.listed, header.sizes.size() - 1};
    if (words.size() == 1) return data;
    const Result<std::size_t> dimension = files_dimension(meta, words[1]);
    if (!dimension) return dimension.error();
    data.dimension = *dimension;
    return data;
  }
  Result<MetaNames> data = numbered_slices(meta, header);
  if (data && data->names.empty()) *data = {{field.value}, header.sizes.size()};
  return data;
}

// −1: the data are the last bytes of the file.
Result<void> skip_header(const MetaHeader& meta, const VoxelData& data, DataPart& part) {
  const MetaHeader::Field* const field = meta.find({"headersize"});
  if (field == nullptr) return {};
  const auto bytes = parse_integer(field->value);
  if (!bytes || *bytes < -1 || *bytes >= std::int64_t{1} << 48) {
    return meta.complain(field, "HeaderSize is neither -1 nor a number of bytes");
  }
  if (*bytes >= 0) {
    part.offset += static_cast<std::uint64_t>(*bytes);
    return {};
  }
  if (data.encoding != DataEncoding::raw) {
    return meta.complain(field, "HeaderSize is -1 of data that are not raw");
  }
  const Result<OpenPart> file = open_part(data, part);
  if (!file) return file.error();
  const std::uint64_t wanted = part.samples * size_of(data.format.type);
  const std::uint64_t size = file->bytes->size();
  if (size >= part.offset && size - part.offset >= wanted) part.offset = size - wanted;
  return {};
}

Result<void> find_meta_data(const MetaHeader& meta, const Source& source,
                            const VolumeHeader& header, VoxelData& data) {
  const MetaHeader::Field& field = *meta.find({"elementdatafile"});
  const std::uint64_t all = std::uint64_t{header.voxels()} * header.layers;
  if (lower_case(field.value) == "local") {
    DataPart part;
    part.offset = meta.data;
    part.samples = all;
    data.parts.push_back(part);
    return check_parts(data);
  }
  const Result<MetaNames> names = data_names(meta, header);
  if (!names) return names.error();
  const std::size_t files = names->names.size();
  if (files == 0 || files > kMostDataFiles || all % files != 0) {
    return meta.complain(&field, std::to_string(files) + " files are named, between which " +
                                     std::to_string(all) + " samples cannot be divided");
  }
  std::uint64_t expected = 1;
  for (std::size_t i = names->dimension; i < header.sizes.size(); ++i) expected *= header.sizes[i];
  if (files != expected) {
    return meta.complain(&field, std::to_string(files) +
                                     " files are named, where DimSize asks for " +
                                     std::to_string(expected));
  }
  for (const std::string& name : names->names) {
    Result<std::string> path = data_file(source.folder, source.name, name);
    if (!path) return path.error();
    DataPart part;
    part.path = *std::move(path);
    part.samples = all / files;
    if (Result<void> skipped = skip_header(meta, data, part); !skipped) return skipped;
    data.parts.push_back(std::move(part));
  }
  return check_parts(data);
}

Result<std::unique_ptr<Volume>> open_metaimage(const Source& source,
                                               const ReadOptions& /*options*/) {
  const Result<MetaHeader> meta = read_meta_header(*source.whole, source.name);
  if (!meta) return meta.error();
  const Result<SampleType> type = element_type(*meta);
  if (!type) return type.error();
  VolumeHeader header;
  header.type = name_of(*type);
  const Result<std::size_t> channels = set_meta_sizes(*meta, header);
  if (!channels) return channels.error();
  if (Result<void> set = set_meta_space(*meta, header); !set) return set.error();
  VoxelData data;
  data.source = source.whole;
  data.name = source.name;
  data.format = {*type, meta->is_true({"binarydatabyteordermsb", "elementbyteordermsb"}, false)};
  if (!meta->is_true({"binarydata"}, true)) {
    data.encoding = DataEncoding::text;
  } else if (meta->is_true({"compresseddata"}, false)) {
    data.encoding = DataEncoding::zlib;
  }
  if (Result<void> found = find_meta_data(*meta, source, header, data); !found) {
    return found.error();
  }
  const std::uint64_t block = *channels > 1 ? 1 : header.voxels();
  return std::unique_ptr<Volume>(
      std::make_unique<FileVolume>(std::move(header), std::move(data), block));
}

}  // namespace

extern constinit const Format metaimage_format{
    .name = "metaimage",
    .summary = "label volumes and images",
    .extensions = {".mha", ".mhd"},
    .recognise = recognise_metaimage,
    .open_volume = open_metaimage,
};

}  // namespace tetloft::internal::io
