// A stack planned in the memory of some sections: what is decided over it is decided window by
// window (reconstruct/phases.hpp, kDecisionHalo).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/watched_work.hpp"
#include "io/sink.hpp"
#include "pieces/plan_head.hpp"
#include "pieces/section_store.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal::pieces {

struct PlannedStack {
  PlanHead head;
  std::uint64_t identity = 0;
  std::vector<Warning> warnings;
  StepSeconds seconds{};
};

/// How many own sections a window of a stack has: fewer decide more slabs twice, at both ends, more
/// take more memory. What is decided does not depend on it.
struct PlanningWindows {
  std::size_t least = 16;
  std::size_t most = 128;
  std::size_t vertices = std::size_t{1} << 17;  ///< above `least`: until they have so many
};

/// Plans a stack in a unit and appends the plan's bytes: those of append_plan(). Each section is a
/// step of the work. `path`: where scratch files may be, as of io::ScratchFile. Where decisions
/// depend on the whole (decides_in_windows()), and of a single section, all of it is in memory.
[[nodiscard]] Result<PlannedStack> plan_stored(const SectionStore& store, Unit unit,
                                               const ReconstructOptions& options,
                                               const PlanSource& source, const std::string& path,
                                               WatchedWork& work, io::Sink& sink,
                                               const PlanningWindows& windows = {});

}  // namespace tetloft::internal::pieces
