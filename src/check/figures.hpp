#pragma once

#include <tetloft/check.hpp>

#include "check/resampling.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

/// The largest sideways distance of a used vertex off the section planes from both its
/// sections' regions (0 inside), in gaps of its slab; beyond the ends from the one region, in
/// gaps of the slab next to it, or for a single section in twice its height over it. Empty
/// sections do not count. In plain doubles: a figure, not a verdict. Of vertices that lie between
/// these sections, or beyond an end of the stack that is one of them.
[[nodiscard]] double overshoot(const ModelView& view, const SectionStack& stack,
                               const SectionRange& sections);

/// Over all sound tets; 0 if one is not positive, 180 without tets. In plain doubles.
[[nodiscard]] double smallest_dihedral_degrees(const ModelView& view);

/// Of what is shown: sums and extremes.
struct ViewFigures {
  double volume = 0;
  double overshoot = 0;
  double smallest_dihedral_degrees = 180;
  double largest_split_ulps = 0;
  std::size_t inner_vertices = 0;

  void add(const OnContours& on);
  void add(const ViewFigures& more);
  void tell(CheckReport& report) const;
};
/// Of the sound tets alone, which are of this model, and of vertices between these sections.
[[nodiscard]] ViewFigures measure(const Model& model, const ModelView& view,
                                  const SectionStack& stack, const SectionRange& sections);

}  // namespace tetloft::internal::checking
