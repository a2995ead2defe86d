// Zip archives read back, by code of the tests' own: strictly what a writer of few files needs.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tetloft::test {

struct ZipFile {
  std::string bytes;
  bool deflated = false;
};

struct ZipArchive {
  std::vector<std::string> names;  ///< in the order of the directory
  std::map<std::string, ZipFile> files;
};

/// Empty where anything is wrong: signatures, headers that differ, sizes, checksums, bytes that
/// belong to nothing.
[[nodiscard]] std::optional<ZipArchive> read_zip(const std::string& archive);

/// Bit by bit, from the polynomial.
[[nodiscard]] std::uint32_t slow_crc32(const std::string& bytes);

}  // namespace tetloft::test
