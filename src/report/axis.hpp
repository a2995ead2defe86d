// Axes of plots: round ticks, and where values stand.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tetloft::internal::report {

struct Tick {
  double value = 0;
  std::string label;
};

enum class Scale { linear, logarithmic };

/// An interval that holds all values to be shown, and its ticks.
class Axis {
 public:
  /// From `low` to `high`, or a little around where these are equal; widened to ticks where
  /// `to_ticks`. Takes any finite numbers; logarithmic ones must be positive, and stand linearly
  /// where the interval is too short for ticks at 1, 2 and 5. About `wanted` ticks.
  Axis(double low, double high, Scale scale, std::size_t wanted, bool to_ticks);

  /// 0 at the low end, 1 at the high one; values beyond are at the ends.
  [[nodiscard]] double position(double value) const;
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

 private:
  void make_linear_ticks(std::size_t wanted, bool to_ticks);
  void make_logarithmic_ticks(std::size_t wanted);

  double low_, high_;
  Scale scale_;
  std::vector<Tick> ticks_;
};

/// Narrow spaces (U+202F) between the thousands of the first `whole` characters.
void group_thousands(std::string& digits, std::size_t whole);

/// The largest of 1, 2 and 5 times a power of ten up to `length`. Requires it positive and finite.
[[nodiscard]] double round_down(double length);

/// `value` with so many significant digits, as people write it: "1234.5", "0.02", "3.1·10⁻⁹",
/// "12 345" with narrow spaces (U+202F).
[[nodiscard]] std::string number_text(double value, int digits = 5);

}  // namespace tetloft::internal::report
