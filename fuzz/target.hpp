// What every target needs: to say what is wrong and end, and to take input apart.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

/// The entry that libFuzzer and replay.cpp call.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace tetloft::fuzz {

/// Ends the program as a crash where `holds` is false.
inline void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz target: %s\n", what.c_str());
  std::abort();
}

/// An error of the library is fine unless it is one of the library itself.
inline void require_clean(const Error& error) {
  require(error.code != ErrorCode::internal, "internal error: " + to_string(error));
  require(!error.message.empty(), "an error without a message");
}

/// Whether a reader read it; its error is clean and names the file.
template <class Read>
bool fine(const Result<Read>& read) {
  if (read) return true;
  require_clean(read.error());
  require(!read.error().where.file.empty(), "an error without the file's name");
  return false;
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Input taken apart from the front; zeros after its end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

  [[nodiscard]] bool empty() const { return rest_.empty(); }
  [[nodiscard]] std::size_t size() const { return rest_.size(); }

  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  /// 0 … bound − 1.
  std::size_t below(std::size_t bound) { return byte() % bound; }

  /// Any eight bytes as a double; what is not finite becomes 1.
  double any_double() {
    std::array<std::uint8_t, 8> bytes{};
    for (std::uint8_t& b : bytes) b = byte();
    double value = 0;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value - value == 0 ? value : 1;
  }

 private:
  std::span<const std::uint8_t> rest_;
};

/// How a whole input reads its coordinates: chosen by its first byte, so that both lattices,
/// where all is degenerate, and doubles of every size occur.
class Coordinates {
 public:
  explicit Coordinates(Bytes& bytes) : bytes_(bytes), form_(bytes.byte() % 5) {}

  double next() {
    switch (form_) {
      case 0: return static_cast<double>(bytes_.below(4));
      case 1: return static_cast<double>(bytes_.below(16));
      case 2: return static_cast<double>(bytes_.byte()) * 0x1p-8;
      case 3: {
        // Lattice points moved by a few ulps.
        const std::uint8_t b = bytes_.byte();
        return static_cast<double>(b >> 4) + static_cast<double>(b & 3) * 0x1p-49;
      }
      default: return bytes_.any_double();
    }
  }

 private:
  Bytes& bytes_;
  std::size_t form_;
};

}  // namespace tetloft::fuzz
