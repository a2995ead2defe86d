#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "check/findings.hpp"
#include "check/regions.hpp"
#include "check/resampling.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

struct Components {
  Findings findings;
  std::size_t dropped_links = 0;
  /// What the correspondence is, where it can be recomputed.
  struct Expected {
    std::vector<Link> links;  ///< those accepted, sorted
    std::size_t components = 0;
  };
  std::optional<Expected> expected = std::nullopt;
};

/// Guarantee 4, conditions 4.1 to 4.8 of README.md: the face-connected components of the
/// model part the contours as the correspondence says. Refused where labels are invalid.
[[nodiscard]] Result<Components> check_components(const ModelView& view, const SectionStack& stack,
                                                  const Resampling& resampling,
                                                  const CheckOptions& options);

}  // namespace tetloft::internal::checking
