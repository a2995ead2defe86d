// What files of voxels hold, before contours are traced: a grid, where it lies, and its values one
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
  std::array<std::size_t, 3> size{};  ///< above 0, the fastest index first
  std::size_t layers = 1;             ///< further dimensions, together; above 0
  std::vector<std::size_t> sizes;     ///< of all dimensions, as the file has them
  std::array<double, 3> spacing{};
  /// From indices to the format's world, row by row; which world: `space` ("LPS", "RAS").
  std::array<std::array<double, 4>, 4> matrix{};
  std::string space;
  std::string type;                     ///< "uint8", …
  std::string unit;                     ///< of length
  std::vector<VolumeSegment> segments;  ///< that the file names
  std::vector<Warning> warnings;

  /// Of a layer. Readers refuse what does not fit.
  [[nodiscard]] std::size_t voxels() const { return size[0] * size[1] * size[2]; }
};

class Volume {
 public:
  virtual ~Volume() = default;
  [[nodiscard]] const VolumeHeader& header() const { return header_; }

  using TakeValues = std::function<Result<void>(std::span<const double>)>;
  /// Hands out all values of `layer` in pieces, the fastest index first, scaled as the file says.
  /// Memory: a piece, whatever the size of the volume. May be called again; ends early with an
  /// error of `take`.
  virtual Result<void> for_each_piece(std::size_t layer, const TakeValues& take) = 0;

  /// The files that the values are read from, beside that of the header; each once.
  [[nodiscard]] virtual std::vector<std::string> data_files() const { return {}; }

 protected:
  VolumeHeader header_;
};

}  // namespace tetloft::internal::io
