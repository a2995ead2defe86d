// The bytes of a part of the data, unpacked, from front to back.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <tetloft/result.hpp>

#include "io/volume/data_stream.hpp"

namespace tetloft::internal::io {

class PartBytes {
 public:
  virtual ~PartBytes() = default;
  /// Fills `to` as far as there are bytes; returns how much.
  [[nodiscard]] virtual Result<std::size_t> read(std::span<char> to) = 0;
  /// Passes over as many as there are of `count`.
  [[nodiscard]] virtual Result<void> skip(std::uint64_t count);
};

/// Of text the characters; else data as they were before they were packed. `file` outlives it.
[[nodiscard]] std::unique_ptr<PartBytes> bytes_of_part(DataEncoding encoding, const OpenPart& file,
                                                       std::uint64_t offset);

}  // namespace tetloft::internal::io
