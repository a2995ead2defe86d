// Unpacking: as it is, inflated, or from hexadecimal digits.
#include "io/volume/part_bytes.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/inflate.hpp"
#include "io/cursor.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

class RawBytes final : public PartBytes {
 public:
  RawBytes(const ByteSource& file, std::uint64_t offset) : file_(file), at_(offset) {}
  [[nodiscard]] Result<std::size_t> read(std::span<char> to) override {
    Result<std::size_t> got = file_.read_at(at_, to);
    if (got) at_ += *got;
    return got;
  }
  [[nodiscard]] Result<void> skip(std::uint64_t count) override {
    at_ += count;
    return {};
  }

 private:
  const ByteSource& file_;
  std::uint64_t at_;
};

class InflatedBytes final : public PartBytes {
 public:
  InflatedBytes(const OpenPart& file, std::uint64_t offset, Wrapping wrapping)
      : inflater_(*file.bytes, offset, wrapping, file.name) {}
  [[nodiscard]] Result<std::size_t> read(std::span<char> to) override { return inflater_.read(to); }

 private:
  Inflater inflater_;
};

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

class HexBytes final : public PartBytes {
 public:
  HexBytes(const OpenPart& file, std::uint64_t offset) : file_(file), at_(offset) {}
  [[nodiscard]] Result<std::size_t> read(std::span<char> to) override {
    std::size_t done = 0;
    while (done < to.size()) {
      int byte = 0;
      for (int i = 0; i < 2; ++i) {
        const Result<int> digit = next_digit();
        if (!digit) return digit.error();
        if (*digit < 0) return done;
        byte = 16 * byte + *digit;
      }
      to[done++] = static_cast<char>(byte);
    }
    return done;
  }

 private:
  // −1 at the end.
  Result<int> next_digit() {
    for (;;) {
      if (used_ == filled_) {
        const Result<std::size_t> got = file_.bytes->read_at(at_, buffer_);
        if (!got) return got.error();
        if (*got == 0) return -1;
        at_ += *got;
        filled_ = *got;
        used_ = 0;
      }
      const char c = buffer_[used_++];
      if (is_white(c)) continue;
      const int digit = hex_digit(c);
      if (digit >= 0) return digit;
      return volume_error(file_.name, "the hexadecimal data have something else at byte " +
                                          std::to_string(at_ - filled_ + used_ - 1));
    }
  }

  const OpenPart& file_;
  std::uint64_t at_;
  std::array<char, 4096> buffer_{};
  std::size_t used_ = 0;
  std::size_t filled_ = 0;
};

}  // namespace

Result<void> PartBytes::skip(std::uint64_t count) {
  std::array<char, 4096> unused{};
  while (count > 0) {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count, unused.size()));
    const Result<std::size_t> got = read(std::span(unused).first(part));
    if (!got) return got.error();
    if (*got == 0) return {};
    count -= *got;
  }
  return {};
}

std::unique_ptr<PartBytes> bytes_of_part(DataEncoding encoding, const OpenPart& file,
                                         std::uint64_t offset) {
  switch (encoding) {
    case DataEncoding::gzip: return std::make_unique<InflatedBytes>(file, offset, Wrapping::gzip);
    case DataEncoding::zlib: return std::make_unique<InflatedBytes>(file, offset, Wrapping::zlib);
    case DataEncoding::hex: return std::make_unique<HexBytes>(file, offset);
    case DataEncoding::raw:
    case DataEncoding::text: break;
  }
  return std::make_unique<RawBytes>(*file.bytes, offset);
}

}  // namespace tetloft::internal::io
