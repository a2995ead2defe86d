// What the links imply for a slab's topology, made in its complex: passages closed, handles filled,
// sealed faces opened.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "completion/completion.hpp"
#include "completion/handles.hpp"
#include "completion/passages.hpp"
#include "completion/pits.hpp"
#include "completion/sealed_faces.hpp"
#include "reconstruct/slab_solid.hpp"
#include "reconstruct/slab_topology.hpp"
#include "sections/face_overlay.hpp"

namespace tetloft::internal {

/// A slab with what its tets and vertices belong to.
struct SlabView {
  const Slab& slab;
  const SlabClasses& classes;
  const IdVector<ClassId, std::uint8_t>& active;
};

class Topology {
 public:
  /// All must outlive this. Does nothing where nothing was decided about voids.
  Topology(const ConformingSection& lower, const ConformingSection& upper, const SlabLinks& links,
           Pits& pits);

  enum class Next : std::uint8_t {
    go_on,   ///< nothing can be done better
    again,   ///< the sections of the pits have changed: D is another
    refine,  ///< wanted() says what
  };
  /// Works on a completed slab; `may_ask` as in SlabOptions.
  [[nodiscard]] Next make(const SlabView& view, Completion& completion, bool may_ask,
                          RuleCounts& rules);

  [[nodiscard]] const RefineHere& wanted() const { return wanted_; }
  [[nodiscard]] const std::vector<Inseparable>& united() const { return united_; }
  [[nodiscard]] const std::vector<Link>& unrealised() const { return unrealised_; }
  /// What the links imply; none where nothing was decided about voids.
  [[nodiscard]] const std::vector<TopologyGroup>& groups() const { return groups_; }

 private:
  /// Openings are tried until one round makes nothing better, which is taken back.
  enum class Openings : std::uint8_t { may_help, tried, given_up };

  [[nodiscard]] bool part_voids(const SlabView& view, SlabVoids& voids, Completion& completion,
                                bool may_ask, RuleCounts& rules);
  void drop_unrealised(const SlabView& view, const SlabVoids& voids, const ComplexShape& shape);
  [[nodiscard]] std::vector<ChiRange> chi_ranges(const SlabView& view) const;
  void bridge_faces(const SlabView& view, const ChiGroups& groups, TetsOver& tets_over,
                    Completion& completion, ComplexShape& shape, RuleCounts& rules);
  [[nodiscard]] Next open_faces(const SlabView& view, const SlabVoids& voids,
                                const ChiGroups& groups, TetsOver& tets_over,
                                const Completion& completion, const ComplexShape& shape,
                                bool may_ask);

  // What the sections' overlay tells of its faces; with the places of these.
  [[nodiscard]] const sections::FaceOverlay& faces();
  [[nodiscard]] const sections::FaceOverlay& placed_faces();

  const ConformingSection& lower_;
  const ConformingSection& upper_;
  const SlabLinks& links_;
  Pits& pits_;
  std::optional<sections::FaceOverlay> faces_;  // once made here
  std::vector<Inseparable> united_;
  std::vector<Link> unrealised_;
  std::vector<TopologyGroup> groups_;
  /// By void: joined_voids() of the complex as it is; nothing where that is not known.
  std::vector<SlabVoidId> joined_;
  RefineHere wanted_;
  Openings openings_ = Openings::may_help;
  std::int32_t least_deviation_ = std::numeric_limits<std::int32_t>::max();
};

}  // namespace tetloft::internal
