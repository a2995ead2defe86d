// Bytes that are written, read again and thrown away: what is too much for memory. No name is left
// behind, whatever ends the process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "io/sink.hpp"

namespace tetloft::internal::io {

class ScratchFile final : public Sink {
 public:
  /// A temporary in the folder where a file at `path` would appear: what fits there twice can be
  /// put together from it. Of a pipe or device in the system's folder of temporaries.
  explicit ScratchFile(const std::string& path);
  ~ScratchFile() override;
  ScratchFile(ScratchFile&&) noexcept;
  ScratchFile& operator=(ScratchFile&&) noexcept;

  /// At the end. The first failure is remembered.
  void append(std::string_view bytes) override;
  [[nodiscard]] bool ok() const override { return !failure(); }
  /// Error io, naming the path.
  [[nodiscard]] const std::optional<Error>& failure() const;

  /// What could not be written counts, up to the first failure.
  [[nodiscard]] std::uint64_t size() const;
  /// Takes back all that was appended behind the first `size` bytes.
  void cut(std::uint64_t size);
  /// Bytes from `at` on, all of which must be there; zeros where that fails.
  void read(std::uint64_t at, std::span<char> bytes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tetloft::internal::io
