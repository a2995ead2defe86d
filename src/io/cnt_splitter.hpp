// A .cnt in the parts that its sections are, read in blocks: in memory are a part and a block.
//
// A section begins at a "v" outside of comments, behind white space or a brace. No number holds
// that letter: where another stands, the file is faulty, and the parser that gets it in a longer
// part says what it says of the whole. So that it says the same of what it meets at the end of a
// part, too, the bytes that follow are handed over, as many as a message shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tetloft/io.hpp>
#include <tetloft/result.hpp>

#include "io/bytes/byte_source.hpp"
#include "io/bytes/checksum.hpp"

namespace tetloft::internal::io {

struct CntBlocks {
  std::size_t read = std::size_t{1} << 20;  ///< bytes that are read at a time
  /// Bytes of sections that are validated together, by several threads.
  std::size_t validated = std::size_t{1} << 22;
  std::uint64_t largest_section = kLargestFile;
};

/// A place in the file.
struct CntPlace {
  std::uint64_t offset = 0;
  std::size_t line = 1;
};

struct CntPart {
  std::string_view text;    ///< with some of what follows
  std::size_t follows = 0;  ///< bytes of it that are not the part's
  CntPlace begin;

  [[nodiscard]] std::size_t size() const { return text.size() - follows; }
};

class CntSplitter {
 public:
  /// From the beginning of the file, or of a section. `source` must outlive it.
  CntSplitter(const ByteSource& source, std::string name, const CntBlocks& blocks,
              const CntPlace& from = {})
      : source_(source), name_(std::move(name)), blocks_(blocks), at_(from), read_(from.offset) {}

  /// What stands before the first section, then each section; nothing at the end. Its text is there
  /// until the next call. Error io where the file cannot be read, is shorter than it was, or has a
  /// section that is too large.
  [[nodiscard]] Result<std::optional<CntPart>> next();
  /// CRC-32 of all that was read.
  [[nodiscard]] std::uint32_t checksum() const { return checksum_; }

 private:
  Result<void> load();
  [[nodiscard]] bool find_end();
  [[nodiscard]] bool all_read() const { return read_ == source_.size(); }

  const ByteSource& source_;
  std::string name_;
  CntBlocks blocks_;
  CntPlace at_;                // where the part begins
  std::uint64_t read_;         // up to there the file is, or was, in the buffer
  std::string buffer_;         // from the part's first byte, or from before
  std::size_t begin_ = 0;      // of the part, in the buffer
  std::size_t scanned_ = 0;    // no section begins in [begin_ + 1, scanned_)
  bool in_comment_ = false;    // at scanned_
  std::size_t part_size_ = 0;  // of the part that was handed out
  std::uint32_t checksum_ = kCrcOfNothing;
};

}  // namespace tetloft::internal::io
