// A bar of a round length.
#pragma once

#include <string>
#include <string_view>

#include <tetloft/point.hpp>

namespace tetloft::internal::report {

/// Part of an <svg>: a bar from `at` to the right, at most `room` long, and above it what it
/// stands for. `scale`: units of the drawing for a unit of length; `pixel`: for a pixel.
[[nodiscard]] std::string scale_bar(const Point2& at, double room, double scale,
                                    std::string_view unit, double pixel);

}  // namespace tetloft::internal::report
