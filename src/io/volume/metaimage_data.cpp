// Where the data of a MetaImage are: behind the header, or in files that it names.
#include <array>
#include <cstdlib>

#include "core/text.hpp"
#include "io/numbers.hpp"
#include "io/volume/data_files.hpp"
#include "io/volume/header_text.hpp"
#include "io/volume/metaimage_header.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kMostDataFiles = std::size_t{1} << 16;

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

// Some writers put gzip where zlib is meant.
Result<void> tell_gzip(VoxelData& data) {
  if (data.encoding != DataEncoding::zlib) return {};
  const Result<OpenPart> file = open_part(data, data.parts.front());
  if (!file) return file.error();
  std::array<char, 2> mark{};
  const Result<std::size_t> got = file->bytes->read_at(data.parts.front().offset, mark);
  if (!got) return got.error();
  if (mark[0] == '\x1F' && mark[1] == '\x8B') data.encoding = DataEncoding::gzip;
  return {};
}

}  // namespace

Result<void> find_meta_data(const MetaHeader& meta, const Source& source,
                            const VolumeHeader& header, VoxelData& data) {
  const MetaHeader::Field& field = *meta.find({"elementdatafile"});
  const std::uint64_t all = std::uint64_t{header.voxels()} * header.layers;
  if (lower_case(field.value) == "local") {
    DataPart part;
    part.offset = meta.data;
    part.samples = all;
    data.parts.push_back(part);
    if (Result<void> told = tell_gzip(data); !told) return told;
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
  if (Result<void> told = tell_gzip(data); !told) return told;
  return check_parts(data);
}

}  // namespace tetloft::internal::io
