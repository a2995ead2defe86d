// Files of many records (core/record.hpp), one after the other, and a table of them at the end: of
// a large file a part is read, and what was read is known to be whole.
//
// Bytes: the records; a record of kind "tabl", which has where each begins, its length and its
// checksum; where that record begins (64 bits, little-endian), and "tetlofta".
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/scratch_file.hpp"
#include "io/sink.hpp"

namespace tetloft::internal::pieces {

class ArchiveWriter {
 public:
  explicit ArchiveWriter(io::Sink& sink) : sink_(sink) {}

  void append(std::string_view record);
  /// The table. Returns the archive's identity.
  std::uint64_t finish();

 private:
  struct Entry {
    std::uint64_t at = 0, length = 0, checksum = 0;
  };
  io::Sink& sink_;
  std::uint64_t at_ = 0;
  std::vector<Entry> entries_;
};

/// Reads single records; from several threads at once.
class ArchiveReader {
 public:
  /// Error io where it cannot be read; invalid_input where it is no archive, or cut off.
  [[nodiscard]] static Result<ArchiveReader> open(const std::string& path);

  /// Of an archive that was just written to a scratch file; `path` stands for it.
  [[nodiscard]] static Result<ArchiveReader> of(io::ScratchFile archive, const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Of two archives with the same records the same, of others, with near certainty, another one.
  [[nodiscard]] std::uint64_t identity() const { return identity_; }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  /// Its bytes; whether they are a record is for its reader to say.
  [[nodiscard]] Result<std::string> record(std::size_t k) const;

 private:
  struct Entry {
    std::uint64_t at = 0, length = 0;
  };
  struct File {
    std::ifstream stream;
    std::optional<io::ScratchFile> scratch;  // instead
    std::mutex mutex;
  };
  [[nodiscard]] static Result<ArchiveReader> of(std::unique_ptr<File> file, std::uint64_t length,
                                                const std::string& path);
  [[nodiscard]] Result<std::string> bytes(std::uint64_t at, std::uint64_t length) const;

  std::string path_;
  std::unique_ptr<File> file_;
  std::uint64_t identity_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace tetloft::internal::pieces
