// Which options of correspondence make sense: one rule for all who take them.
#pragma once

#include <tetloft/correspondence.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

/// Of areas, as `tau` and `drift` are: in [0, 1).
[[nodiscard]] bool is_overlap_ratio(double value);

/// Usage error for a criterion that there is none of, for ratios that are not in [0, 1), and for
/// drift without the overlap criterion. Labels are input, and looked at with the sections.
[[nodiscard]] Result<void> check_correspondence_options(const CorrespondenceOptions& options);

}  // namespace tetloft
