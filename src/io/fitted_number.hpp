// Numbers in fields of a width: decks of Fortran programs, which cut off what is longer.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

/// Of at most `width` characters (12 at least) the decimal number nearest to `value`, which is
/// finite; with a point and an exponent behind E, if any, as decks ask for reals. The shortest
/// digits that read back where they fit.
[[nodiscard]] std::string fitted_number(double value, std::size_t width);

/// The coordinates of one file, of such fields.
class FittedCoordinates {
 public:
  explicit FittedCoordinates(std::size_t width) : width_(width) {}

  [[nodiscard]] std::string text_of(double coordinate);
  /// A warning where some did not read back to the same bits, with the largest difference.
  [[nodiscard]] std::vector<Warning> warnings() const;

 private:
  std::size_t width_;
  std::size_t count_ = 0;
  std::size_t rounded_ = 0;
  double largest_ = 0;  // difference
};

}  // namespace tetloft::internal::io
