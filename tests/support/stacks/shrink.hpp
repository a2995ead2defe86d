// Reduces a failing stack to a minimal one, after Zeller and Hildebrandt, "Simplifying and
// isolating failure-inducing input" (IEEE TSE 28, 2002).
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <tetloft/result.hpp>
#include <tetloft/sections.hpp>

#include "support/stacks/generate.hpp"

namespace tetloft::testing {

struct ShrinkLimits {
  std::size_t trials = 2000;  ///< calls of the predicate at most
};

/// Removes sections, contours and vertices and rounds coordinates, as long as the stack
/// stays valid and `still_fails` holds, until nothing of this can be done any more or the
/// trials are used up. Labels follow the contours that they are on. Deterministic.
/// Requires: the stack is valid and still_fails(it). The result is both too.
[[nodiscard]] GeneratedStack shrink(const GeneratedStack& failing,
                                    const std::function<bool(const GeneratedStack&)>& still_fails,
                                    ShrinkLimits limits = {});

/// The same without labels.
[[nodiscard]] SectionStack shrink(const SectionStack& failing,
                                  const std::function<bool(const SectionStack&)>& still_fails,
                                  ShrinkLimits limits = {});

/// Writes FOLDER/NAME.cnt and, if there are labels, FOLDER/NAME.labels.
[[nodiscard]] Result<void> write_stack(const std::string& folder, const std::string& name,
                                       const GeneratedStack& generated);

}  // namespace tetloft::testing
