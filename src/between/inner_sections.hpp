// Sections traced between the two given ones of a slab, class by class, so that no handle, cavity
// or bar opens and closes within the slab.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

#include "between/class_shape.hpp"
#include "slab/classes.hpp"

namespace tetloft::internal::between {

/// A class of the slab: its regions in the two sections, and what its shape is made from.
struct SlabClass {
  std::vector<RegionId> lower, upper;
  ClassOutlines outlines;
};

/// What lies between is made from. All must outlive its use.
struct SlabShape {
  const Section& lower;
  const Section& upper;
  const Nesting& lower_nesting;
  const Nesting& upper_nesting;
  IdVector<ClassId, SlabClass> classes;
  double step = 0;         ///< of the lattice
  std::vector<double> at;  ///< the planes between, as shares of the gap
};

struct InnerSection {
  Section section;  ///< valid, between the planes of the slab
  Nesting nesting;
  IdVector<RegionId, ClassId> class_of;
};

/// Regions of one class in neighbouring layers that hang together.
struct LayerLink {
  RegionId below, above;
  friend auto operator<=>(const LayerLink&, const LayerLink&) = default;
};

struct InnerSections {
  std::vector<InnerSection> sections;
  /// links[k]: between layers k and k + 1; layer 0 is the slab's lower section, the last its upper
  /// one. Sorted.
  std::vector<std::vector<LayerLink>> links;
  /// How many were to be put between.
  std::size_t wanted = 0;
};

/// None where nothing can be put between without changing which regions hang together, or where
/// doubles hold no valid section.
[[nodiscard]] InnerSections trace_between(const SlabShape& shape);

}  // namespace tetloft::internal::between
