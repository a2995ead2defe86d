// What is said of a guarantee that fails.
#pragma once

#include <string>

#include <tetloft/check.hpp>

namespace tetloft::cli {

/// "guarantee 2 (re-sampling): what fails, 3 times, first at …". Requires a verdict that fails.
[[nodiscard]] std::string describe(const GuaranteeVerdict& verdict, const CheckFailure& failure);

}  // namespace tetloft::cli
