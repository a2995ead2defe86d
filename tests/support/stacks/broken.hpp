// Random stacks that need mending, with how, and what must come of it. None of them is valid as it
// is; a stack is a function of its kind and seed, as in generate.hpp.
#pragma once

#include <cstdint>
#include <optional>

#include <tetloft/repair.hpp>

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;

enum class BrokenKind : std::uint8_t {
  overlaps,  ///< traces that overlap, with holes, by any fill rule
  copies,    ///< contours that stand twice, or again with fewer digits
  keyholes,  ///< holes cut to the outline by channels, none, little or one voxel wide
  planes,    ///< sections in disorder, of one plane or nearly
};

struct BrokenStack {
  SectionStack stack;
  std::optional<PlaneOptions> planes;
  RepairOptions repair;
  /// Of `keyholes`: in each section; of `copies` and `planes`: as many as are left.
  std::optional<std::size_t> holes;
  /// Of `planes`: what comes of it, but for the order of contours.
  std::optional<SectionStack> ordered;
};

[[nodiscard]] BrokenStack draft_broken(BrokenKind kind, Prng& prng);
[[nodiscard]] BrokenStack broken(BrokenKind kind, std::uint64_t seed);

/// The stack mended as it asks for; without sections where that is refused.
[[nodiscard]] SectionStack mended(const BrokenStack& broken);

}  // namespace tetloft::testing
