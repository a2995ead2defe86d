// Placing slices.
#include "io/volume/placement.hpp"

#include <cmath>
#include <optional>

#include <tetloft/predicates.hpp>
#include <tetloft/section_stack.hpp>

#include "io/numbers.hpp"
#include "io/volume/slice.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

Point3 axis_of(const VolumeHeader& header, std::size_t index_axis) {
  const auto& m = header.matrix;
  return {m[0][index_axis], m[1][index_axis], m[2][index_axis]};
}

Sign handedness(const VolumeHeader& header) {
  return orient3d({}, axis_of(header, 0), axis_of(header, 1), axis_of(header, 2));
}

/// The world axis along which each index axis runs; nothing where one runs along none.
std::optional<std::array<std::size_t, 3>> world_axes(const VolumeHeader& header) {
  std::array<std::size_t, 3> axes{};
  for (std::size_t i = 0; i < 3; ++i) {
    int found = 0;
    for (std::size_t w = 0; w < 3; ++w) {
      if (header.matrix[w][i] == 0) continue;
      axes[i] = w;
      ++found;
    }
    if (found != 1) return std::nullopt;
  }
  return axes;
}

Point3 unit_vector(std::size_t axis) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

void place_along_world(const VolumeHeader& header, const std::array<std::size_t, 3>& world,
                       SlicePlacement& placed) {
  const auto along = [&](std::size_t index_axis) {
    const auto& row = header.matrix[world[index_axis]];
    return IndexedCoordinate{row[3], row[index_axis]};
  };
  placed.column = along(placed.column_axis);
  placed.row = along(placed.row_axis);
  placed.height = along(placed.across);
  const std::size_t z = world[placed.across];
  placed.column_is_x = world[placed.column_axis] == (z + 1) % 3;
  placed.frame.axes = {unit_vector((z + 1) % 3), unit_vector((z + 2) % 3), unit_vector(z)};
}

// Lengths of axes are rounded, as are their directions: the product of both is the axis up to that.
void place_along_indices(const VolumeHeader& header, SlicePlacement& placed) {
  const auto along = [&](std::size_t index_axis, bool negated, Point3& direction) {
    const Point3 axis = axis_of(header, index_axis);
    const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
    const double step = negated ? -length : length;
    direction = {axis.x / step, axis.y / step, axis.z / step};
    return IndexedCoordinate{0, step};
  };
  // The cycle of index axes that ends with the one across keeps their handedness.
  placed.column_is_x = placed.column_axis == (placed.across + 1) % 3;
  const bool left_handed = handedness(header) == Sign::negative;
  auto& [x, y, z] = placed.frame.axes;
  placed.column = along(placed.column_axis, left_handed, placed.column_is_x ? x : y);
  placed.row = along(placed.row_axis, false, placed.column_is_x ? y : x);
  placed.height = along(placed.across, false, z);
  placed.frame.origin = {header.matrix[0][3], header.matrix[1][3], header.matrix[2][3]};
}

// From a pixel before the first to one behind the last: whether centres, the places where contours
// turn and the ends of those where they may pass between centres are all different and in order.
bool tells_apart(const IndexedCoordinate& coordinate, std::size_t size) {
  constexpr std::array<double, 6> kPlaces{0,    Slice::kLeastShare,    0.25, 0.5,
                                          0.75, 1 - Slice::kLeastShare};
  const double end = static_cast<double>(size);
  double before = coordinate.at(-1);
  for (double index = -1; index <= end; ++index) {
    for (const double place : kPlaces) {
      const double now = coordinate.at(index + place);
      if (!(std::abs(now) < kLargestCoordinate)) return false;
      const bool first = index == -1 && place == 0;
      if (!first && !(coordinate.step > 0 ? now > before : now < before)) return false;
      before = now;
    }
  }
  return true;
}

}  // namespace

Result<void> check_matrix(const VolumeHeader& header, const std::string& field,
                          const std::string& name) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (const double entry : header.matrix[row]) {
      if (!(std::abs(entry) < kLargestCoordinate)) {
        return volume_error(name, field + " has a number that is not finite, or too large");
      }
    }
  }
  if (handedness(header) != Sign::zero) return {};
  return volume_error(name, field + " is singular: the axes of the volume lie in one plane");
}

Result<SlicePlacement> place_slices(const VolumeHeader& header, std::size_t across,
                                    const std::string& name) {
  SlicePlacement placed;
  placed.across = across;
  placed.column_axis = across == 0 ? 1 : 0;
  placed.row_axis = across == 2 ? 1 : 2;
  if (const auto world = world_axes(header)) {
    place_along_world(header, *world, placed);
  } else {
    place_along_indices(header, placed);
  }
  const std::array<std::pair<const IndexedCoordinate*, std::size_t>, 3> all{
      {{&placed.column, placed.column_axis},
       {&placed.row, placed.row_axis},
       {&placed.height, placed.across}}};
  for (const auto& [coordinate, axis] : all) {
    if (tells_apart(*coordinate, header.size[axis])) continue;
    std::string message = "double precision does not tell the voxels along axis " +
                          std::to_string(axis) + " apart: they are ";
    append_number(message, coordinate->step);
    message += " from each other, and begin at ";
    append_number(message, coordinate->origin);
    return volume_error(name, message);
  }
  return placed;
}

}  // namespace tetloft::internal::io
