// The file of a plan: its head, then a record for each section.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pieces/archive.hpp"
#include "pieces/plan_head.hpp"

namespace tetloft::internal::pieces {

/// A plan's bytes; returns its identity.
std::uint64_t append_plan(io::Sink& sink, const PlanHead& head, const BuiltStack& planned);

class PlanFile {
 public:
  [[nodiscard]] static Result<PlanFile> open(const std::string& path);
  /// Of an archive that could be opened; `path` stands for it.
  [[nodiscard]] static Result<PlanFile> of(Result<ArchiveReader> archive, const std::string& path);

  [[nodiscard]] const PlanHead& head() const { return head_; }
  [[nodiscard]] std::uint64_t identity() const { return archive_.identity(); }
  [[nodiscard]] std::size_t slabs() const { return head_.facts.sections - 1; }

  /// Of one section; errors name it.
  [[nodiscard]] Result<SectionPlan> section(std::size_t s) const;
  /// These slabs, to be built. Requires slabs that there are.
  [[nodiscard]] Result<BuiltStack> window(const SlabRange& slabs) const;
  /// All sections, in the unit given.
  [[nodiscard]] Result<SectionStack> stack() const;

 private:
  ArchiveReader archive_;
  PlanHead head_;
};

/// Slabs of a plan, built.
struct PlannedRange {
  BuiltRange built;
  ReconstructReport report;
  std::vector<Warning> warnings;
};
/// Builds these slabs. Errors name slabs and sections of the whole. Nothing where a coordinate
/// would lose bits in the unit given: then the whole stack has to be planned in that
/// (Unit::as_given).
[[nodiscard]] Result<std::optional<PlannedRange>> try_range(const PlanFile& plan,
                                                            const SlabRange& slabs,
                                                            const Execution& execution);
/// The same; refused (unrepresentable) instead of nothing.
[[nodiscard]] Result<PlannedRange> build_range(const PlanFile& plan, const SlabRange& slabs,
                                               const Execution& execution);

}  // namespace tetloft::internal::pieces
