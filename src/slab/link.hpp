// A link: two regions of neighbouring sections that belong together.
#pragma once

#include <compare>

#include <tetloft/ids.hpp>

namespace tetloft::internal {

/// A link between a region below and a region above one slab.
struct Link {
  SlabId slab;
  RegionId lower;
  RegionId upper;
  friend auto operator<=>(const Link&, const Link&) = default;
};

}  // namespace tetloft::internal
