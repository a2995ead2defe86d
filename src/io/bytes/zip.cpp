// See zip.hpp. Section numbers are those of APPNOTE.
#include "io/bytes/zip.hpp"

#include <limits>
#include <utility>

#include "core/little_endian.hpp"
#include "io/bytes/checksum.hpp"
#include "io/bytes/deflate.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::uint32_t kLocalHeader = 0x04034B50;      // 4.3.7
constexpr std::uint32_t kDirectoryHeader = 0x02014B50;  // 4.3.12
constexpr std::uint32_t kEndOfDirectory = 0x06054B50;   // 4.3.16
constexpr std::uint16_t kZipVersion = 20;               // 4.4.3.2: folders, DEFLATE
constexpr std::uint16_t kZipDay = 1U << 5 | 1U;         // 4.4.6: 1 January 1980, at midnight
constexpr std::uint16_t kZipStored = 0;                 // 4.4.5
constexpr std::uint16_t kZipDeflated = 8;
constexpr std::uint64_t kLocalBytes = 30;
constexpr std::uint64_t kDirectoryBytes = 46;
constexpr std::uint64_t kEndBytes = 22;

// What both headers of an entry have: version to the length of the extra field.
void append_zip_fields(std::string& text, const ZipEntry& entry) {
  append_little(text, kZipVersion);
  append_little(text, std::uint16_t{0});  // flags: sizes are here, the name is ASCII
  append_little(text, entry.deflated ? kZipDeflated : kZipStored);
  append_little(text, std::uint16_t{0});
  append_little(text, kZipDay);
  append_little(text, entry.crc);
  append_little(text, static_cast<std::uint32_t>(entry.packed.size()));
  append_little(text, static_cast<std::uint32_t>(entry.size));
  append_little(text, static_cast<std::uint16_t>(entry.name.size()));
  append_little(text, std::uint16_t{0});
}

std::string directory_header(const ZipEntry& entry, std::uint32_t offset) {
  std::string text;
  append_little(text, kDirectoryHeader);
  append_little(text, kZipVersion);  // of the writer
  append_zip_fields(text, entry);
  append_little(text, std::uint16_t{0});  // no comment
  append_little(text, std::uint16_t{0});  // on the first disk
  append_little(text, std::uint16_t{0});  // attributes
  append_little(text, std::uint32_t{0});
  append_little(text, offset);
  return text + entry.name;
}

// Entries are never larger than unpacked, so no offset or size of the archive is beyond 32 bits.
Result<void> check_zip_sizes(std::span<const ZipEntry> entries) {
  std::uint64_t bytes = kEndBytes;
  for (const ZipEntry& entry : entries) {
    bytes += entry.size + kLocalBytes + kDirectoryBytes + 2 * entry.name.size();
    if (bytes > std::numeric_limits<std::uint32_t>::max()) {
      return Error{ErrorCode::invalid_input, "a zip archive of 4 GiB or more, unpacked", {}};
    }
  }
  if (entries.size() < std::numeric_limits<std::uint16_t>::max()) return {};
  return Error{ErrorCode::invalid_input, "a zip archive of 65535 entries or more", {}};
}

}  // namespace

ZipEntry zip_entry(std::string name, std::string_view bytes) {
  ZipEntry entry{std::move(name), deflated(bytes), true, bytes.size(), 0};
  entry.crc = crc32(kCrcOfNothing, bytes);
  if (entry.packed.size() >= bytes.size()) {
    entry.packed = bytes;
    entry.deflated = false;
  }
  return entry;
}

Result<void> append_zip(Sink& sink, std::span<const ZipEntry> entries) {
  if (Result<void> fit = check_zip_sizes(entries); !fit) return fit.error();
  std::string directory;
  std::uint64_t offset = 0;
  for (const ZipEntry& entry : entries) {
    directory += directory_header(entry, static_cast<std::uint32_t>(offset));
    std::string header;
    append_little(header, kLocalHeader);
    append_zip_fields(header, entry);
    sink.append(header + entry.name);
    sink.append(entry.packed);
    offset += kLocalBytes + entry.name.size() + entry.packed.size();
  }
  const auto count = static_cast<std::uint16_t>(entries.size());
  const auto directory_bytes = static_cast<std::uint32_t>(directory.size());
  append_little(directory, kEndOfDirectory);
  append_little(directory, std::uint16_t{0});  // this disk, and that of the directory
  append_little(directory, std::uint16_t{0});
  append_little(directory, count);  // on this disk, and in all
  append_little(directory, count);
  append_little(directory, directory_bytes);
  append_little(directory, static_cast<std::uint32_t>(offset));
  append_little(directory, std::uint16_t{0});  // no comment
  sink.append(directory);
  return {};
}

}  // namespace tetloft::internal::io
