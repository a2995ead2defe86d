// MetaImage: .mha, and .mhd with its data in files beside it. World coordinates are LPS, the one
// that ITK reads and writes.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/volume/file_volume.hpp"
#include "io/volume/header_text.hpp"
#include "io/volume/metaimage_header.hpp"
#include "io/volume/placement.hpp"

namespace tetloft::internal::io {

namespace {

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

Result<ScalarType> element_type(const MetaHeader& meta) {
  const MetaHeader::Field* const field = meta.find({"elementtype"});
  if (field == nullptr) return meta.complain(field, "the header has no ElementType");
  struct Named {
    const char* name;
    ScalarType type;
  };
  // MET_LONG has four bytes in files, on every system.
  constexpr std::array<Named, 12> kTypes{{{"met_char", ScalarType::int8},
                                          {"met_uchar", ScalarType::uint8},
                                          {"met_short", ScalarType::int16},
                                          {"met_ushort", ScalarType::uint16},
                                          {"met_int", ScalarType::int32},
                                          {"met_uint", ScalarType::uint32},
                                          {"met_long", ScalarType::int32},
                                          {"met_ulong", ScalarType::uint32},
                                          {"met_long_long", ScalarType::int64},
                                          {"met_ulong_long", ScalarType::uint64},
                                          {"met_float", ScalarType::float32},
                                          {"met_double", ScalarType::float64}}};
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

// x = offset + R S i, each triple of R the direction of an index axis, S the spacings. The centre
// of rotation is passed over, as ITK does: the offset is where the first voxel is.
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

Result<std::unique_ptr<Volume>> open_metaimage(const Source& source,
                                               const ReadOptions& /*options*/) {
  const Result<MetaHeader> meta = read_meta_header(*source.whole, source.name);
  if (!meta) return meta.error();
  const Result<ScalarType> type = element_type(*meta);
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
