// What is said of a guarantee that fails.
#pragma once

#include <string>
#include <vector>

#include <tetloft/check.hpp>

#include "cli/json.hpp"

namespace tetloft::cli {

/// "guarantee 2 (re-sampling): what fails, 3 times, first at …". Requires a verdict that fails.
[[nodiscard]] std::string describe(const GuaranteeVerdict& verdict, const CheckFailure& failure);

/// "check failed: guarantee 2 (re-sampling), 4 (components)". Requires one that fails.
[[nodiscard]] std::string failed_guarantees(const std::vector<GuaranteeVerdict>& verdicts);

/// A member "failures": objects with what, count and places.
void write_failures(JsonWriter& json, const std::vector<CheckFailure>& failures);

}  // namespace tetloft::cli
