// validate() as a part of longer work.
#pragma once

#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

#include "core/watched_work.hpp"

namespace tetloft::internal::sections {

/// validate() that tells a step of `work` for each section, and the nestings that it finds on the
/// way. Throws what its steps throw.
[[nodiscard]] Result<IdVector<SectionId, Nesting>> nest_if_valid(const SectionStack& stack,
                                                                 WatchedWork& work);
/// The same without nestings: validate() that tells a step of `work` for each section.
[[nodiscard]] Result<void> validate_within(const SectionStack& stack, WatchedWork& work);

}  // namespace tetloft::internal::sections
