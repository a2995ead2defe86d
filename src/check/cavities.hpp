// Guarantee 5: cavities and tunnels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "check/components.hpp"
#include "check/expected_topology.hpp"
#include "check/findings.hpp"
#include "check/topology.hpp"
#include "check/void_links.hpp"

namespace tetloft::internal::checking {

/// What follows from the sections, and from what the model says of V6.
struct ExpectedCavities {
  ExpectedVoids voids;
  std::vector<SlabTopology> slabs;
  std::vector<std::size_t> void_set;  ///< of each void, over the stack
  std::size_t cavities = 0;
  ChiRange genus;  ///< of all boundary surfaces, in sum: between what
};

/// Refused (invalid_input) where labels or decisions on voids are.
[[nodiscard]] Result<ExpectedCavities> expected_cavities(const StackVoids& stack,
                                                         const VoidOptions& options,
                                                         std::span<const VoidLink> claims,
                                                         const Components::Expected& components);

/// Conditions 5.1 to 5.9 of README.md, of a model with these parts, whose regions are sorted.
/// Requires that guarantees 1, 2 and 4 hold.
[[nodiscard]] Findings check_cavities(std::span<const SlabPart> parts, const StackVoids& stack,
                                      const ModelVoids& voids, const ExpectedCavities& expected,
                                      std::span<const Deviation> listed,
                                      const CheckOptions& options);

/// Of no failures, to say that nothing was asked.
[[nodiscard]] Findings no_cavities_asked();

}  // namespace tetloft::internal::checking
