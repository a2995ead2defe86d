// Bytes that are read in pieces: a file, or memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

class ByteSource {
 public:
  virtual ~ByteSource() = default;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Reads at `offset` as many bytes as there are, up to the size of `to`; returns how many. Error
  /// io, naming the file.
  [[nodiscard]] virtual Result<std::size_t> read_at(std::uint64_t offset,
                                                    std::span<char> to) const = 0;
};

/// `bytes` must outlive it.
class MemoryBytes final : public ByteSource {
 public:
  explicit MemoryBytes(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] Result<std::size_t> read_at(std::uint64_t offset,
                                            std::span<char> to) const override;

 private:
  std::string_view bytes_;
};

/// A regular file, open as long as it lives; null without error where it is none (a pipe, a
/// device), which can only be read from front to back. Error io where it cannot be opened.
[[nodiscard]] Result<std::unique_ptr<ByteSource>> open_bytes(const std::string& path);

}  // namespace tetloft::internal::io
