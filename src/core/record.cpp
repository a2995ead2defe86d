#include "core/record.hpp"

#include <cstring>
#include <utility>

namespace tetloft::internal {

namespace {

constexpr std::string_view kMagic{"tetloft\0", 8};
constexpr std::size_t kHeader = 24;  // magic, letters, version, length
constexpr std::size_t kChecksum = 8;

std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return hash;
}

}  // namespace

RecordWriter::RecordWriter(const RecordKind& kind) {
  bytes_.append(kMagic);
  bytes_.append(kind.letters);
  put(kind.version);
  put(std::uint64_t{0});  // the length, once it is known
}

std::string RecordWriter::take() {
  std::string length;
  append_little(length, static_cast<std::uint64_t>(bytes_.size() - kHeader));
  bytes_.replace(kHeader - length.size(), length.size(), length);
  put(fnv1a(bytes_));
  return std::move(bytes_);
}

std::vector<std::byte> RecordWriter::take_bytes() {
  const std::string bytes = take();
  std::vector<std::byte> result(bytes.size());
  std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

bool begins_as(std::string_view bytes, const RecordKind& kind) {
  return bytes.starts_with(kMagic) && bytes.substr(kMagic.size()).starts_with(kind.letters);
}

RecordReader::RecordReader(std::span<const std::byte> bytes, const RecordKind& kind)
    : RecordReader({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, kind, {}) {}

RecordReader::RecordReader(std::string_view bytes, const RecordKind& kind, std::string name)
    : kind_(kind), name_(std::move(name)) {
  if (!bytes.starts_with(kMagic) || bytes.size() < kHeader + kChecksum) {
    refuse("is no record of tetloft, or cut off");
    return;
  }
  if (bytes.substr(kMagic.size(), kind.letters.size()) != kind.letters) {
    refuse("holds something else");
    return;
  }
  const auto version = load_little<std::uint32_t>(bytes.data() + 12);
  if (version != kind.version) {
    refuse("has version " + std::to_string(version) + ", where " + std::to_string(kind.version) +
           " can be read");
    return;
  }
  if (load_little<std::uint64_t>(bytes.data() + 16) != bytes.size() - kHeader - kChecksum) {
    refuse("is cut off, or goes on behind its end");
    return;
  }
  const std::string_view checked = bytes.substr(0, bytes.size() - kChecksum);
  if (load_little<std::uint64_t>(bytes.data() + checked.size()) != fnv1a(checked)) {
    refuse("is damaged: its checksum does not match");
    return;
  }
  left_ = checked.substr(kHeader);
}

std::size_t RecordReader::get_count(std::size_t bytes_each) {
  const auto n = get<std::uint64_t>();
  if (n <= left_.size() / bytes_each) return static_cast<std::size_t>(n);
  refuse("counts more than it holds");
  return 0;
}

void RecordReader::refuse(std::string_view reason) {
  left_ = {};
  if (refused_) return;
  refused_ = true;
  error_.code = ErrorCode::invalid_input;
  error_.message = "not " + std::string(kind_.name) + ": it " + std::string(reason);
  error_.where.file = name_;
}

Result<void> RecordReader::end() {
  if (!refused_ && !left_.empty()) refuse("holds more than it counts");
  if (refused_) return error_;
  return {};
}

}  // namespace tetloft::internal
