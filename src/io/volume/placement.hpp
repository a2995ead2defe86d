// Where the slices of a volume lie: indices become coordinates of a stack, and these those of the
// format's world.
//
// Where each index axis runs along one axis of the world, coordinates of the stack are those of the
// world, exchanged in a cycle so that the axis across the slices is z; the frame exchanges them
// back, and no bit is lost. Else they are lengths along the index axes, one of them negated where
// the axes are left-handed, and the frame is the affine map.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <tetloft/frame.hpp>
#include <tetloft/result.hpp>

#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// A coordinate by an index, or by what lies between two. Equal indices give equal coordinates, and
/// growing ones never coordinates that go back.
struct IndexedCoordinate {
  double origin = 0;
  double step = 0;
  [[nodiscard]] double at(double index) const { return origin + index * step; }
};

struct SlicePlacement {
  std::size_t across = 2;  ///< the index axis that numbers the slices
  /// Pixels of a slice are numbered by the other two, the faster one along its rows.
  std::size_t column_axis = 0;
  std::size_t row_axis = 1;
  bool column_is_x = true;  ///< of the stack; else columns give y, and rows x
  IndexedCoordinate column;
  IndexedCoordinate row;
  IndexedCoordinate height;
  Frame frame;
};

/// Error invalid_input where a matrix is not finite, or its axes are coplanar; `field` is what the
/// file calls it.
[[nodiscard]] Result<void> check_matrix(const VolumeHeader& header, const std::string& field,
                                        const std::string& name);

/// The matrix is as check_matrix() wants it, across 0 … 2. Error invalid_input where double
/// precision does not tell all coordinates apart that contours may have.
[[nodiscard]] Result<SlicePlacement> place_slices(const VolumeHeader& header, std::size_t across,
                                                  const std::string& name);

}  // namespace tetloft::internal::io
