// What files of voxels hold, before contours are traced: a grid, where it lies, and its slices one
// after the other.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

/// A structure of a label volume.
struct VolumeSegment {
  double value = 0;
  std::string name;
  std::size_t layer = 0;
};

struct VolumeHeader {
  std::array<std::size_t, 3> size{};  ///< the fastest index first
  std::size_t layers = 1;             ///< further dimensions, together
  bool layer_is_fastest = false;      ///< values of a voxel stand together
  std::vector<std::size_t> sizes;     ///< of all dimensions, as the file has them
  std::array<double, 3> spacing{};
  /// From indices to the format's world, row by row; which world: `space` ("LPS", "RAS").
  std::array<std::array<double, 4>, 4> matrix{};
  std::string space;
  std::string type;  ///< "uint8", …
  std::string unit;
  std::vector<VolumeSegment> segments;  ///< that the file names
  std::vector<Warning> warnings;
};

class Volume {
 public:
  virtual ~Volume() = default;
  [[nodiscard]] const VolumeHeader& header() const { return header_; }

  /// Of `layer`, all slices of constant last index, ascending: size[0] · size[1] values, scaled as
  /// the file says. Memory: a slice. May be called again; ends early with what `take` returns.
  virtual Result<void> for_each_slice(
      std::size_t layer,
      const std::function<Result<void>(std::size_t k, std::span<const double> values)>& take) = 0;

 protected:
  VolumeHeader header_;
};

}  // namespace tetloft::internal::io
