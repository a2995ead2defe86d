// Phase 2, build: the solid of each slab, from its two sections and its links alone. Where a slab
// asks for finer contours its sections are conformed again, and the slabs that this touches are
// built again, no others; where that does not help either a link is dropped.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/decide.hpp"
#include "reconstruct/glue.hpp"
#include "reconstruct/plan.hpp"
#include "reconstruct/prepare.hpp"
#include "reconstruct/slab_solid.hpp"

namespace tetloft::internal {

class SlabBuilds {
 public:
  /// All must outlive this. Sections are refined as slabs ask for it, and the plan follows.
  SlabBuilds(PreparedStack& prepared, Decision& decision, Plan& plan,
             const ReconstructOptions& options, WatchedWork& work);

  /// Builds all slabs, each a step of the work, until all are solid. The error of the lowest slab
  /// that has none. Triangulations of sections are given up as soon as no slab needs them.
  [[nodiscard]] std::optional<Error> run();

  /// Conforms the sections of these slabs as planned, where their triangulations were given up.
  [[nodiscard]] std::optional<Error> triangulate_again(const std::vector<SlabId>& slabs);

  /// The solids of slabs and, as planned, ends, from below; handed out.
  [[nodiscard]] std::vector<Part> take_parts();

  /// Of sections that are not divided after all, since no slab could be built so.
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }
  /// How often a slab was built, each counted as often as it was.
  [[nodiscard]] std::size_t built() const { return built_; }
  /// How often contours were refined.
  [[nodiscard]] std::uint64_t refinements() const { return refinements_; }

 private:
  [[nodiscard]] std::optional<Error> build(const std::vector<SlabId>& slabs);
  void release_if_done(SectionId s);
  [[nodiscard]] bool is_divided(SlabId slab) const;
  // Takes contours as they are where the slab is refused with divided ones, or a section is; adds
  // the slabs that this touches.
  [[nodiscard]] std::optional<Error> undivide(SectionId s, const std::string& reason,
                                              std::vector<SlabId>& touched);
  // What a slab that is none yet needs. These return the slabs to build again,
  // some of them maybe several times.
  [[nodiscard]] Result<std::vector<SlabId>> mend(SlabId slab);
  [[nodiscard]] Result<std::vector<SlabId>> undivide(SlabId slab, const Unrepresentable& refused);
  [[nodiscard]] Result<std::vector<SlabId>> refine(SlabId slab, const RefineHere& wanted);
  [[nodiscard]] Result<std::vector<SlabId>> drop(SlabId slab, const Unconnectable& apart);
  // Plans by it from now on; adds the slabs whose links are others.
  [[nodiscard]] std::optional<Error> adopt(Result<Correspondence> anew,
                                           std::vector<SlabId>& touched);
  [[nodiscard]] Error cannot_connect(SlabId slab, const Unconnectable& apart) const;

  PreparedStack& prepared_;
  Decision& decision_;
  Plan& plan_;
  const ReconstructOptions& options_;
  WatchedWork& work_;
  IdVector<SlabId, SlabOutcome> outcome_;
  std::size_t built_ = 0;
  std::uint64_t refinements_ = 0;
  std::vector<Warning> warnings_;
};

}  // namespace tetloft::internal
