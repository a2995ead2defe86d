// A slice of a volume as contours are traced in it: which pixels are in the region, and their
// values where these say how far the contour is from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetloft::internal::io {

/// Which voxels are in the region: those of a label, or those of at least an iso-value. A value
/// that is no number is in none.
struct RegionRule {
  double label = 0;
  std::optional<double> iso;
  [[nodiscard]] bool holds(double value) const { return iso ? value >= *iso : value == label; }
};

/// Pixels come row by row; memory grows with those that have come. What lies outside is not in the
/// region.
class Slice {
 public:
  Slice(std::size_t width, std::size_t height, const RegionRule& rule)
      : width_(width), height_(height), rule_(rule) {}

  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::size_t height() const { return height_; }
  [[nodiscard]] bool empty() const { return inside_ == 0; }

  /// Forgets all pixels; the next is the first.
  void clear() {
    marks_.clear();
    values_.clear();
    inside_ = 0;
  }
  /// The next pixels, within one row.
  void append(std::span<const double> values);
  [[nodiscard]] bool full() const { return marks_.size() == stride() * height_; }

  // Pixels by their place: row · stride() + column. Places outside may wrap around.
  [[nodiscard]] std::size_t stride() const { return width_ + 1; }
  [[nodiscard]] bool inside(std::size_t place) const {
    return place < marks_.size() && (marks_[place] & kInside) != 0;
  }
  [[nodiscard]] bool passed(std::size_t place) const { return (marks_[place] & kPassed) != 0; }
  void pass(std::size_t place) { marks_[place] |= kPassed; }

  /// Where between two neighbours the contour passes, from the one inside: 0 is its centre, 1 that
  /// of the other. For a label, and at the border of the slice, half way; for an iso-value where it
  /// would be reached if values changed linearly, at least kLeastShare and at most 1 − kLeastShare,
  /// so that contours neither meet at a centre nor crowd around it.
  [[nodiscard]] double share(std::size_t inner, std::size_t outer) const;
  static constexpr double kLeastShare = 0x1p-8;

 private:
  static constexpr std::uint8_t kInside = 1;
  static constexpr std::uint8_t kPassed = 2;

  /// The value at a place, or none outside.
  [[nodiscard]] const double* value(std::size_t place) const;

  std::size_t width_;
  std::size_t height_;
  RegionRule rule_;
  /// A column more than the slice has, never inside: it parts the end of a row from the next.
  std::vector<std::uint8_t> marks_;
  std::vector<double> values_;  ///< by the same places; empty unless there is an iso-value
  std::size_t inside_ = 0;
};

}  // namespace tetloft::internal::io
