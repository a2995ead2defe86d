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
        beside_(beside) {}

  /// The value between; p of a missing section is not looked at.
  [[nodiscard]] double at(const std::array<double, 4>& p) const {
    const double chord = p[upper] - p[lower];
    double from_lower = 0;
    double from_upper = 0;
    if (beside_.behind) {
      const double far = *beside_.behind;
      from_lower = ((p[lower] - p[behind]) / far - chord) * (reach(far) / (1 + far));
      // What ends there is round there: a section beyond the end tells little of the slope.
      if (beside_.ends_behind) from_lower = std::min(from_lower, chord);
    }
    if (beside_.beyond) {
      const double far = *beside_.beyond;
      from_upper = ((p[beyond] - p[upper]) / far - chord) * (reach(far) / (1 + far));
      if (beside_.ends_beyond) from_upper = std::max(from_upper, chord);
    }
    // At the end of the stack the parabola of the other three goes on.
    if (!beside_.behind) from_lower = -from_upper;
    if (!beside_.beyond) from_upper = -from_lower;
    const double straight = (1 - share_) * p[lower] + share_ * p[upper];
    return straight + (at_lower_ * from_lower - at_upper_ * from_upper);
  }

 private:
  static constexpr double kBend = 1.5;
  /// A slope told over a short way says as little of a long one.
  [[nodiscard]] static double reach(double far) { return std::min(far, 1.0); }

  double share_;
  double at_lower_, at_upper_;
  Beside beside_;
};

}  // namespace tetloft::internal::between
