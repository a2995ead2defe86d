// Numbers of any precision as doubles.
#pragma once

#include "arithmetic/double_double.hpp"
#include "arithmetic/expansion.hpp"

namespace tetloft::internal {

[[nodiscard]] inline double rounded_sum(double value) { return value; }
[[nodiscard]] inline double rounded_sum(const DoubleDouble& value) { return value.high; }
/// Components summed from the smallest: within two ulps of the exact value.
template <int Capacity>
[[nodiscard]] double rounded_sum(const Expansion<Capacity>& e) {
  double sum = 0;
  for (int i = 0; i < e.size(); ++i) sum += e[i];
  return sum;
}

}  // namespace tetloft::internal
