// DEFLATE (RFC 1951) in its three wrappings, read as a stream: memory is a window, whatever the
// data unpack to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "io/bytes/byte_source.hpp"

namespace tetloft::internal::io {

enum class Wrapping : std::uint8_t {
  raw,   ///< RFC 1951
  zlib,  ///< RFC 1950; the checksum is compared
  gzip,  ///< RFC 1952, several members in a row; checksums and sizes are compared
};

class Inflater {
 public:
  /// Unpacks what stands in `source` from `offset` on. `source` must outlive it; `name` stands for
  /// the file in errors.
  Inflater(const ByteSource& source, std::uint64_t offset, Wrapping wrapping, std::string name);
  ~Inflater();
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Fills `to` as far as the data reach; returns how much, less than asked for only at their end.
  /// Error invalid_input naming the offset in the file where they are wrong or cut off.
  [[nodiscard]] Result<std::size_t> read(std::span<char> to);
  /// Behind the last byte that was needed.
  [[nodiscard]] std::uint64_t position() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// All of it at once. Error invalid_input where it unpacks to more than `most` bytes.
[[nodiscard]] Result<std::string> inflate(std::string_view bytes, Wrapping wrapping,
                                          std::size_t most, const std::string& name);

}  // namespace tetloft::internal::io
