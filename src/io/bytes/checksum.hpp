// The checksums of RFC 1952 (CRC-32) and RFC 1950 (Adler-32), taken piece by piece.
#pragma once

#include <cstdint>
#include <string_view>

namespace tetloft::internal::io {

inline constexpr std::uint32_t kCrcOfNothing = 0;
inline constexpr std::uint32_t kAdlerOfNothing = 1;

/// Of the bytes so far, whose sum is `sum`, and `bytes` behind them.
[[nodiscard]] std::uint32_t crc32(std::uint32_t sum, std::string_view bytes);
[[nodiscard]] std::uint32_t adler32(std::uint32_t sum, std::string_view bytes);

/// Both, in 64 bits: whether a file is the one that was seen before.
class TwofoldChecksum {
 public:
  void add(std::string_view bytes) {
    crc_ = crc32(crc_, bytes);
    adler_ = adler32(adler_, bytes);
  }
  [[nodiscard]] std::uint64_t value() const { return std::uint64_t{crc_} << 32 | adler_; }

 private:
  std::uint32_t crc_ = kCrcOfNothing;
  std::uint32_t adler_ = kAdlerOfNothing;
};

}  // namespace tetloft::internal::io
