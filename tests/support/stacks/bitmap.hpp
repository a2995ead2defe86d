// Bitmaps and their outlines: contours as segmentation tools make them, on a lattice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/prng.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

using namespace internal;

class Bitmap {
 public:
  Bitmap(int width, int height) : width_(width), height_(height), pixels_(size()) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Outside the bitmap everything is background.
  [[nodiscard]] bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_ && pixels_[index(x, y)] != 0;
  }
  void set(int x, int y, bool value) { pixels_[index(x, y)] = value ? 1 : 0; }

 private:
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<std::uint8_t> pixels_;
};

/// Pixels set with probability `density`, then `smoothing` rounds of majority vote.
[[nodiscard]] Bitmap random_bitmap(Prng& prng, int width, int height, double density,
                                   int smoothing);

/// Flips each pixel with probability p.
[[nodiscard]] Bitmap flipped(Prng& prng, const Bitmap& bitmap, double p);

/// Sets pixels until no two set pixels meet at a corner only: then the outlines along
/// pixel sides do not touch.
[[nodiscard]] Bitmap without_diagonals(Bitmap bitmap);

/// Outlines that cross each lattice edge between a set and an unset pixel once, at the
/// point that `place` says for it: x2 and y2 are the sums of the two pixels' coordinates,
/// so that the midpoint is (x2, y2) / 2. At an ambiguous cell the set pixels are joined or
/// parted; either way no outlines touch as long as places stay inside their lattice edges.
[[nodiscard]] Layer marching_squares(const Bitmap& bitmap, bool join_diagonals,
                                     const std::function<Point2(int x2, int y2)>& place);
/// With all places at midpoints: vertices on half-integers.
[[nodiscard]] Layer marching_squares(const Bitmap& bitmap, bool join_diagonals);

/// Outlines along pixel sides, with or without the vertices inside straight runs.
/// Requires: no two set pixels meet at a corner only.
[[nodiscard]] Layer staircase(const Bitmap& bitmap, bool merge_collinear);

}  // namespace tetloft::testing
