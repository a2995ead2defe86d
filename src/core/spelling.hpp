// "Did you mean …?": the word of a few that was probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tetloft::internal {

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b` (Damerau's
/// distance, each place edited once).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, case set aside: one that it begins or spells with at most one
/// slip in three letters; the first of equals. Empty where none is that close.
[[nodiscard]] std::string_view closest(std::string_view word,
                                       const std::vector<std::string_view>& candidates);

/// " (did you mean --overlap?)", or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string_view>& candidates);

/// "a, b or c".
[[nodiscard]] std::string list_of(const std::vector<std::string_view>& words);

}  // namespace tetloft::internal
