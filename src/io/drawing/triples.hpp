// Points as DICOM writes them, and what mirrors it: x\y\z\x\y\z…
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::io {

struct Triples {
  std::vector<Point3> points;
  std::string wrong;  ///< what is; empty: nothing
};

/// Blanks and zeros around values are padding, and separators behind the last value are none.
[[nodiscard]] Triples triples_of(std::string_view text);

/// `value` without the blanks and zeros at its ends, which only pad it.
[[nodiscard]] std::string_view without_padding(std::string_view value);

}  // namespace tetloft::internal::io
