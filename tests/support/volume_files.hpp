// Files of voxels as the tests make them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace tetloft::test {

/// The bytes of a number, in an order.
template <class Number>
std::string bytes_of(Number number, bool big_endian = false) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  const bool native_big = std::endian::native == std::endian::big;
  return big_endian == native_big ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

template <class Number>
std::string samples_of(const std::vector<double>& values, bool big_endian = false) {
  std::string bytes;
  for (const double value : values) bytes += bytes_of(static_cast<Number>(value), big_endian);
  return bytes;
}

/// 3 × 2 × 2 voxels of labels 0, 1 and 7: a 7 in the corner of the last slice.
inline const std::vector<double> kFewVoxels{0, 1, 1, 0, 1, 0, 1, 1, 0, 0, 0, 7};
inline const std::array<int, 3> kFewSizes{3, 2, 2};

/// A NIfTI header of either version, whose fields a test may change.
struct NiftiFile {
  bool version_2 = false;
  bool big_endian = false;
  std::string magic = "n+1";
  std::vector<std::int64_t> sizes{3, 2, 2};
  int datatype = 2;
  std::array<double, 8> pixdim{1, 0.5, 0.75, 2, 1, 1, 1, 1};
  double vox_offset = 352;
  double slope = 0;
  double intercept = 0;
  int units = 2;
  int qform_code = 0;
  int sform_code = 1;
  std::array<double, 6> qform{0, 0, 0, 0, 0, 0};
  std::array<double, 12> sform{0.5, 0, 0, 10, 0, 0.75, 0, 20, 0, 0, 2, 30};

  [[nodiscard]] std::string header() const { return version_2 ? header_2() : header_1(); }

 private:
  template <class Number>
  void put(std::string& bytes, std::size_t offset, double value) const {
    bytes.replace(offset, sizeof(Number), bytes_of(static_cast<Number>(value), big_endian));
  }
  template <class Size>
  void put_sizes(std::string& bytes, std::size_t offset) const {
    put<Size>(bytes, offset, static_cast<double>(sizes.size()));
    for (std::size_t i = 0; i < 7; ++i) {
      put<Size>(bytes, offset + (i + 1) * sizeof(Size),
                i < sizes.size() ? static_cast<double>(sizes[i]) : 1);
    }
  }
  template <class Real>
  void put_places(std::string& bytes, std::size_t quatern, std::size_t srow) const {
    for (std::size_t i = 0; i < 6; ++i) put<Real>(bytes, quatern + i * sizeof(Real), qform[i]);
    for (std::size_t i = 0; i < 12; ++i) put<Real>(bytes, srow + i * sizeof(Real), sform[i]);
  }
  [[nodiscard]] std::string header_1() const {
    std::string bytes(348, '\0');
    put<std::int32_t>(bytes, 0, 348);
    put_sizes<std::int16_t>(bytes, 40);
    put<std::int16_t>(bytes, 70, datatype);
    for (std::size_t i = 0; i < 8; ++i) put<float>(bytes, 76 + 4 * i, pixdim[i]);
    put<float>(bytes, 108, vox_offset);
    put<float>(bytes, 112, slope);
    put<float>(bytes, 116, intercept);
    bytes[123] = static_cast<char>(units);
    put<std::int16_t>(bytes, 252, qform_code);
    put<std::int16_t>(bytes, 254, sform_code);
    put_places<float>(bytes, 256, 280);
    bytes.replace(344, magic.size(), magic);
    return bytes;
  }
  [[nodiscard]] std::string header_2() const {
    std::string bytes(540, '\0');
    put<std::int32_t>(bytes, 0, 540);
    bytes.replace(4, 8, magic.substr(0, 2) + std::string("2\0\r\n\x1A\n", 6));
    put<std::int16_t>(bytes, 12, datatype);
    put_sizes<std::int64_t>(bytes, 16);
    for (std::size_t i = 0; i < 8; ++i) put<double>(bytes, 104 + 8 * i, pixdim[i]);
    put<std::int64_t>(bytes, 168, vox_offset);
    put<double>(bytes, 176, slope);
    put<double>(bytes, 184, intercept);
    put<std::int32_t>(bytes, 344, qform_code);
    put<std::int32_t>(bytes, 348, sform_code);
    put_places<double>(bytes, 352, 400);
    put<std::int32_t>(bytes, 500, units);
    return bytes;
  }
};

}  // namespace tetloft::test
