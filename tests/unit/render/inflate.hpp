// Decoding DEFLATE and zlib streams, by code of its own: written from RFC 1951, canonical codes bit
// by bit.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tetloft::test {

/// The bytes of a bare DEFLATE stream; empty where anything is wrong, or something is behind it.
[[nodiscard]] std::optional<std::string> inflate_bare(std::string_view stream);

/// The bytes of a zlib stream; empty where anything is wrong, its checksum and length included.
[[nodiscard]] std::optional<std::string> inflate(std::string_view stream);

}  // namespace tetloft::test
