// Phase 2, build: the solid of each slab, from its two sections and its links alone. Where a slab
// asks for finer contours its sections are conformed again, and the slabs that this touches are
// built again, no others; where that does not help either a link is dropped. Of a window of a
// longer stack slabs are left open that cannot be built without those beyond it: README.md,
// "Clusters".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/clusters.hpp"
#include "reconstruct/decide.hpp"
#include "reconstruct/glue.hpp"
#include "reconstruct/plan.hpp"
#include "reconstruct/prepare.hpp"
#include "reconstruct/slab_solid.hpp"

namespace tetloft::internal {

class SlabBuilds {
 public:
  /// All must outlive this. Sections are refined as slabs ask for it, and the plan follows.
  /// `decision`: null in a window, where nothing is decided anew.
  SlabBuilds(PreparedStack& prepared, Decision* decision, Plan& plan,
             const ReconstructOptions& options, WatchedWork& work);

  /// Builds all slabs, each a step of the work, until all are solid or open. The error of the
  /// lowest slab that is neither. Triangulations of sections are given up as soon as no slab needs
  /// them.
  [[nodiscard]] std::optional<Error> run();
  /// Slabs that are left as planned, and have no solid; by their lowest. None of a whole stack.
  [[nodiscard]] std::vector<OpenCluster> open_clusters() const { return clusters_.open(); }

  /// Conforms the sections of these slabs as planned, where their triangulations were given up.
  [[nodiscard]] std::optional<Error> triangulate_again(const std::vector<SlabId>& slabs);

  /// The solids of slabs and, as planned, ends, from below; handed out.
  [[nodiscard]] std::vector<Part> take_parts();

  /// Of sections that are not divided after all, since no slab could be built so.
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }
  /// Which slabs were mended together (MendClusters::mended()).
  [[nodiscard]] std::vector<std::vector<SlabId>> mended() const { return clusters_.mended(); }
  /// How often a slab was built, each counted as often as it was.
  [[nodiscard]] std::size_t built() const { return built_; }
  /// How often contours were refined, of slabs that are not open.
  [[nodiscard]] std::uint64_t refinements() const;

 private:
  // What a slab that is no solid yet needs: slabs to build again, some of them maybe several
  // times; or more than is at hand.
  struct Mended {
    std::vector<SlabId> touched;
    Beyond beyond;
  };

  [[nodiscard]] std::optional<Error> build(const std::vector<SlabId>& slabs);
  // That is neither solid nor open; invalid: none.
  [[nodiscard]] SlabId lowest_stuck() const;
  // Puts all that its slabs changed back as planned.
  void leave_open(SlabId of_cluster);
  void release_if_done(SectionId s);
  [[nodiscard]] bool depends_on_triangulations() const {
    return options_.correspondence.criterion == Criterion::reverse;
  }
  // The slabs at a section that is another one now.
  void touch(SectionId s, Mended& mended) const;
  [[nodiscard]] bool is_divided(SlabId slab) const;
  // Takes contours as they are where the slab is refused with divided ones, or a section is; adds
  // the slabs that this touches.
  [[nodiscard]] std::optional<Error> undivide(SectionId s, const std::string& reason,
                                              Mended& mended);
  [[nodiscard]] Result<Mended> mend(SlabId slab);
  [[nodiscard]] Result<Mended> undivide(SlabId slab, const Unrepresentable& refused);
  [[nodiscard]] Result<Mended> refine(SlabId slab, const RefineHere& wanted);
  [[nodiscard]] Result<Mended> drop(SlabId slab, const Unconnectable& apart);
  // Plans by it from now on; adds the slabs whose links are others.
  [[nodiscard]] std::optional<Error> adopt(Result<Correspondence> anew,
                                           std::vector<SlabId>& touched);
  [[nodiscard]] Error cannot_connect(SlabId slab, const Unconnectable& apart) const;

  PreparedStack& prepared_;
  Decision* decision_;  // null: as planned
  Plan& plan_;
  const ReconstructOptions& options_;
  WatchedWork& work_;
  IdVector<SlabId, SlabOutcome> outcome_;
  MendClusters clusters_;
  std::size_t built_ = 0;
  IdVector<SlabId, std::uint32_t> refinements_;
  std::vector<Warning> warnings_;
};

}  // namespace tetloft::internal
