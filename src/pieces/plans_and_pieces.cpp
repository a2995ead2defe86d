// Plans and pieces as files.
#include <algorithm>
#include <fstream>
#include <string>
#include <utility>

#include <tetloft/pieces.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "io/files.hpp"
#include "io/vtu_piece.hpp"
#include "model/digest.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/plan_file.hpp"
#include "pieces/planner.hpp"
#include "reconstruct/component_names.hpp"
#include "reconstruct/decide_voids.hpp"
#include "reconstruct/report_of.hpp"

namespace tetloft {

using namespace internal;

namespace internal::pieces {

PlanHead head_of(const BuiltStack& planned, const SectionStack& stack,
                 const ReconstructOptions& options, const PlanSource& source) {
  PlanHead head;
  head.facts = facts_of(planned);
  head.options = options;
  head.source = source;
  head.contours = stack.contour_count();
  head.vertices = stack.vertex_count();
  if (planned.plan.voids) head.cavities = cavities(*planned.plan.voids);
  head.lowest = stack.sections.raw().front().z;
  head.highest = stack.sections.raw().back().z;
  head.frame = stack.frame;
  head.about = stack.about;
  head.component_names = names_by_labels(planned.plan.correspondence.partition,
                                         head.facts.components, options.correspondence.labels);
  return head;
}

PlanSummary summary_of(const PlanHead& head, std::uint64_t identity) {
  return {identity,      head.source, head.options, head.facts.sections,   head.contours,
          head.vertices, head.lowest, head.highest, head.facts.components, head.cavities};
}

Result<StagedPlan> stage_plan(const std::string& path, const GivenStack& given,
                              const ReconstructOptions& options, const PlanSource& source,
                              io::TemporaryWatcher* watcher) {
  StackStream sections(*given.stack);
  return stage_plan(path, GivenSections{sections, given.nestings}, options, source, watcher);
}

Result<StagedPlan> stage_plan(const std::string& path, const GivenSections& given,
                              const ReconstructOptions& options, const PlanSource& source,
                              io::TemporaryWatcher* watcher) {
  if (auto error = check_options(options)) return *error;
  const Result<SectionStore> store = SectionStore::of(given, options.execution, path);
  if (!store) return store.error();
  return in_either_unit(
      options,
      [&](Unit unit, const ReconstructOptions& in_unit) -> Result<std::optional<StagedPlan>> {
        WatchedWork work(in_unit.execution, store->size());
        StagedPlan plan;
        Result<io::Staged> staged = io::stage(path, watcher, [&](io::Sink& sink) -> io::Written {
          Result<PlannedStack> made = plan_stored(*store, unit, in_unit, source, path, work, sink);
          if (!made) return made.error();
          plan.summary = summary_of(made->head, made->identity);
          return std::move(made->warnings);
        });
        if (!staged) return staged.error();
        plan.files = std::move(staged->files);
        plan.warnings = std::move(staged->warnings);
        return std::optional(std::move(plan));
      });
}

Result<StagedPiece> stage_piece(const std::string& path, const std::string& plan_path,
                                const SlabRange& slabs, const PieceOptions& options,
                                io::TemporaryWatcher* watcher) {
  return guard_threads(options, [&](const PieceOptions& own) -> Result<StagedPiece> {
    const Result<PlanFile> plan = PlanFile::open(plan_path);
    if (!plan) return plan.error();
    const bool single = plan->slabs() == 0 && slabs == SlabRange{0, 0};
    if (!single && !(slabs.first < slabs.end && slabs.end <= plan->slabs())) {
      return Error{ErrorCode::usage,
                   "there are no slabs " + std::to_string(slabs.first) + ':' +
                       std::to_string(slabs.end) + ": the plan has " +
                       (plan->slabs() == 0 ? "none, 0:0 is all of it"
                                           : "those of 0:" + std::to_string(plan->slabs())),
                   {}};
    }
    Result<PlannedRange> made = build_range(*plan, slabs, own.execution);
    if (!made) return made.error();
    WholePiece whole;
    PieceRecord& record = whole.record;
    record.plan = plan->identity();
    record.sections = plan->head().facts.sections;
    record.components = plan->head().facts.components;
    record.slabs = slabs;
    record.names = plan->head().component_names;
    record.clusters = made->built.clusters;
    record.report = made->report;
    StagedPiece piece;
    piece.summary = internal::pieces::summary_of(record);
    piece.report = made->report;
    piece.report.slices = slabs.end - slabs.first + 1;
    describe(made->built.model, own.execution.threads, piece.report);
    piece.warnings = std::move(made->warnings);
    whole.model = std::move(made->built.model);
    Result<io::Staged> staged = stage_whole_piece(path, whole, own.encoding, watcher);
    if (!staged) return staged.error();
    piece.files = std::move(staged->files);
    return piece;
  });
}

PieceSummary summary_of(const PieceRecord& record) {
  PieceSummary summary{record.plan, record.slabs.first, record.slabs.end, record.sections, {}};
  for (const ClusterSpan& cluster : record.clusters) {
    if (!cluster.beyond.any()) continue;
    for (std::size_t slab = cluster.slabs.first; slab < cluster.slabs.end; ++slab) {
      summary.open.push_back(slab);
    }
  }
  std::sort(summary.open.begin(), summary.open.end());
  return summary;
}

Result<PieceRecord> piece_record_of(std::string_view file, const std::string& name) {
  const Result<io::PieceBytes> piece = io::piece_bytes(file, name);
  if (!piece) return piece.error();
  return piece_from_record(piece->bytes, name);
}

namespace {

Result<Model> piece_model_of(Result<Model> model, const std::string& path,
                             const PieceRecord& record) {
  if (!model) return model.error();
  if (digest_of(*model) != record.digest) {
    Error error{ErrorCode::invalid_input,
                "the piece is damaged: its solid is not the one that was written",
                {}};
    error.where.file = path;
    return error;
  }
  model->component_count = record.components;
  model->component_names = record.names;
  return model;
}

}  // namespace

Result<Model> piece_model(const std::string& path, const PieceRecord& record) {
  return piece_model_of(read_vtu(path), path, record);
}

Result<io::Staged> stage_whole_piece(const std::string& path, WholePiece& piece, Encoding encoding,
                                     io::TemporaryWatcher* watcher) {
  piece.record.digest = digest_of(piece.model);
  return io::stage_piece(path, piece.model, to_record(piece.record), encoding, watcher);
}

Result<WholePiece> read_whole_piece(const std::string& path) {
  return guard_internal([&]() -> Result<WholePiece> {
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    Result<PieceRecord> record = piece_record_of(*bytes, path);
    if (!record) return record.error();
    Result<Model> model = piece_model_of(parse_vtu(*bytes, path), path, *record);
    if (!model) return model.error();
    return WholePiece{std::move(*record), std::move(*model)};
  });
}

Result<Part> part_of(const std::string& path) {
  return guard_internal([&]() -> Result<Part> {
    std::ifstream file(path, std::ios::binary);
    std::string first(64, '\0');
    file.read(first.data(), static_cast<std::streamsize>(first.size()));
    first.resize(static_cast<std::size_t>(file.gcount()));
    if (begins_as_plan(first)) return Part::plan;
    // Of a large file of another kind no more is read.
    if (first.find('<') == std::string::npos) return Part::none;
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    return io::names_piece(*bytes) ? Part::piece : Part::none;
  });
}

}  // namespace internal::pieces

namespace {

Result<WrittenPlan> commit(Result<pieces::StagedPlan> plan) {
  if (!plan) return plan.error();
  return guard_internal([&]() -> Result<WrittenPlan> {
    if (Result<void> done = io::commit_all(plan->files); !done) return done.error();
    return WrittenPlan{std::move(plan->summary), std::move(plan->warnings)};
  });
}

Result<PlanSummary> summary_of_plan(const pieces::PlanFile& plan) {
  return pieces::summary_of(plan.head(), plan.identity());
}

}  // namespace

Result<WrittenPlan> write_plan(const std::string& path, const SectionStack& stack,
                               const ReconstructOptions& options, const PlanSource& source) {
  return commit(pieces::stage_plan(path, GivenStack(stack), options, source));
}
Result<WrittenPlan> write_plan(const std::string& path, const ValidStack& stack,
                               const ReconstructOptions& options, const PlanSource& source) {
  return commit(pieces::stage_plan(path, GivenStack(stack), options, source));
}
Result<WrittenPlan> write_plan(const std::string& path, SectionStream& sections,
                               const ReconstructOptions& options, const PlanSource& source) {
  return commit(pieces::stage_plan(path, pieces::GivenSections{sections}, options, source));
}

Result<PlanSummary> read_plan(const std::string& path) {
  return guard_internal([&]() -> Result<PlanSummary> {
    const Result<pieces::PlanFile> plan = pieces::PlanFile::open(path);
    if (!plan) return plan.error();
    return summary_of_plan(*plan);
  });
}

Result<PlanSummary> check_plan(const std::string& path) {
  return guard_internal([&]() -> Result<PlanSummary> {
    const Result<pieces::PlanFile> plan = pieces::PlanFile::open(path);
    if (!plan) return plan.error();
    // More take more memory, fewer read more sections twice. Of a single section: 0 and 0.
    constexpr std::size_t kAtOnce = 16;
    std::size_t slab = 0;
    do {
      const SlabRange slabs{slab, std::min(slab + kAtOnce, plan->slabs())};
      const Result<BuiltStack> window = plan->window(slabs);
      if (!window) return window.error();
      slab = slabs.end;
    } while (slab < plan->slabs());
    return summary_of_plan(*plan);
  });
}

Result<WrittenPiece> write_piece(const std::string& path, const std::string& plan,
                                 std::size_t first, std::size_t end, const PieceOptions& options) {
  Result<pieces::StagedPiece> piece = pieces::stage_piece(path, plan, {first, end}, options);
  if (!piece) return piece.error();
  return guard_internal([&]() -> Result<WrittenPiece> {
    if (Result<void> done = io::commit_all(piece->files); !done) return done.error();
    return WrittenPiece{std::move(piece->summary), piece->report, std::move(piece->warnings)};
  });
}

Result<PieceSummary> read_piece(const std::string& path) {
  return guard_internal([&]() -> Result<PieceSummary> {
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    const Result<pieces::PieceRecord> record = pieces::piece_record_of(*bytes, path);
    if (!record) return record.error();
    return pieces::summary_of(*record);
  });
}

Result<PieceSummary> check_piece(const std::string& path) {
  const Result<pieces::WholePiece> piece = pieces::read_whole_piece(path);
  if (!piece) return piece.error();
  return pieces::summary_of(piece->record);
}

}  // namespace tetloft
