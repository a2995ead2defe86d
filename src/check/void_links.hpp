// Which voids belong together, recomputed by the rule in tetloft/voids.hpp. Written for `check`
// alone, as partition.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tetloft/result.hpp>
#include <tetloft/voids.hpp>

#include "check/stack_voids.hpp"

namespace tetloft::internal::checking {

/// Two voids of one slab, be it of the same section.
struct SlabVoids {
  std::size_t slab = 0;
  Link voids;
  friend auto operator<=>(const SlabVoids&, const SlabVoids&) = default;
};

struct ExpectedVoids {
  /// The links of voids, as of StackVoids::voids(), that were accepted, sorted. Those of exteriors
  /// are among them.
  std::vector<Link> links;
  std::vector<SlabVoids> forced;            ///< as the model says; sorted
  std::optional<std::uint32_t> unrealised;  ///< a label of holes that cannot be realised
  // What the model says of V6, as far as that may be; and what of it may not, in words.
  std::size_t unrealisable = 0;
  std::vector<std::string> wrong;
};

/// The whole rule, but for VoidRule::free; `faces` are those of the stack, `of_regions` the
/// accepted links of regions, sorted. Refused (invalid_input) where labels or decisions name no
/// void or contradict each other.
[[nodiscard]] Result<ExpectedVoids> expected_voids(const StackVoids& stack,
                                                   const std::vector<Faces>& faces,
                                                   const std::vector<Link>& of_regions,
                                                   const VoidOptions& options,
                                                   std::span<const VoidLink> claims);

}  // namespace tetloft::internal::checking
