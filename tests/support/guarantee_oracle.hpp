// Guarantees 1 to 4 by brute force: sets and rational arithmetic, quadratic, for small
// models. Shares no code with the library but its value types, and tests each guarantee
// directly where the library proves it: tets are intersected in pairs, areas added up.
#pragma once

#include <array>
#include <optional>
#include <string>

#include <tetloft/check.hpp>
#include <tetloft/model.hpp>
#include <tetloft/sections.hpp>

namespace tetloft::oracle {

struct GuaranteeVerdicts {
  /// holds[g − 1]: guarantee g. Without value where it makes no sense to ask: nothing but 1
  /// and 3 of a model with malformed tets or coordinates that are not finite, and not 4 for
  /// `reverse`.
  std::array<std::optional<bool>, 4> holds;
  std::string reasons;  ///< what was found wrong, a line each
};

/// Requires a valid stack, and labels and decisions that check() does not refuse.
[[nodiscard]] GuaranteeVerdicts guarantees(const Model& model, const SectionStack& stack,
                                           const CheckOptions& options = {});

}  // namespace tetloft::oracle
