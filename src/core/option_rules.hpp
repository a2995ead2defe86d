// Which options make sense: one rule for all who take them, the command line included.
#pragma once

#include <cstddef>

#include <tetloft/correspondence.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal {

/// Of areas, as `tau` is: in [0, 1).
[[nodiscard]] bool is_overlap_ratio(double value);
/// Of VoidOptions: finite, not negative.
[[nodiscard]] bool is_void_reach(double value);
/// Of tets per vertex: above 0; infinity is none.
[[nodiscard]] bool is_work_limit(double value);
/// Thicknesses, distances: positive and finite.
[[nodiscard]] bool is_length(double value);

/// The most sections put between two.
inline constexpr std::size_t kMostBetween = 64;

/// The bits that snap() takes.
inline constexpr int kFewestSnapBits = 1;
inline constexpr int kMostSnapBits = 50;

/// Usage error for a criterion or rule that there is none of, for ratios that are not in [0, 1), a
/// reach that is none, and for labels or decisions on free voids. Others are input, and looked at
/// with the sections.
[[nodiscard]] Result<void> check_correspondence_options(const CorrespondenceOptions& options);
/// Usage error where it is none.
[[nodiscard]] Result<void> check_work_limit(double value);
/// Usage error for more than kMostBetween.
[[nodiscard]] Result<void> check_between(std::size_t count);
/// Usage error naming `what`, where it is none.
[[nodiscard]] Result<void> check_length(double value, const char* what);

}  // namespace tetloft::internal
