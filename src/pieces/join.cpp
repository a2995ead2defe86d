// Pieces become one model.
#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <tetloft/formats.hpp>
#include <tetloft/pieces.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "io/files.hpp"
#include "io/stage.hpp"
#include "io/vtu_stream.hpp"
#include "model/segment.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/plan_file.hpp"
#include "reconstruct/report_of.hpp"

namespace tetloft {

using namespace internal;

namespace {

using pieces::PieceRecord;
using pieces::PlanFile;
using pieces::PlannedRange;
using pieces::StagedJoin;

std::string text_of(const SlabRange& slabs) {
  return slabs.end == slabs.first + 1
             ? "slab " + std::to_string(slabs.first)
             : "slabs " + std::to_string(slabs.first) + ':' + std::to_string(slabs.end);
}

Error join_error(ErrorCode code, const std::string& file, std::string message) {
  Error error{code, std::move(message), {}};
  error.where.file = file;
  return error;
}

struct PieceAt {
  std::string path;
  PieceRecord record;
};

// A stretch of slabs and where its model is.
struct Stretch {
  SlabRange slabs;
  const PieceAt* piece = nullptr;  // or
  const Model* built = nullptr;
};

class Joining {
 public:
  Joining(std::span<const std::string> paths, const JoinOptions& options)
      : paths_(paths), options_(options) {}

  Result<Joined> join() {
    if (Result<void> ready = prepare(); !ready) return ready.error();
    return whole_ ? std::move(*whole_) : in_memory();
  }

  Result<StagedJoin> write(const std::string& path, const WriteOptions& writing,
                           io::TemporaryWatcher* watcher) {
    if (Result<void> ready = prepare(); !ready) return ready.error();
    if (!whole_ && io::extension_of(path) == ".vtu" &&
        (writing.format.empty() || writing.format == "vtu")) {
      io::VtuStream stream(path);
      Result<bool> streamed = into(stream);
      if (!streamed) return streamed.error();
      if (*streamed) return staged(stream, writing.encoding, watcher);
    }
    Result<Joined> joined = whole_ ? Result<Joined>(std::move(*whole_)) : in_memory();
    if (!joined) return joined.error();
    Result<io::Staged> file = io::stage_model(path, joined->model, writing, watcher);
    if (!file) return file.error();
    add_warnings(file->warnings, joined->warnings);
    return StagedJoin{joined->report, joined->settled, std::move(joined->warnings),
                      std::move(file->files)};
  }

 private:
  Result<void> prepare() {
    if (Result<void> read = read_records(); !read) return read.error();
    if (Result<void> whole = check_cover(); !whole) return whole.error();
    return settle_open();
  }

  Result<void> read_records() {
    if (paths_.empty()) return Error{ErrorCode::usage, "there is no piece to join", {}};
    for (const std::string& path : paths_) {
      const Result<std::string> bytes = io::read_file(path);
      if (!bytes) return bytes.error();
      Result<PieceRecord> record = pieces::piece_record_of(*bytes, path);
      if (!record) return record.error();
      pieces_.push_back({path, std::move(*record)});
    }
    std::stable_sort(pieces_.begin(), pieces_.end(), [](const PieceAt& a, const PieceAt& b) {
      return a.record.slabs.first < b.record.slabs.first;
    });
    return {};
  }

  // All of one plan, and each slab in one of them.
  Result<void> check_cover() {
    const PieceAt& first = pieces_.front();
    const std::size_t slabs = first.record.sections - 1;
    std::size_t next = 0;
    const PieceAt* below = nullptr;
    for (const PieceAt& piece : pieces_) {
      if (piece.record.plan != first.record.plan ||
          piece.record.sections != first.record.sections) {
        return join_error(ErrorCode::invalid_input, piece.path,
                          "it is a piece of another plan than " + first.path);
      }
      const SlabRange& range = piece.record.slabs;
      if (below != nullptr && range.first < next) {
        return join_error(ErrorCode::invalid_input, piece.path,
                          text_of({range.first, std::min(range.end, next)}) + " is twice: in " +
                              below->path + ", too");
      }
      if (range.first > next) return missing({next, range.first});
      next = std::max(next, range.end);
      below = &piece;
    }
    if (next < slabs) return missing({next, slabs});
    return {};
  }

  [[nodiscard]] static Error missing(const SlabRange& slabs) {
    Error error{ErrorCode::invalid_input, text_of(slabs) + ": there is no piece with it", {}};
    error.where.slab = slabs.first;
    return error;
  }

  [[nodiscard]] const PieceRecord& any() const { return pieces_.front().record; }

  Result<void> settle_open() {
    std::vector<ClusterSpan> clusters;
    const ClusterSpan* open = nullptr;
    for (const PieceAt& piece : pieces_) {
      for (const ClusterSpan& cluster : piece.record.clusters) {
        if (cluster.beyond.any() && open == nullptr) open = &cluster;
        clusters.push_back(cluster);
      }
    }
    if (open == nullptr) return {};
    if (options_.plan.empty()) {
      return Error{ErrorCode::usage,
                   text_of(open->slabs) +
                       " was left open where the stack was cut: the plan is needed to build it "
                       "(--plan)",
                   {}};
    }
    Result<PlanFile> plan = PlanFile::open(options_.plan);
    if (!plan) return plan.error();
    if (plan->identity() != any().plan) {
      return join_error(ErrorCode::usage, options_.plan, "it is not the plan of these pieces");
    }
    Result<Settled> settled =
        settle(any().sections - 1, clusters, [&](const SlabRange& slabs) -> Result<BuiltRange> {
          Result<PlannedRange> made = pieces::build_range(*plan, slabs, options_.execution);
          if (!made) return made.error();
          reports_.push_back(made->report);
          warnings_.insert(warnings_.end(), made->warnings.begin(), made->warnings.end());
          return std::move(made->built);
        });
    if (!settled) return settled.error();
    if (settled->whole) return build_whole(*plan);
    ranges_ = std::move(settled->ranges);
    return {};
  }

  // Links have to be decided anew, which takes all of the stack.
  Result<void> build_whole(const PlanFile& plan) {
    Result<SectionStack> stack = plan.stack();
    if (!stack) return stack.error();
    ReconstructOptions options = plan.head().options;
    options.execution = options_.execution;
    Result<Reconstruction> made = reconstruct(*stack, options);
    if (!made) return made.error();
    whole_ = Joined{std::move(made->model), made->report, plan.slabs(), std::move(made->warnings)};
    return {};
  }

  // From below: of each piece what was not built anew.
  [[nodiscard]] std::vector<Stretch> stretches() const {
    std::vector<Stretch> all;
    for (const BuiltRange& made : ranges_) all.push_back({made.slabs, nullptr, &made.model});
    for (const PieceAt& piece : pieces_) {
      std::size_t at = piece.record.slabs.first;
      const std::size_t end = piece.record.slabs.end;
      for (const BuiltRange& made : ranges_) {
        if (made.slabs.end <= at || made.slabs.first >= end) continue;
        if (made.slabs.first > at) all.push_back({{at, made.slabs.first}, &piece, nullptr});
        at = made.slabs.end;
      }
      if (at < end || any().sections == 1) all.push_back({{at, end}, &piece, nullptr});
    }
    std::sort(all.begin(), all.end(),
              [](const Stretch& a, const Stretch& b) { return a.slabs.first < b.slabs.first; });
    return all;
  }

  // add(model, slabs) -> Result<void>, from below. One piece is in memory at a time.
  template <class Add>
  Result<void> for_each_stretch(const Add& add) {
    Model model;
    const PieceAt* open = nullptr;  // whose model this is
    for (const Stretch& stretch : stretches()) {
      if (stretch.piece != nullptr && stretch.piece != open) {
        model = {};
        Result<Model> read = read_vtu(stretch.piece->path);
        if (!read) return read.error();
        model = std::move(*read);
        model.component_count = any().components;
        open = stretch.piece;
      }
      const Model& from = stretch.built != nullptr ? *stretch.built : model;
      const Result<void> added = add(from, stretch.slabs);
      if (added) continue;
      Error error = added.error();
      if (stretch.piece != nullptr && error.where.file.empty()) {
        error.where.file = stretch.piece->path;
      }
      return error;
    }
    return {};
  }

  [[nodiscard]] std::size_t settled() const {
    std::size_t slabs = 0;
    for (const BuiltRange& made : ranges_) slabs += made.slabs.end - made.slabs.first;
    return slabs;
  }

  Result<Joined> in_memory() {
    JoinedModel whole;
    const Result<void> added = for_each_stretch(
        [&](const Model& model, const SlabRange& slabs) { return whole.add(model, slabs); });
    if (!added) return added.error();
    Joined joined;
    joined.settled = settled();
    joined.model = whole.take();
    joined.model.component_names = any().names;
    joined.report = sums();
    joined.report.input_vertices = static_cast<std::size_t>(
        std::count(joined.model.origin.begin(), joined.model.origin.end(), PointOrigin::input));
    describe(joined.model, options_.execution.threads, joined.report);
    joined.warnings = std::move(warnings_);
    return joined;
  }

  // False, and nothing is done, of a model that lies elsewhere than its stack.
  Result<bool> into(io::VtuStream& stream) {
    bool placed = false;
    const Result<void> added =
        for_each_stretch([&](const Model& model, const SlabRange& slabs) -> Result<void> {
          placed = placed || model.frame != Frame{};
          return placed ? Result<void>() : stream.add(model, slabs);
        });
    if (!added) return added.error();
    stream.rest().component_names = any().names;
    return !placed;
  }

  Result<StagedJoin> staged(io::VtuStream& stream, Encoding encoding,
                            io::TemporaryWatcher* watcher) {
    StagedJoin joined{sums(), settled(), std::move(warnings_), {}};
    const Result<void> told = pieces::describe_streamed(stream, joined.report);
    if (!told) return told.error();
    Result<io::Staged> file = stream.stage(encoding, watcher);
    if (!file) return file.error();
    add_warnings(file->warnings, joined.warnings);
    joined.files = std::move(file->files);
    return joined;
  }

  static void add_warnings(const std::vector<Warning>& more, std::vector<Warning>& warnings) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  }

  // Of all that was built.
  [[nodiscard]] ReconstructReport sums() const {
    ReconstructReport sum;
    for (const ReconstructReport& part : reports_) add_up(part, sum);
    for (const PieceAt& piece : pieces_) add_up(piece.record.report, sum);
    sum.slices = any().sections;
    return sum;
  }

  std::span<const std::string> paths_;
  const JoinOptions& options_;
  std::vector<PieceAt> pieces_;  // by slabs
  std::vector<BuiltRange> ranges_;
  std::vector<ReconstructReport> reports_;
  std::vector<Warning> warnings_;
  std::optional<Joined> whole_;
};

}  // namespace

Result<pieces::StagedJoin> pieces::stage_joined(const std::string& path,
                                                std::span<const std::string> paths,
                                                const JoinOptions& options,
                                                const WriteOptions& writing,
                                                io::TemporaryWatcher* watcher) {
  return guard_threads(options, [&](const JoinOptions& own) -> Result<StagedJoin> {
    return Joining(paths, own).write(path, writing, watcher);
  });
}

Result<void> pieces::describe_streamed(io::VtuStream& stream, ReconstructReport& report) {
  const Result<io::VtuStream::Figures> figures = stream.figures();
  if (!figures) return figures.error();
  report.vertices = figures->vertices;
  report.tets = figures->tets;
  report.components = stream.rest().component_count;
  report.volume = figures->volume;
  report.input_vertices = figures->input_vertices;
  report.split_vertices = figures->split_vertices;
  report.work += figures->split_vertices;
  return {};
}

Result<WrittenJoin> write_joined(const std::string& path, std::span<const std::string> pieces,
                                 const JoinOptions& options, const WriteOptions& writing) {
  Result<pieces::StagedJoin> joined = pieces::stage_joined(path, pieces, options, writing);
  if (!joined) return joined.error();
  return guard_internal([&]() -> Result<WrittenJoin> {
    if (Result<void> done = io::commit_all(joined->files); !done) return done.error();
    return WrittenJoin{joined->report, joined->settled, std::move(joined->warnings)};
  });
}

Result<Joined> join_pieces(std::span<const std::string> pieces, const JoinOptions& options) {
  return guard_threads(options, [&](const JoinOptions& own) -> Result<Joined> {
    return Joining(pieces, own).join();
  });
}

}  // namespace tetloft
