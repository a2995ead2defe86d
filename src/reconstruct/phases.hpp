// The phases that all need who ask for a solid, or for what it is made of: prepare, decide, put
// between, build; and glue.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/predicates.hpp>
#include <tetloft/reconstruct.hpp>

#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "reconstruct/clusters.hpp"
#include "reconstruct/glue.hpp"
#include "reconstruct/plan.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal {

/// A stack, or a window of one, as far as it was made: planned, or its slabs solid but for open
/// ones.
struct BuiltStack {
  PreparedStack prepared;
  Plan plan;                                 ///< as it was built
  IdVector<SectionId, Nesting> complements;  ///< VoidDecision::complements()
  std::vector<Part> parts;                   ///< from below; of a stack planned, none yet
  /// Of a window: slabs that have no solid, and those mended together (SlabBuilds).
  std::vector<OpenCluster> open;
  std::vector<std::vector<SlabId>> mended;
  std::uint64_t refinements = 0;  ///< how often contours were refined
  StepSeconds seconds{};          ///< of what is not told by the parts
  std::vector<Warning> warnings;

  /// How many sections the slab's solid has between its two.
  [[nodiscard]] IdVector<SlabId, std::uint32_t> sections_between() const;
};

/// Steps that the caller's callback hears of; none of an empty stack, which is refused.
[[nodiscard]] std::size_t step_count(const SectionStack& stack);

/// Prepares, decides, puts between and builds, in this unit. Errors are in the unit given.
[[nodiscard]] Result<BuiltStack> build_stack(Unit unit, const GivenStack& stack,
                                             const ReconstructOptions& options, WatchedWork& work);

/// Prepares and decides: all that slabs are built by, but what is put between. Sections are
/// conforming only by Criterion::reverse.
[[nodiscard]] Result<BuiltStack> plan_stack(Unit unit, const GivenStack& stack,
                                            const ReconstructOptions& options, WatchedWork& work);
/// Refused (usage) are options that there are not.
[[nodiscard]] std::optional<Error> check_options(const ReconstructOptions& options);

/// How many sections beyond its own ones a window takes, on each side where there are any, so that
/// what is decided about its own sections, and the slabs at them, is what the whole stack would
/// have decided, without labels and decisions, and but for the numbers of components.
///
/// Let the window have the slabs a - 4 … b + 3 and its own be a … b - 1. Candidates by the
/// criterion rest on four sections, those beside the slab too (motion): they are those of the whole
/// in slabs a - 3 … b + 2. Chains ask three slabs: right in a - 2 … b + 1. Lone regions ask the
/// candidates of both slabs at their section, and link in these: all candidates, and so all links,
/// are right in a - 1 … b. (Where nothing is asked for, every candidate that is made is a link:
/// rules 5 and 6 of correspondence have no label to respect.) Voids ask the links of their slab,
/// and by chains those of the slabs beside it: right in a … b - 1.
inline constexpr std::size_t kDecisionHalo = 4;
/// Decides about a stack, or a window (PreparedStack::of_whole).
[[nodiscard]] std::optional<Error> decide_window(BuiltStack& window,
                                                 const ReconstructOptions& options,
                                                 const WatchedWork& work);
/// Whether what is decided about a slab depends on nothing farther away than that: by labels,
/// decisions and reverse tetrahedra it depends on the whole.
[[nodiscard]] bool decides_in_windows(const ReconstructOptions& options);

/// Conforms the sections of a planned window (window.hpp), puts between and builds its slabs, or
/// leaves them open.
[[nodiscard]] std::optional<Error> build_window(BuiltStack& window,
                                                const ReconstructOptions& options,
                                                WatchedWork& work);

/// The model, in the unit given; the parts and the triangulations of sections are given up. Nothing
/// where it is none there: a coordinate would lose a bit.
[[nodiscard]] std::optional<Model> take_model(BuiltStack& built, unsigned threads);

/// make(unit, options) -> Result<std::optional<T>>, in the unit of the stack, or, where nothing
/// came of that, in the one given.
template <class Make>
auto in_either_unit(const ReconstructOptions& given_options, const Make& make) {
  using Made = std::decay_t<decltype(**make(Unit::of_the_stack, given_options))>;
  return guard_threads(given_options, [&](const ReconstructOptions& options) -> Result<Made> {
    if (Result<void> sound = fp_self_check(); !sound) return sound.error();
    auto made = make(Unit::of_the_stack, options);
    if (!made) return made.error();
    if (*made) return std::move(**made);
    ReconstructOptions again = options;
    again.execution.progress = nullptr;  // all steps have been told
    made = make(Unit::as_given, again);
    if (!made) return made.error();
    return std::move(**made);
  });
}

}  // namespace tetloft::internal
