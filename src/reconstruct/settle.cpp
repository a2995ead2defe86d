#include "reconstruct/settle.hpp"

#include <algorithm>
#include <utility>

namespace tetloft::internal {

namespace {

SlabRange united(const SlabRange& a, const SlabRange& b) {
  return {std::min(a.first, b.first), std::max(a.end, b.end)};
}

// The cluster and what it reaches for.
SlabRange reach(const ClusterSpan& cluster, std::size_t slabs) {
  SlabRange range = cluster.slabs;
  if (cluster.beyond.below && range.first > 0) --range.first;
  if (cluster.beyond.above && range.end < slabs) ++range.end;
  return range;
}

// Larger by all clusters that it cuts into.
SlabRange closed(SlabRange range, const std::vector<ClusterSpan>& clusters, std::size_t slabs) {
  for (bool grown = true; grown;) {
    grown = false;
    for (const ClusterSpan& cluster : clusters) {
      if (!range.meets(cluster.slabs)) continue;
      const SlabRange larger = united(range, reach(cluster, slabs));
      grown = grown || larger != range;
      range = larger;
    }
  }
  return range;
}

bool any_decides(const std::vector<ClusterSpan>& clusters) {
  return std::any_of(clusters.begin(), clusters.end(),
                     [](const ClusterSpan& cluster) { return cluster.beyond.decides; });
}

}  // namespace

Result<Settled> settle(std::size_t slabs, std::vector<ClusterSpan> clusters,
                       const std::function<Result<BuiltRange>(const SlabRange&)>& build) {
  Settled settled;
  const auto open = [&] {
    return std::find_if(clusters.begin(), clusters.end(),
                        [](const ClusterSpan& cluster) { return cluster.beyond.any(); });
  };
  for (auto next = open(); next != clusters.end(); next = open()) {
    if (any_decides(clusters)) return Settled{{}, {}, true};
    SlabRange range = closed(reach(*next, slabs), clusters, slabs);
    // Ranges made before that this one cuts into are given up.
    for (bool grown = true; grown;) {
      grown = false;
      for (const BuiltRange& made : settled.ranges) {
        if (!range.meets(made.slabs) || united(made.slabs, range) == range) continue;
        range = closed(united(made.slabs, range), clusters, slabs);
        grown = true;
      }
    }
    std::erase_if(settled.ranges, [&](const BuiltRange& made) { return range.meets(made.slabs); });
    Result<BuiltRange> built = build(range);
    if (!built) return built.error();
    // What the range itself found out comes in the place of what was known of its slabs.
    std::erase_if(clusters, [&](const ClusterSpan& cluster) { return range.meets(cluster.slabs); });
    clusters.insert(clusters.end(), built->clusters.begin(), built->clusters.end());
    settled.ranges.push_back(std::move(*built));
  }
  std::sort(settled.ranges.begin(), settled.ranges.end(),
            [](const BuiltRange& a, const BuiltRange& b) { return a.slabs.first < b.slabs.first; });
  settled.clusters = std::move(clusters);
  return settled;
}

}  // namespace tetloft::internal
