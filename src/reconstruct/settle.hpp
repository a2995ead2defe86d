// What was left open where a stack was cut is built from the plan: README.md, "Clusters".
#pragma once

#include <functional>
#include <vector>

#include <tetloft/model.hpp>

#include "model/segment.hpp"
#include "reconstruct/clusters.hpp"

namespace tetloft::internal {

/// Slabs mended together, next to each other, by their numbers in the whole stack; open where
/// anything is beyond.
struct ClusterSpan {
  SlabRange slabs;
  Beyond beyond;
};

/// Slabs built as one window: their model, numbered as a part of the whole, and what was mended.
struct BuiltRange {
  SlabRange slabs;
  Model model;
  std::vector<ClusterSpan> clusters;
};

struct Settled {
  std::vector<BuiltRange> ranges;     ///< without anything open; disjoint, by slab
  std::vector<ClusterSpan> clusters;  ///< of all that is built now
  bool whole = false;  ///< links have to be decided anew: nothing less than the whole stack will do
};

/// Builds ranges around all open clusters of a stack of so many slabs, each as large as it takes;
/// what is in them replaces what was built before. `clusters`: of all that was built.
[[nodiscard]] Result<Settled> settle(
    std::size_t slabs, std::vector<ClusterSpan> clusters,
    const std::function<Result<BuiltRange>(const SlabRange&)>& build);

}  // namespace tetloft::internal
