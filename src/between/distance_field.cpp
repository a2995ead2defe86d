#include "between/distance_field.hpp"

#include <algorithm>
#include <utility>

namespace tetloft::internal::between {

using motion::DistanceSamples;

DistanceField::DistanceField(motion::DistanceSamples samples, double far)
    : samples_(std::move(samples)), far_(far) {
  const motion::LatticeWindow& w = samples_.window;
  x0_ = static_cast<double>(w.i0);
  y0_ = static_cast<double>(w.j0);
  last_x_ = static_cast<double>(w.i1 - w.i0 - 1);
  last_y_ = static_cast<double>(w.j1 - w.j0 - 1);
  nx_ = w.i1 - w.i0;
}

const double* DistanceField::row(std::int64_t i0, std::int64_t i1, std::int64_t j,
                                 std::vector<double>& row) const {
  const motion::LatticeWindow& w = samples_.window;
  const bool has_row = w.j0 <= j && j < w.j1;
  if (has_row && w.i0 <= i0 && i1 <= w.i1) return samples_.at(i0, j);
  row.assign(static_cast<std::size_t>(i1 - i0), far_);
  const std::int64_t first = std::max(i0, w.i0);
  const std::int64_t end = std::min(i1, w.i1);
  if (has_row && first < end) {
    const double* const from = samples_.at(first, j);
    std::copy(from, from + (end - first), row.begin() + (first - i0));
  }
  return row.data();
}

bool DistanceField::samples_all(const Box2& box) const {
  return is_sampled(box.x0 - x0_, box.y0 - y0_) && is_sampled(box.x1 - x0_, box.y1 - y0_);
}

Depth DistanceField::depth(const Box2& box) const {
  const double i0 = std::max(box.x0 - x0_, 0.0);
  const double j0 = std::max(box.y0 - y0_, 0.0);
  // At a place there are the samples on both sides.
  const double i1 = std::min(box.x1 - x0_ + 1, last_x_);
  const double j1 = std::min(box.y1 - y0_ + 1, last_y_);
  if (samples_.near.empty() || !(i0 <= i1 && j0 <= j1)) return Depth::far_outside;
  const auto tile_of = [](double at) {
    return static_cast<std::size_t>(static_cast<std::int64_t>(at)) / DistanceSamples::kTile;
  };
  // Whatever is near lies in a tile that is so: elsewhere all of the box is on one side.
  const std::size_t tiles = samples_.tiles_in_row();
  for (std::size_t j = tile_of(j0); j <= tile_of(j1); ++j) {
    for (std::size_t i = tile_of(i0); i <= tile_of(i1); ++i) {
      if (samples_.near[j * tiles + i] != 0) return Depth::near;
    }
  }
  const double first = samples_.value[static_cast<std::size_t>(static_cast<std::int64_t>(j0) * nx_ +
                                                               static_cast<std::int64_t>(i0))];
  if (first == far_) return Depth::far_outside;
  return samples_all(box) ? Depth::far_inside : Depth::near;
}

}  // namespace tetloft::internal::between
