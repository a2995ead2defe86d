// Smoothing of values on a lattice, along one axis after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetloft::internal::between {

/// Weights (1 − (k/r)²)² at |k| < r, of sum 1: near a Gaussian, without exp.
class Smoother {
 public:
  /// What lies around the values: zeros, or the values of the border.
  enum class Outside : std::uint8_t { zero, border };

  /// `sigma` is in samples: r = √7 sigma, the variance of the weights as of a continuous function.
  Smoother(double sigma, Outside outside);

  /// Values farther away along an axis do not count.
  [[nodiscard]] std::int64_t reach() const { return static_cast<std::int64_t>(weight_.size()) - 1; }
  /// Smooths nx × ny values, row by row.
  void smooth(std::vector<double>& value, std::size_t nx, std::size_t ny);

 private:
  void smooth_rows(std::vector<double>& value, std::size_t nx, std::size_t ny);
  void smooth_columns(std::vector<double>& value, std::size_t nx, std::size_t ny);

  std::vector<double> weight_;  // of the sample itself, of those beside it, and so on
  Outside outside_;
  std::vector<double> line_, rows_;
};

}  // namespace tetloft::internal::between
