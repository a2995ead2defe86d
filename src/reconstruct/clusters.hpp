// Which slabs were mended together, and how their sections were planned: README.md, "Clusters".
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "core/union_find.hpp"
#include "reconstruct/plan.hpp"

namespace tetloft::internal {

/// What mending needs that a window of a stack has not.
struct Beyond {
  bool below = false;    ///< the slab below the first one
  bool above = false;    ///< the slab above the last one
  bool decides = false;  ///< links, decided anew over the whole stack

  [[nodiscard]] bool any() const { return below || above || decides; }
};

/// Slabs that have no solid, since mending them takes more than there is.
struct OpenCluster {
  std::vector<SlabId> slabs;  ///< sorted
  Beyond beyond;
};

class MendClusters {
 public:
  explicit MendClusters(std::size_t slabs) : sets_(slabs), mended_(slabs), open_(slabs) {}

  /// Keeps how a section is planned, the first time.
  void keep(SectionId s, const Plan& plan);
  /// A slab was mended, and these were touched. True where the cluster is open: one of them was, or
  /// something is beyond.
  bool unite(SlabId slab, const std::vector<SlabId>& touched, const Beyond& beyond);
  /// Puts the plan of the cluster's sections back; the slabs of the cluster.
  [[nodiscard]] std::vector<SlabId> restore(SlabId of_cluster, Plan& plan);

  [[nodiscard]] bool is_open(SlabId slab) const {
    return open_[SlabId(sets_.find(slab.index()))].any();
  }
  /// By their lowest slabs.
  [[nodiscard]] std::vector<OpenCluster> open() const;
  /// All clusters that are not open, of more than nothing mended, each sorted, by their lowest.
  [[nodiscard]] std::vector<std::vector<SlabId>> mended() const;

 private:
  struct AsPlanned {
    IdVector<ContourId, bool> gabriel;
    std::vector<Point2> apart;
    std::vector<EdgeDivision> divided;
  };

  [[nodiscard]] std::vector<SlabId> slabs_with(SlabId of_cluster) const;

  UnionFind sets_;
  IdVector<SlabId, std::uint8_t> mended_;
  IdVector<SlabId, Beyond> open_;  // of the lowest slab of each set
  std::map<SectionId, AsPlanned> planned_;
};

}  // namespace tetloft::internal
