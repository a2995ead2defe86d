// "data file", "line skip", "byte skip".
#include "io/volume/nrrd_data.hpp"

#include <array>

#include "core/text.hpp"
#include "io/numbers.hpp"
#include "io/volume/data_files.hpp"
#include "io/volume/header_text.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kMostFiles = std::size_t{1} << 16;

Result<DataEncoding> encoding_of(const NrrdHeader& nrrd) {
  const NrrdField* const field = nrrd.find("encoding");
  if (field == nullptr) return nrrd.complain("encoding", "the header has no encoding");
  const std::string name = lower_case(trimmed(field->value));
  if (name == "raw") return DataEncoding::raw;
  if (name == "ascii" || name == "text" || name == "txt") return DataEncoding::text;
  if (name == "hex") return DataEncoding::hex;
  if (name == "gzip" || name == "gz") return DataEncoding::gzip;
  if (name == "bzip2" || name == "bz2") {
    return nrrd.complain(
        "encoding",
        "data in bzip2 are not read: save them in gzip, as by \"unu save -f nrrd -e "
        "gzip -i FILE -o NEW\"");
  }
  return nrrd.complain("encoding", "the encoding " + in_quotes(field->value) +
                                       " is not read; raw, ascii, hex and gzip are");
}

struct DataNames {
  std::vector<std::string> names;
  std::int64_t dimension = 0;  ///< of each file; 0: one less than of the array
};

Result<std::int64_t> file_dimension(const NrrdHeader& nrrd, const std::string& word) {
  const auto dimension = parse_integer(word);
  if (dimension && *dimension >= 1 && *dimension <= 16) return *dimension;
  return nrrd.complain("datafile", in_quotes(word) + " is no dimension of a file");
}

Result<DataNames> listed_names(const NrrdHeader& nrrd, const std::string& value) {
  DataNames data{nrrd.listed, 0};
  const std::vector<std::string> words = words_of(value);
  if (words.size() > 2) return nrrd.complain("datafile", "LIST is followed by one number at most");
  if (words.size() == 2) {
    const Result<std::int64_t> dimension = file_dimension(nrrd, words[1]);
    if (!dimension) return dimension.error();
    data.dimension = *dimension;
  }
  return data;
}

// "PATTERN MIN MAX STEP [DIMENSION]"; empty where it is none such.
Result<DataNames> numbered_names(const NrrdHeader& nrrd, const std::string& value) {
  const std::vector<std::string> words = words_of(value);
  if (words.size() < 4) return DataNames{};
  std::size_t first = words.size() >= 5 && is_pattern(words[words.size() - 5]) ? words.size() - 4
                                                                               : words.size() - 3;
  std::array<std::int64_t, 3> range{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = parse_integer(words[first + i]);
    if (!number || *number > 1'000'000'000 || *number < -1'000'000'000) return DataNames{};
    range[i] = *number;
  }
  // The pattern may have blanks in it.
  const std::string pattern(
      trimmed(value.substr(0, value.find(words[first - 1]) + words[first - 1].size())));
  if (!is_pattern(pattern)) return DataNames{};
  const auto [from, to, step] = range;
  if (step == 0 || (to - from) / step < 0 ||
      static_cast<std::size_t>((to - from) / step) >= kMostFiles) {
    return nrrd.complain("datafile", "the numbers of files do not go from the first to the last");
  }
  DataNames data;
  for (std::int64_t i = from; step > 0 ? i <= to : i >= to; i += step) {
    data.names.push_back(numbered(pattern, i));
  }
  if (first + 3 < words.size()) {
    const Result<std::int64_t> dimension = file_dimension(nrrd, words[first + 3]);
    if (!dimension) return dimension.error();
    data.dimension = *dimension;
  }
  return data;
}

// How many samples each of the files has.
Result<std::uint64_t> samples_each(const NrrdHeader& nrrd, const VolumeHeader& header,
                                   const DataNames& data) {
  const std::uint64_t files = data.names.size();
  const std::uint64_t all = std::uint64_t{header.voxels()} * header.layers;
  const std::size_t dimension =
      data.dimension > 0 ? static_cast<std::size_t>(data.dimension) : header.sizes.size() - 1;
  std::uint64_t each = 1;
  for (std::size_t i = 0; i < dimension && i < header.sizes.size(); ++i) each *= header.sizes[i];
  // Files of all dimensions share the slowest one.
  if (dimension >= header.sizes.size() && files > 0 && header.sizes.back() % files == 0) {
    each = all / files;
  }
  if (files > 0 && all % files == 0 && all / files == each) return each;
  return nrrd.complain("datafile", std::to_string(files) + " files of " + std::to_string(each) +
                                       " samples are named, where the volume has " +
                                       std::to_string(all));
}

// Passes over lines, as they stand in the file.
Result<void> skip_lines(const VoxelData& data, std::int64_t lines, DataPart& part) {
  if (lines == 0) return {};
  const Result<OpenPart> file = open_part(data, part);
  if (!file) return file.error();
  std::array<char, 4096> piece{};
  for (;;) {
    const Result<std::size_t> got = file->bytes->read_at(part.offset, piece);
    if (!got) return got.error();
    if (*got == 0) return {};
    for (std::size_t i = 0; i < *got; ++i) {
      ++part.offset;
      if (piece[i] == '\n' && --lines == 0) return {};
    }
  }
}

// −1: the data are the last bytes of the file, or of what it unpacks to.
Result<void> skip_bytes(const NrrdHeader& nrrd, const VoxelData& data, std::int64_t bytes,
                        DataPart& part) {
  if (bytes >= 0) {
    const bool packed = data.encoding != DataEncoding::raw && data.encoding != DataEncoding::text;
    (packed ? part.skip : part.offset) += static_cast<std::uint64_t>(bytes);
    return {};
  }
  const std::uint64_t wanted = part.samples * size_of(data.format.type);
  if (data.encoding == DataEncoding::gzip) {
    const Result<std::uint64_t> size = unpacked_size(data, part);
    if (!size) return size.error();
    part.skip = *size - std::min(*size, wanted);
    return {};
  }
  if (data.encoding != DataEncoding::raw) {
    return nrrd.complain("byteskip", "only raw data, or data in gzip, may be the last of a file");
  }
  const Result<OpenPart> file = open_part(data, part);
  if (!file) return file.error();
  const std::uint64_t size = file->bytes->size();
  if (size >= part.offset && size - part.offset >= wanted) part.offset = size - wanted;
  return {};
}

Result<std::int64_t> skip_of(const NrrdHeader& nrrd, const std::string& identifier,
                             std::int64_t least) {
  const NrrdField* const field = nrrd.find(identifier);
  if (field == nullptr) return std::int64_t{0};
  const auto number = parse_integer(trimmed(field->value));
  if (number && *number >= least && *number < std::int64_t{1} << 48) return *number;
  return nrrd.complain(identifier,
                       in_quotes(field->value) + (least < 0 ? " is neither −1 nor a number of bytes"
                                                            : " is no number of lines"));
}

Result<std::vector<DataPart>> named_parts(const NrrdHeader& nrrd, const Source& source,
                                          const VolumeHeader& header) {
  const std::string& value = nrrd.find("datafile")->value;
  Result<DataNames> data =
      nrrd.has_list() ? listed_names(nrrd, value) : numbered_names(nrrd, value);
  if (!data) return data.error();
  const bool single = data->names.empty() && !nrrd.has_list();
  if (single) *data = {{value}, static_cast<std::int64_t>(header.sizes.size())};
  if (data->names.size() > kMostFiles) return nrrd.complain("datafile", "too many files are named");
  const Result<std::uint64_t> each = samples_each(nrrd, header, *data);
  if (!each) return each.error();
  std::vector<DataPart> parts;
  for (const std::string& name : data->names) {
    Result<std::string> path = data_file(source.folder, source.name, name);
    if (!path) return path.error();
    DataPart part;
    part.path = *std::move(path);
    part.samples = *each;
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

Result<void> find_nrrd_data(const NrrdHeader& nrrd, const Source& source,
                            const VolumeHeader& header, VoxelData& data) {
  const Result<DataEncoding> encoding = encoding_of(nrrd);
  if (!encoding) return encoding.error();
  data.encoding = *encoding;
  const Result<std::int64_t> lines = skip_of(nrrd, "lineskip", 0);
  const Result<std::int64_t> bytes = skip_of(nrrd, "byteskip", -1);
  if (!lines) return lines.error();
  if (!bytes) return bytes.error();
  if (nrrd.find("datafile") != nullptr) {
    Result<std::vector<DataPart>> parts = named_parts(nrrd, source, header);
    if (!parts) return parts.error();
    data.parts = *std::move(parts);
  } else {
    DataPart part;
    part.offset = nrrd.data.value_or(source.whole->size());
    part.samples = std::uint64_t{header.voxels()} * header.layers;
    data.parts.push_back(part);
  }
  for (DataPart& part : data.parts) {
    if (Result<void> skipped = skip_lines(data, *lines, part); !skipped) return skipped;
    if (Result<void> skipped = skip_bytes(nrrd, data, *bytes, part); !skipped) return skipped;
  }
  return check_parts(data);
}

}  // namespace tetloft::internal::io
