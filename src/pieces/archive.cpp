#include "pieces/archive.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/little_endian.hpp"
#include "core/record.hpp"

namespace tetloft::internal::pieces {

namespace {

constexpr RecordKind kTable{"tabl", 1, "a table of records"};
constexpr std::string_view kEnd{"tetlofta"};
constexpr std::size_t kTail = sizeof(std::uint64_t) + kEnd.size();
constexpr std::size_t kTableEntry = 3 * sizeof(std::uint64_t);

// The last word of a record: its checksum.
std::uint64_t checksum_of(std::string_view record) {
  return load_little<std::uint64_t>(record.data() + record.size() - sizeof(std::uint64_t));
}

Error archive_error(const std::string& path, ErrorCode code, std::string message) {
  Error error{code, std::move(message), {}};
  error.where.file = path;
  return error;
}

}  // namespace

void ArchiveWriter::append(std::string_view record) {
  entries_.push_back({at_, record.size(), checksum_of(record)});
  sink_.append(record);
  at_ += record.size();
}

std::uint64_t ArchiveWriter::finish() {
  RecordWriter table(kTable);
  table.put_count(entries_.size());
  for (const Entry& entry : entries_) {
    table.put(entry.at);
    table.put(entry.length);
    table.put(entry.checksum);
  }
  const std::string bytes = table.take();
  sink_.append(bytes);
  std::string tail;
  append_little(tail, at_);
  sink_.append(tail.append(kEnd));
  return checksum_of(bytes);
}

Result<ArchiveReader> ArchiveReader::open(const std::string& path) {
  auto file = std::make_unique<File>();
  errno = 0;
  std::ifstream& stream = file->stream;
  stream.open(path, std::ios::binary);
  if (!stream) {
    const int reason = errno != 0 ? errno : ENOENT;
    return archive_error(path, ErrorCode::io,
                         "cannot be opened: " + std::generic_category().message(reason));
  }
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  if (size < 0 || !stream) {
    return archive_error(path, ErrorCode::io, "cannot be read from where one likes");
  }
  return of(std::move(file), static_cast<std::uint64_t>(size), path);
}

Result<ArchiveReader> ArchiveReader::of(io::ScratchFile archive, const std::string& path) {
  auto file = std::make_unique<File>();
  const std::uint64_t size = archive.size();
  file->scratch = std::move(archive);
  return of(std::move(file), size, path);
}

Result<ArchiveReader> ArchiveReader::of(std::unique_ptr<File> file, std::uint64_t length,
                                        const std::string& path) {
  ArchiveReader reader;
  reader.path_ = path;
  reader.file_ = std::move(file);
  const auto no_archive = [&] {
    return archive_error(path, ErrorCode::invalid_input, "is no plan of tetloft, or is cut off");
  };
  if (length < kTail) return no_archive();
  Result<std::string> tail = reader.bytes(length - kTail, kTail);
  if (!tail) return tail.error();
  const auto at = load_little<std::uint64_t>(tail->data());
  if (!tail->ends_with(kEnd) || at > length - kTail) return no_archive();
  Result<std::string> table = reader.bytes(at, length - kTail - at);
  if (!table) return table.error();
  RecordReader in(*table, kTable, path);
  std::vector<Entry> entries(in.get_count(kTableEntry));
  std::uint64_t next = 0;
  for (Entry& entry : entries) {
    entry.at = in.get<std::uint64_t>();
    entry.length = in.get<std::uint64_t>();
    static_cast<void>(in.get<std::uint64_t>());
    in.require(entry.at == next && entry.length <= at - next, "has records where there are none");
    if (in.refused()) break;
    next += entry.length;
  }
  in.require(next == at, "leaves out what is in the file");
  if (Result<void> read = in.end(); !read) return read.error();
  reader.identity_ = checksum_of(*table);
  reader.entries_ = std::move(entries);
  return reader;
}

Result<std::string> ArchiveReader::record(std::size_t k) const {
  return bytes(entries_[k].at, entries_[k].length);
}

Result<std::string> ArchiveReader::bytes(std::uint64_t at, std::uint64_t length) const {
  const std::scoped_lock lock(file_->mutex);
  std::string bytes(static_cast<std::size_t>(length), '\0');
  if (file_->scratch) {
    file_->scratch->read(at, bytes);
    if (file_->scratch->failure()) return *file_->scratch->failure();
    return bytes;
  }
  std::ifstream& stream = file_->stream;
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(at));
  stream.read(bytes.data(), static_cast<std::streamsize>(length));
  if (!stream) return archive_error(path_, ErrorCode::io, "cannot be read to its end");
  return bytes;
}

}  // namespace tetloft::internal::pieces
