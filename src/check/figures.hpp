#pragma once

#include <tetloft/check.hpp>

#include "check/resampling.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

/// The largest sideways distance of a used vertex off the section planes from both its
/// sections' regions (0 inside), in gaps of its slab; beyond the ends from the one region, in
/// gaps of the slab next to it, or for a single section in twice its height over it. Empty
/// sections do not count. In plain doubles: a figure, not a verdict.
[[nodiscard]] double overshoot(const ModelView& view, const SectionStack& stack);

/// Over all sound tets; 0 if one is not positive, 180 without tets. In plain doubles.
[[nodiscard]] double smallest_dihedral_degrees(const ModelView& view);

}  // namespace tetloft::internal::checking
