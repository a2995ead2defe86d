// Units of length by the names that files give them.
#pragma once

#include <optional>
#include <string_view>

namespace tetloft::internal::io {

/// How many metres it is: "mm", "in", … (Description::unit), or the word in full, in either case.
/// None if it is not known.
[[nodiscard]] std::optional<double> metres_in(std::string_view unit);

}  // namespace tetloft::internal::io
