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

}  // namespace tetloft::internal::io
