// Compression by DEFLATE (RFC 1951).
#pragma once

#include <string>
#include <string_view>

namespace tetloft::internal::io {

/// The bare stream, as zip archives hold it.
[[nodiscard]] std::string deflated(std::string_view bytes);
/// In a zlib stream (RFC 1950), as PNG files and browsers read it.
[[nodiscard]] std::string zlib_compressed(std::string_view bytes);

}  // namespace tetloft::internal::io
