// Base64 (RFC 4648) as VTK files and pages hold it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tetloft::internal::io {

/// Decodes groups of four characters until `wanted` bytes are there or the text ends, white
/// space between them passed over. A padded group ends a run, and another may follow: some
/// writers encode the byte count and the data apart. Empty where a character is foreign.
[[nodiscard]] std::optional<std::string> decode_base64(std::string_view text, std::size_t wanted);

/// In one line, padded.
[[nodiscard]] std::string encode_base64(std::string_view bytes);

}  // namespace tetloft::internal::io
