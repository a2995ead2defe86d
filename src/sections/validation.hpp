// validate() as a part of longer work.
#pragma once

#include <utility>

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

/// For those who have the nestings of nest_if_valid(), and the stack as it was then.
struct ValidStackMaker {
  [[nodiscard]] static ValidStack make(SectionStack stack, IdVector<SectionId, Nesting> nestings) {
    return {std::move(stack), std::move(nestings)};
  }
};

}  // namespace tetloft::internal::sections
