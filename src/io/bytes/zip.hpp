// Zip archives (PKWARE, APPNOTE 6.3.4), written: the same bytes for the same entries, whenever.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "io/sink.hpp"

namespace tetloft::internal::io {

/// A file of an archive.
struct ZipEntry {
  std::string name;        ///< printable ASCII, "/" between folders
  std::string packed;      ///< as deflated() makes it, or the bytes themselves
  bool deflated = false;   ///< which of both
  std::uint64_t size = 0;  ///< unpacked
  std::uint32_t crc = 0;   ///< of the bytes unpacked
};

/// Deflated where that makes the bytes fewer.
[[nodiscard]] ZipEntry zip_entry(std::string name, std::string_view bytes);

/// Refused (invalid_input), before anything is appended: 2^16 - 1 entries or more, and what takes
/// 4 GiB unpacked. Larger archives need extensions (ZIP64), which not every reader has.
[[nodiscard]] Result<void> append_zip(Sink& sink, std::span<const ZipEntry> entries);

}  // namespace tetloft::internal::io
