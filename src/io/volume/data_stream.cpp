// Reading samples part by part.
#include "io/volume/data_stream.hpp"

#include <algorithm>
#include <limits>

#include "core/text.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"
#include "io/volume/part_bytes.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

// DEFLATE has at most 258 bytes for two bits.
constexpr std::uint64_t kMostUnpacked = 1032;

Error cut_off(const std::string& name) {
  return volume_error(name, "the data end before all voxels are there");
}

/// A number of a text of values; what else floating point knows is allowed.
Result<double> value_of(std::string_view token, const std::string& name) {
  const ParsedNumber number = parse_number(token);
  if (number.ok()) return number.value;
  const std::string lower = lower_case(token.substr(0, 9));
  const double infinity = std::numeric_limits<double>::infinity();
  if (lower == "nan" || lower == "-nan") return std::numeric_limits<double>::quiet_NaN();
  if (lower == "inf" || lower == "+inf" || lower == "infinity") return infinity;
  if (lower == "-inf" || lower == "-infinity") return -infinity;
  return volume_error(name, complaint(token, number.status));
}

}  // namespace

Result<OpenPart> open_part(const VoxelData& data, const DataPart& part) {
  OpenPart opened{nullptr, data.source, data.name};
  if (part.path.empty()) return opened;
  Result<std::unique_ptr<ByteSource>> own = open_bytes(part.path);
  if (!own) return own.error();
  opened.own = *std::move(own);
  if (opened.own == nullptr) return volume_error(part.path, "the data are not in a regular file");
  opened.bytes = opened.own.get();
  opened.name = part.path;
  return opened;
}

Result<void> check_parts(const VoxelData& data) {
  const std::uint64_t bytes_each = size_of(data.format.type);
  for (const DataPart& part : data.parts) {
    const Result<OpenPart> file = open_part(data, part);
    if (!file) return file.error();
    const std::uint64_t size = file->bytes->size();
    const std::uint64_t there = size - std::min(size, part.offset);
    // Of text, each number has a digit, and all but the last white space behind it.
    bool enough = false;
    switch (data.encoding) {
      case DataEncoding::raw:
        enough = part.skip <= there && part.samples <= (there - part.skip) / bytes_each;
        break;
      case DataEncoding::gzip:
      case DataEncoding::zlib: enough = part.samples / kMostUnpacked <= there / bytes_each; break;
      case DataEncoding::text: enough = part.samples <= there / 2 + 1; break;
      case DataEncoding::hex: enough = part.samples <= there / 2 / bytes_each; break;
    }
    if (enough) continue;
    return volume_error(
        file->name, "the data are cut off: " + std::to_string(part.samples) + " voxels of type " +
                        std::string(name_of(data.format.type)) + " are announced, and there are " +
                        std::to_string(there) + " bytes");
  }
  return {};
}

/// The samples of one part.
class SampleStream::PartReader {
 public:
  PartReader(const VoxelData& data, OpenPart file) : data_(data), file_(std::move(file)) {}

  Result<void> begin(const DataPart& part) {
    bytes_ = bytes_of_part(data_.encoding, file_, part.offset);
    return bytes_->skip(part.skip);
  }

  Result<void> read(std::span<double> values) {
    if (data_.encoding == DataEncoding::text) return read_text(values);
    while (!values.empty()) {
      const std::size_t count = std::min(values.size(), kPiece);
      buffer_.resize(count * size_of(data_.format.type));
      const Result<std::size_t> got = bytes_->read(buffer_);
      if (!got) return got.error();
      if (*got < buffer_.size()) return cut_off(file_.name);
      convert_samples(data_.format, buffer_, values.first(count));
      values = values.subspan(count);
    }
    return {};
  }

  Result<void> skip(std::uint64_t samples) {
    if (data_.encoding != DataEncoding::text) {
      return bytes_->skip(samples * size_of(data_.format.type));
    }
    double unused = 0;
    for (; samples > 0; --samples) {
      if (Result<void> read = read_text({&unused, 1}); !read) return read;
    }
    return {};
  }

  // Asking for more compares the checksum, if the data end here.
  Result<void> end() {
    if (data_.encoding != DataEncoding::gzip && data_.encoding != DataEncoding::zlib) return {};
    char unused = 0;
    const Result<std::size_t> got = bytes_->read({&unused, 1});
    if (!got) return got.error();
    return {};
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 14;
  static constexpr std::size_t kLongestNumber = 400;

  Result<void> read_text(std::span<double> values) {
    for (double& value : values) {
      const Result<std::string> token = next_token();
      if (!token) return token.error();
      if (token->empty()) return cut_off(file_.name);
      const Result<double> number = value_of(*token, file_.name);
      if (!number) return number.error();
      value = *number;
    }
    scale_samples(data_.format, values);
    return {};
  }

  // Empty at the end.
  Result<std::string> next_token() {
    std::string token;
    for (;;) {
      if (used_ == buffer_.size()) {
        buffer_.resize(kPiece);
        const Result<std::size_t> got = bytes_->read(buffer_);
        if (!got) return got.error();
        buffer_.resize(*got);
        used_ = 0;
        if (*got == 0) return token;
      }
      const char c = buffer_[used_++];
      if (!is_white(c) && c != ',') {
        token += c;
        if (token.size() <= kLongestNumber) continue;
        return volume_error(file_.name, in_quotes(token) + " is not a number");
      }
      if (!token.empty()) return token;
    }
  }

  const VoxelData& data_;
  OpenPart file_;
  std::unique_ptr<PartBytes> bytes_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;  ///< characters of a text
};

SampleStream::SampleStream(const VoxelData& data) : data_(data) {}
SampleStream::~SampleStream() = default;

Result<void> SampleStream::open_next() {
  if (next_part_ == data_.parts.size()) return cut_off(data_.name);
  const DataPart& part = data_.parts[next_part_++];
  Result<OpenPart> file = open_part(data_, part);
  if (!file) return file.error();
  part_ = std::make_unique<PartReader>(data_, *std::move(file));
  left_ = part.samples;
  return part_->begin(part);
}

Result<void> SampleStream::read(std::span<double> values) {
  while (!values.empty()) {
    if (left_ == 0) {
      if (Result<void> opened = open_next(); !opened) return opened;
      continue;
    }
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(values.size(), left_));
    if (Result<void> got = part_->read(values.first(count)); !got) return got;
    values = values.subspan(count);
    left_ -= count;
    if (left_ > 0) continue;
    if (Result<void> ended = part_->end(); !ended) return ended;
  }
  return {};
}

Result<void> SampleStream::skip(std::uint64_t samples) {
  while (samples > 0) {
    if (left_ == 0 && next_part_ < data_.parts.size() &&
        data_.parts[next_part_].samples <= samples) {
      samples -= data_.parts[next_part_++].samples;
      continue;
    }
    if (left_ == 0) {
      if (Result<void> opened = open_next(); !opened) return opened;
      continue;
    }
    const std::uint64_t count = std::min(samples, left_);
    if (Result<void> skipped = part_->skip(count); !skipped) return skipped;
    samples -= count;
    left_ -= count;
  }
  return {};
}

Result<std::uint64_t> unpacked_size(const VoxelData& data, const DataPart& part) {
  const Result<OpenPart> file = open_part(data, part);
  if (!file) return file.error();
  const std::unique_ptr<PartBytes> bytes = bytes_of_part(data.encoding, *file, part.offset);
  std::vector<char> unused(std::size_t{1} << 16);
  std::uint64_t size = 0;
  for (;;) {
    const Result<std::size_t> got = bytes->read(unused);
    if (!got) return got.error();
    size += *got;
    if (*got < unused.size()) return size;
  }
}

}  // namespace tetloft::internal::io
