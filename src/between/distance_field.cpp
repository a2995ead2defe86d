#include "between/distance_field.hpp"

#include <algorithm>
#include <utility>

namespace tetloft::internal::between {

namespace {

// Samples of a tile along each axis, as a power of two.
constexpr std::size_t kTileBits = 3;

Depth depth_of(double value, double far) {
  if (value == far) return Depth::far_outside;
  return value == -far ? Depth::far_inside : Depth::near;
}

}  // namespace

DistanceField::DistanceField(motion::DistanceSamples samples, double far)
    : samples_(std::move(samples)), far_(far) {
  const motion::LatticeWindow& w = samples_.window;
  x0_ = static_cast<double>(w.i0);
  y0_ = static_cast<double>(w.j0);
  last_x_ = static_cast<double>(w.i1 - w.i0 - 1);
  last_y_ = static_cast<double>(w.j1 - w.j0 - 1);
  nx_ = w.i1 - w.i0;
}

void DistanceField::find_depths() {
  const std::size_t nx = samples_.window.nx();
  const std::size_t ny = samples_.window.ny();
  const double* const value = samples_.value.data();
  tiles_ = (nx >> kTileBits) + 1;
  depths_.resize(tiles_ * ((ny >> kTileBits) + 1));
  for (std::size_t j = 0; j < ny; ++j) {
    const double* const row = value + j * nx;
    Depth* const of_row = depths_.data() + (j >> kTileBits) * tiles_;
    for (std::size_t first = 0; first < nx; first += std::size_t{1} << kTileBits) {
      Depth& depth = of_row[first >> kTileBits];
      const std::size_t end = std::min(first + (std::size_t{1} << kTileBits), nx);
      if (j % (std::size_t{1} << kTileBits) == 0) depth = depth_of(row[first], far_);
      if (depth == Depth::near) continue;
      const double same = depth == Depth::far_outside ? far_ : -far_;
      if (!std::all_of(row + first, row + end, [=](double v) { return v == same; })) {
        depth = Depth::near;
      }
    }
  }
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
  if (depths_.empty() || !(i0 <= i1 && j0 <= j1)) return Depth::far_outside;
  const auto tile_of = [](double at) { return static_cast<std::size_t>(at) >> kTileBits; };
  const Depth depth =
      samples_all(box) ? depths_[tile_of(j0) * tiles_ + tile_of(i0)] : Depth::far_outside;
  for (std::size_t j = tile_of(j0); j <= tile_of(j1); ++j) {
    for (std::size_t i = tile_of(i0); i <= tile_of(i1); ++i) {
      if (depths_[j * tiles_ + i] != depth) return Depth::near;
    }
  }
  return depth;
}

}  // namespace tetloft::internal::between
