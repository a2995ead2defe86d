// Compression by DEFLATE (RFC 1951) in a zlib stream (RFC 1950), as PNG files and browsers read it.
#pragma once

#include <string>
#include <string_view>

namespace tetloft::internal::render {

/// The zlib stream of `bytes`: matches by hash chains, one dynamic Huffman code for each block.
[[nodiscard]] std::string zlib_compressed(std::string_view bytes);

}  // namespace tetloft::internal::render
