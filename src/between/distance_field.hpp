// The signed distances of a class in one section, at any place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/distance_samples.hpp"
#include "motion/lattice_window.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

/// What distances in a box are: `far` outside or inside everywhere, or something else.
enum class Depth : std::uint8_t { far_outside, far_inside, near };

/// Between samples distances are bilinear; beyond them all is far outside.
class DistanceField {
 public:
  /// Of nothing.
  explicit DistanceField(double far = 0) : far_(far) {}
  /// Of samples from −far to far, a step at least.
  DistanceField(motion::DistanceSamples samples, double far);

  /// The samples (i, j) of a row with i0 ≤ i < i1: of the field's own, or put together in `row`.
  [[nodiscard]] const double* row(std::int64_t i0, std::int64_t i1, std::int64_t j,
                                  std::vector<double>& row) const;

  /// What at() can be in the box; `near` where that is not certain.
  [[nodiscard]] Depth depth(const Box2& box) const;
  /// Is sampled().at() all the same as at() there?
  [[nodiscard]] bool samples_all(const Box2& box) const;

  [[nodiscard]] double at(double x, double y) const {
    return is_sampled(x - x0_, y - y0_) ? sampled().at(x, y) : far_;
  }
  /// The field where samples lie around a place, in few numbers.
  struct Sampled {
    const double* value;
    std::int64_t nx;
    double x0, y0;
    [[nodiscard]] double at(double x, double y) const {
      const double on_x = x - x0;
      const double on_y = y - y0;
      const auto i = static_cast<std::int64_t>(on_x);
      const auto j = static_cast<std::int64_t>(on_y);
      const double fx = on_x - static_cast<double>(i);
      const double fy = on_y - static_cast<double>(j);
      const double* const low = value + j * nx + i;
      const double* const high = low + nx;
      const double a = low[0] + fx * (low[1] - low[0]);
      const double b = high[0] + fx * (high[1] - high[0]);
      return a + fy * (b - a);
    }
  };
  [[nodiscard]] Sampled sampled() const { return {samples_.value.data(), nx_, x0_, y0_}; }

 private:
  // From the first sample on.
  [[nodiscard]] bool is_sampled(double on_x, double on_y) const {
    return on_x >= 0 && on_y >= 0 && on_x < last_x_ && on_y < last_y_;
  }

  motion::DistanceSamples samples_;
  double far_ = 0;
  // Of the samples: the first and, from there on, the last, which is none to the left of others.
  double x0_ = 0, y0_ = 0, last_x_ = 0, last_y_ = 0;
  std::int64_t nx_ = 0;
};

}  // namespace tetloft::internal::between
