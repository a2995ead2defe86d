// The numbers of which files of voxels are made: types, byte orders, scales; and headers that hold
// such numbers.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "io/scalar_type.hpp"

namespace tetloft::internal::io {

struct SampleFormat {
  ScalarType type = ScalarType::uint8;
  bool big_endian = false;
  /// A voxel's value is slope · sample + intercept.
  double slope = 1;
  double intercept = 0;
};

/// bytes.size() is values.size() · size_of(format.type). Integers of 64 bits are rounded to
/// doubles.
void convert_samples(const SampleFormat& format, std::span<const char> bytes,
                     std::span<double> values);
/// By the scale alone.
void scale_samples(const SampleFormat& format, std::span<double> values);

/// The number whose bytes these are, in the order of the file.
template <class Number>
[[nodiscard]] Number number_in(const char* bytes, bool big_endian) {
  std::array<char, sizeof(Number)> own{};
  std::memcpy(own.data(), bytes, sizeof(Number));
  if (sizeof(Number) > 1 && big_endian != (std::endian::native == std::endian::big)) {
    for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) {
      const char c = own[i];
      own[i] = own[sizeof(Number) - 1 - i];
      own[sizeof(Number) - 1 - i] = c;
    }
  }
  Number number;
  std::memcpy(&number, own.data(), sizeof(Number));
  return number;
}

}  // namespace tetloft::internal::io
