// What is decided over a whole stack before any slab is built. With it, sections can be conformed
// and slabs built apart from each other, in any order, on any machine; and their solids glued.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/conforming_section.hpp>

#include "between/inner_sections.hpp"
#include "correspondence/correspondence.hpp"

namespace tetloft::internal {

/// Where the prisms beyond the first and last section end, if there are any.
struct EndPlanes {
  std::optional<double> below;
  std::optional<double> above;
};

struct Plan {
  /// The stack times 2^exponent is what slabs are built from, and the model divided by it what
  /// the caller gets.
  int exponent = 0;
  EndPlanes ends;
  /// The contours to be refined to Gabriel edges, by section; empty: none.
  IdVector<SectionId, IdVector<ContourId, bool>> gabriel;
  /// The points that circles of triangles inside a section's region must not hold
  /// (ConformOptions::apart), by section.
  IdVector<SectionId, std::vector<Point2>> apart;
  /// How coarse contours are divided (ConformOptions::divided), by section.
  IdVector<SectionId, std::vector<EdgeDivision>> divided;
  /// Which slabs may still ask for finer contours (SlabOptions::may_ask).
  IdVector<SlabId, std::uint8_t> may_ask;
  Correspondence correspondence;
  /// Of voids: as VoidDecision::make().
  std::optional<Correspondence> voids;
  /// Sections put between those of a slab.
  IdVector<SlabId, between::InnerSections> between;
  std::vector<RegionMotion> motions;  ///< that it was decided by; in the plan's unit
};

}  // namespace tetloft::internal
