// NRRD: versions 1 to 5, attached and detached, with the segments that 3D Slicer names in it
// (.seg.nrrd). World coordinates are those of the file's own space.
#include <algorithm>
#include <array>
#include <map>

#include "core/text.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/volume/file_volume.hpp"
#include "io/volume/header_text.hpp"
#include "io/volume/nrrd_axes.hpp"
#include "io/volume/nrrd_data.hpp"
#include "io/volume/nrrd_header.hpp"

namespace tetloft::internal::io {

namespace {

bool recognise_nrrd(std::string_view bytes) {
  return bytes.substr(0, kNrrdMagic.size()) == kNrrdMagic;
}

Result<ScalarType> type_of(const NrrdHeader& nrrd) {
  const NrrdField* const field = nrrd.find("type");
  if (field == nullptr) return nrrd.complain("type", "the header has no type");
  struct Named {
    ScalarType type;
    std::array<const char*, 7> names;
  };
  constexpr std::array<Named, 10> kTypes{{
      {ScalarType::int8, {"signed char", "int8", "int8_t"}},
      {ScalarType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {ScalarType::int16,
       {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {ScalarType::uint16,
       {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {ScalarType::int32, {"int", "signed int", "int32", "int32_t"}},
      {ScalarType::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {ScalarType::int64,
       {"longlong", "long long", "long long int", "signed long long", "signed long long int",
        "int64", "int64_t"}},
      {ScalarType::uint64,
       {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {ScalarType::float32, {"float"}},
      {ScalarType::float64, {"double"}},
  }};
  const std::string wanted = lower_case(trimmed(field->value));
  for (const Named& named : kTypes) {
    for (const char* name : named.names) {
      if (name != nullptr && wanted == name) return named.type;
    }
  }
  return nrrd.complain("type", "voxels of type " + in_quotes(field->value) + " are not read");
}

Result<SampleFormat> sample_format(const NrrdHeader& nrrd, VolumeHeader& header) {
  const Result<ScalarType> type = type_of(nrrd);
  if (!type) return type.error();
  SampleFormat format{*type};
  const NrrdField* const endian = nrrd.find("endian");
  if (endian != nullptr) {
    const std::string order = lower_case(trimmed(endian->value));
    format.big_endian = order == "big";
    if (!format.big_endian && order != "little") {
      return nrrd.complain("endian",
                           "the byte order is little or big, not " + in_quotes(endian->value));
    }
    return format;
  }
  const NrrdField* const encoding = nrrd.find("encoding");
  const std::string packed = encoding == nullptr ? "" : lower_case(trimmed(encoding->value));
  const bool is_text = packed == "ascii" || packed == "text" || packed == "txt";
  if (size_of(*type) > 1 && !is_text) {
    Warning warning{"the header does not say the byte order of its data: little endian is taken",
                    {}};
    warning.where.file = nrrd.name;
    header.warnings.push_back(std::move(warning));
  }
  return format;
}

// "Segment12_Name": 12 and "Name"; nothing for other keys.
std::optional<std::pair<std::int64_t, std::string>> segment_key(const std::string& key) {
  constexpr std::string_view kBegin = "Segment";
  const std::size_t end = key.find('_');
  if (key.substr(0, kBegin.size()) != kBegin || end == std::string::npos) return std::nullopt;
  const auto number =
      parse_integer(std::string_view(key).substr(kBegin.size(), end - kBegin.size()));
  if (!number || *number < 0) return std::nullopt;
  return std::pair(*number, key.substr(end + 1));
}

// Files from before layers were shared have a layer for each segment, of zeros and ones.
Result<void> set_segments(const NrrdHeader& nrrd, VolumeHeader& header) {
  std::map<std::int64_t, VolumeSegment> segments;
  std::map<std::int64_t, std::string> ids;
  for (const auto& [key, value] : nrrd.keys) {
    const auto of = segment_key(key);
    if (!of) continue;
    const std::size_t layer =
        header.layers > 1 ? static_cast<std::size_t>(of->first) : std::size_t{0};
    const double label = header.layers > 1 ? 1 : static_cast<double>(of->first + 1);
    VolumeSegment& segment =
        segments.try_emplace(of->first, VolumeSegment{label, {}, layer}).first->second;
    if (of->second == "Name") segment.name = value;
    if (of->second == "ID") ids[of->first] = value;
    if (of->second != "LabelValue" && of->second != "Layer") continue;
    const auto number = parse_integer(trimmed(value));
    if (!number || (of->second == "Layer" && *number < 0)) {
      return nrrd.complain({}, "the key " + in_quotes(key) + " has no number: " + in_quotes(value));
    }
    if (of->second == "Layer") segment.layer = static_cast<std::size_t>(*number);
    if (of->second == "LabelValue") segment.value = static_cast<double>(*number);
  }
  for (auto& [number, segment] : segments) {
    if (segment.name.empty()) segment.name = ids[number];
    if (segment.layer >= header.layers) {
      return nrrd.complain({}, "the segment " + in_quotes(segment.name) + " is in layer " +
                                   std::to_string(segment.layer) + ", of " +
                                   std::to_string(header.layers));
    }
    header.segments.push_back(std::move(segment));
  }
  return {};
}

Result<std::unique_ptr<Volume>> open_nrrd(const Source& source, const ReadOptions& /*options*/) {
  const Result<NrrdHeader> nrrd = read_nrrd_header(*source.whole, source.name);
  if (!nrrd) return nrrd.error();
  VolumeHeader header;
  VoxelData data;
  data.source = source.whole;
  data.name = source.name;
  const Result<SampleFormat> format = sample_format(*nrrd, header);
  if (!format) return format.error();
  data.format = *format;
  header.type = name_of(format->type);
  const Result<std::uint64_t> block = set_nrrd_axes(*nrrd, header);
  if (!block) return block.error();
  if (Result<void> set = set_segments(*nrrd, header); !set) return set.error();
  if (Result<void> found = find_nrrd_data(*nrrd, source, header, data); !found) {
    return found.error();
  }
  return std::unique_ptr<Volume>(
      std::make_unique<FileVolume>(std::move(header), std::move(data), *block));
}

}  // namespace

extern constinit const Format nrrd_format{
    .name = "nrrd",
    .summary = "label volumes, segmentations and images",
    .extensions = {".nrrd", ".seg.nrrd", ".nhdr"},
    .recognise = recognise_nrrd,
    .open_volume = open_nrrd,
};

}  // namespace tetloft::internal::io
