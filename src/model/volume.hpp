// The volume of a model, on several threads; and what it is made of, for models that are not in
// memory.
#pragma once

#include <array>
#include <cmath>

#include <tetloft/model.hpp>

namespace tetloft::internal {

/// tetloft::volume(), the same at any number of threads (0: as many as the machine offers).
[[nodiscard]] double volume_of(const Model& model, unsigned threads);

/// Of a tet whose coordinates are multiplied by 2^exponent. The volume of a model is the sum over
/// its tets in order, with UnitOfLength::largest_to_one() of the points they use, times
/// 2^(−3 exponent), times volume_factor() of its frame.
[[nodiscard]] double scaled_volume(const std::array<Point3, 4>& corners, int exponent);

/// Neumaier's: a stack has many tets far smaller than the whole.
class CompensatedSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::fabs(sum_) >= std::fabs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

}  // namespace tetloft::internal
