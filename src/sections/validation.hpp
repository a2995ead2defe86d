// validate() as a part of longer work.
#pragma once

#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

#include "core/watched_work.hpp"

namespace tetloft::internal::sections {

/// validate() that tells a step of `work` for each section. Throws what its steps throw.
[[nodiscard]] Result<void> validate_within(const SectionStack& stack, WatchedWork& work);

}  // namespace tetloft::internal::sections
