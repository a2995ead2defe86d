// Between two sections: the cubic through the values of four at one place.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "between/class_shape.hpp"

namespace tetloft::internal::between {

/// How the sections beside a slab lie, and whether the class goes on in them.
struct Beside {
  /// Distance from the slab, in gaps; none where the stack ends.
  std::optional<double> behind, beyond;
  /// The class is in the lower section but not behind it, in the upper one but not beyond.
  bool ends_behind = false, ends_beyond = false;
};

/// The cubic Hermite polynomial at one share of the gap. Its slopes at both sections are those of
/// parabolas through three neighbours, but for how far they leave the chord: kBend times as far,
/// and less where the third is nearer than a gap.
class SectionCubic {
 public:
  SectionCubic(double share, const Beside& beside)
      : share_(share),
        at_lower_(kBend * (share * ((1 - share) * (1 - share)))),
        at_upper_(kBend * ((1 - share) * (share * share))),
        beside_(beside),
        far_behind_(beside.behind.value_or(1)),
        far_beyond_(beside.beyond.value_or(1)),
        trust_behind_(reach(far_behind_) / (1 + far_behind_)),
        trust_beyond_(reach(far_beyond_) / (1 + far_beyond_)) {}

  /// The value between; p of a missing section is not looked at.
  [[nodiscard]] double at(const std::array<double, 4>& p) const {
    return at<1>({&p[behind], &p[lower], &p[upper], &p[beyond]})[0];
  }
  /// At n places side by side, step by step for all of them: so that several fit into a register.
  template <std::size_t n>
  [[nodiscard]] std::array<double, n> at(const std::array<const double*, 4>& p) const {
    std::array<double, n> value;
    std::array<double, n> chord;
    std::array<double, n> from_lower{};
    std::array<double, n> from_upper{};
    for (std::size_t k = 0; k < n; ++k) chord[k] = p[upper][k] - p[lower][k];
    if (beside_.behind) {
      for (std::size_t k = 0; k < n; ++k) {
        from_lower[k] = ((p[lower][k] - p[behind][k]) / far_behind_ - chord[k]) * trust_behind_;
      }
    }
    // What ends there is round there: a section beyond the end tells little of the slope.
    if (beside_.behind && beside_.ends_behind) {
      for (std::size_t k = 0; k < n; ++k) from_lower[k] = std::min(from_lower[k], chord[k]);
    }
    if (beside_.beyond) {
      for (std::size_t k = 0; k < n; ++k) {
        from_upper[k] = ((p[beyond][k] - p[upper][k]) / far_beyond_ - chord[k]) * trust_beyond_;
      }
    }
    if (beside_.beyond && beside_.ends_beyond) {
      for (std::size_t k = 0; k < n; ++k) from_upper[k] = std::max(from_upper[k], chord[k]);
    }
    // At the end of the stack the parabola of the other three goes on.
    if (!beside_.behind) {
      for (std::size_t k = 0; k < n; ++k) from_lower[k] = -from_upper[k];
    }
    if (!beside_.beyond) {
      for (std::size_t k = 0; k < n; ++k) from_upper[k] = -from_lower[k];
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double straight = (1 - share_) * p[lower][k] + share_ * p[upper][k];
      value[k] = straight + (at_lower_ * from_lower[k] - at_upper_ * from_upper[k]);
    }
    return value;
  }

 private:
  static constexpr double kBend = 1.5;
  /// A slope told over a short way says as little of a long one.
  [[nodiscard]] static double reach(double far) { return std::min(far, 1.0); }

  double share_;
  double at_lower_, at_upper_;
  Beside beside_;
  // Distances from the slab, in gaps, and how much is thought of the slopes told over them.
  double far_behind_, far_beyond_;
  double trust_behind_, trust_beyond_;
};

}  // namespace tetloft::internal::between
