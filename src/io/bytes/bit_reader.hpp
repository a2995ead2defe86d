// Bits of a source, the low ones of each byte first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <tetloft/result.hpp>

#include "core/guard.hpp"
#include "io/bytes/byte_source.hpp"

namespace tetloft::internal::io {

/// Errors are thrown as Failed: at the source, and where bits are taken that are not there.
class BitReader {
 public:
  BitReader(const ByteSource& source, std::uint64_t offset, std::string name)
      : source_(&source), next_(offset), name_(std::move(name)) {}

  /// At least 48 of the next bits where there are so many; zeros behind the end.
  [[nodiscard]] std::uint64_t peek() {
    if (count_ < 48) fill();
    return bits_;
  }
  void skip(unsigned count) {
    if (count > count_) fail("the compressed data are cut off");
    bits_ >>= count;
    count_ -= count;
  }
  /// The next `count` bits, at most 32.
  [[nodiscard]] std::uint32_t take(unsigned count) {
    const auto mask = (std::uint64_t{1} << count) - 1;
    const auto value = static_cast<std::uint32_t>(peek() & mask);
    skip(count);
    return value;
  }
  void skip_to_byte() { skip(count_ % 8); }
  /// Copies up to `count` whole bytes, which begin at a byte; returns how many, 0 at the end.
  [[nodiscard]] std::size_t copy(char* to, std::size_t count);
  [[nodiscard]] bool at_end() {
    static_cast<void>(peek());
    return count_ == 0;
  }
  /// In the source, behind the byte of the last bit that was taken.
  [[nodiscard]] std::uint64_t position() const {
    return next_ - (buffer_end_ - buffer_at_) - count_ / 8;
  }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void fill();
  [[nodiscard]] bool refill();

  const ByteSource* source_;
  std::uint64_t next_;  ///< offset behind the buffer
  std::string name_;
  std::array<char, std::size_t{1} << 15> buffer_{};
  std::size_t buffer_at_ = 0;
  std::size_t buffer_end_ = 0;
  std::uint64_t bits_ = 0;
  unsigned count_ = 0;
};

}  // namespace tetloft::internal::io
