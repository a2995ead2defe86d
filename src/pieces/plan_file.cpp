#include "pieces/plan_file.hpp"

#include <utility>

#include "core/guard.hpp"
#include "core/watched_work.hpp"
#include "reconstruct/report_of.hpp"
#include "sections/scaling.hpp"

namespace tetloft::internal::pieces {

std::uint64_t append_plan(io::Sink& sink, const PlanHead& head, const BuiltStack& planned) {
  ArchiveWriter archive(sink);
  archive.append(to_record(head));
  for (std::size_t s = 0; s < planned.prepared.section_count(); ++s) {
    archive.append(to_record(section_plan(planned, SectionId(s))));
  }
  return archive.finish();
}

Result<PlanFile> PlanFile::open(const std::string& path) {
  return of(ArchiveReader::open(path), path);
}

Result<PlanFile> PlanFile::of(Result<ArchiveReader> archive, const std::string& path) {
  if (!archive) return archive.error();
  PlanFile file;
  file.archive_ = std::move(*archive);
  if (file.archive_.size() == 0) {
    Error error{ErrorCode::invalid_input, "not a plan: it is empty", {}};
    error.where.file = path;
    return error;
  }
  const Result<std::string> bytes = file.archive_.record(0);
  if (!bytes) return bytes.error();
  Result<PlanHead> head = plan_head_from_record(*bytes, path);
  if (!head) return head.error();
  file.head_ = std::move(*head);
  if (file.archive_.size() != file.head_.facts.sections + 1) {
    Error error{ErrorCode::invalid_input, "not a plan: it has some of its sections", {}};
    error.where.file = path;
    return error;
  }
  return file;
}

Result<SectionPlan> PlanFile::section(std::size_t s) const {
  const Result<std::string> bytes = archive_.record(s + 1);
  if (!bytes) return bytes.error();
  Result<SectionPlan> plan = section_plan_from_record(*bytes, archive_.path());
  if (plan) return plan;
  Error error = plan.error();
  error.where.section = s;
  return error;
}

Result<BuiltStack> PlanFile::window(const SlabRange& slabs) const {
  std::vector<SectionPlan> plans;
  for (std::size_t s = slabs.first; s <= slabs.end; ++s) {
    Result<SectionPlan> plan = section(s);
    if (!plan) return plan.error();
    plans.push_back(std::move(*plan));
  }
  std::optional<SectionPlan> below;
  std::optional<SectionPlan> above;
  if (slabs.first > 0) {
    Result<SectionPlan> plan = section(slabs.first - 1);
    if (!plan) return plan.error();
    below = std::move(*plan);
  }
  if (slabs.end + 1 < head_.facts.sections) {
    Result<SectionPlan> plan = section(slabs.end + 1);
    if (!plan) return plan.error();
    above = std::move(*plan);
  }
  Result<BuiltStack> window =
      window_of(head_.facts, slabs, std::move(plans), std::move(below), std::move(above));
  if (window) return window;
  Error error = window.error();
  error.where.file = archive_.path();
  return error;
}

Result<SectionStack> PlanFile::stack() const {
  SectionStack stack;
  stack.frame = head_.frame;
  stack.about = head_.about;
  for (std::size_t s = 0; s < head_.facts.sections; ++s) {
    Result<SectionPlan> plan = section(s);
    if (!plan) return plan.error();
    stack.sections.push_back(std::move(plan->section));
  }
  return sections::scaled(stack, -head_.facts.exponent);
}

Result<std::optional<PlannedRange>> try_range(const PlanFile& plan, const SlabRange& slabs,
                                              const Execution& execution) {
  Result<BuiltStack> window = plan.window(slabs);
  if (!window) return window.error();
  ReconstructOptions options = plan.head().options;
  options.execution = execution;
  WatchedWork work(execution, 2 * (slabs.end - slabs.first) + 1);
  window->prepared.work_limit = options.work_limit;
  if (auto error = build_window(*window, options, work)) {
    error->where = in_whole(error->where, slabs);
    return *error;
  }
  PlannedRange made;
  made.report = report_of_parts(*window);
  std::optional<BuiltRange> built =
      take_range(plan.head().facts, slabs, *window, execution.threads);
  if (!built) return std::optional<PlannedRange>();
  made.built = *std::move(built);
  made.warnings = std::move(window->warnings);
  Model& model = made.built.model;
  model.frame = plan.head().frame;
  model.about = plan.head().about;
  model.component_names = plan.head().component_names;
  for (Warning& warning : made.warnings) warning.where = in_whole(warning.where, slabs);
  return std::optional(std::move(made));
}

Result<PlannedRange> build_range(const PlanFile& plan, const SlabRange& slabs,
                                 const Execution& execution) {
  Result<std::optional<PlannedRange>> made = try_range(plan, slabs, execution);
  if (!made) return made.error();
  if (*made) return std::move(**made);
  Error error{ErrorCode::unrepresentable,
              "a coordinate would lose bits in the unit of the stack, unless all of it is made in "
              "one run",
              {}};
  error.where.slab = slabs.first;
  return error;
}

}  // namespace tetloft::internal::pieces
