// validate() as a part of longer work.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/valid_stack.hpp>

#include "core/watched_work.hpp"

namespace tetloft::internal::sections {

/// validate() that tells a step of `work` for each section, and the nestings that it finds on the
/// way. Throws what its steps throw.
[[nodiscard]] Result<IdVector<SectionId, Nesting>> nest_if_valid(const SectionStack& stack,
                                                                 WatchedWork& work);
/// The same without nestings: validate() that tells a step of `work` for each section.
[[nodiscard]] Result<void> validate_within(const SectionStack& stack, WatchedWork& work);

/// validate() of one section: its nesting, or its first defect, as of section `s` of its stack. How
/// high it lies is not looked at.
[[nodiscard]] Result<Nesting> nest_section_if_valid(const Section& section, std::size_t s);
/// Why the height of section `s` is none, or not above the one below; of all sections, or as many
/// as are known, for the remedy.
[[nodiscard]] std::optional<Error> height_error(const std::vector<double>& heights, std::size_t s);
[[nodiscard]] Error no_section_error();
/// Of a stack whose sections all are empty.
[[nodiscard]] Error no_contour_error();

/// For those who have the nestings of nest_if_valid(), and the stack as it was then.
struct ValidStackMaker {
  [[nodiscard]] static ValidStack make(SectionStack stack, IdVector<SectionId, Nesting> nestings) {
    return {std::move(stack), std::move(nestings)};
  }
};

}  // namespace tetloft::internal::sections
