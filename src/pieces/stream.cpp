// A stack built in one process, its solid never in memory: windows of the plan in turn, some at
// once, each appended to the stream below the next. What a window leaves open is settled at once,
// over its ends; where that reaches below what was appended already, the stream goes back.
#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <tetloft/pieces.hpp>

#include "core/guard.hpp"
#include "core/pages.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "io/files.hpp"
#include "io/vtu_stream.hpp"
#include "pieces/distinct_warnings.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/plan_file.hpp"
#include "pieces/planner.hpp"
#include "reconstruct/report_of.hpp"

namespace tetloft {

using namespace internal;

namespace {

using pieces::PlanFile;
using pieces::PlannedRange;
using pieces::PlannedStack;
using pieces::SectionStore;
using pieces::StagedStream;

// More make each chunk's memory larger, fewer conform more sections twice, at both ends of windows.
constexpr std::size_t kWindowSlabs = 16;
constexpr std::size_t kLeastWindow = 4;
constexpr std::size_t kWindowsOfThread = 2;

class Streaming {
 public:
  Streaming(const PlanFile& plan, io::VtuStream& stream, const Execution& execution,
            WatchedWork& work)
      : plan_(plan),
        stream_(stream),
        threads_(thread_count(execution.threads)),
        work_(work),
        alone_(untold(execution)) {
    const std::size_t windows = kWindowsOfThread * threads_;
    window_ = std::clamp((plan.slabs() + windows - 1) / windows, kLeastWindow, kWindowSlabs);
    alone_.threads = 1;
  }

  // False: not so, but with all of the stack at once, or in another unit (loses_bits()).
  Result<bool> run() {
    std::vector<SlabRange> windows =
        plan_.slabs() == 0 ? std::vector<SlabRange>{{0, 0}} : windows_from(0);
    std::vector<Made> made = build(windows, [] {});
    for (;;) {
      Result<std::vector<BuiltRange>> built = take_all(std::move(made));
      if (!built) return or_false(built.error());
      // The next ones are built while these are appended.
      std::vector<SlabRange> next = windows_from(windows.back().end);
      std::optional<Result<bool>> appended;
      made = build(next, [&] {
        appended = settle_and_append(*built, windows.back().end);
        built->clear();
      });
      if (!*appended || !**appended) return *appended;
      if (stream_.slabs() == plan_.slabs()) return true;
      if (stream_.slabs() != windows.back().end) {  // what was settled reaches into them
        next = windows_from(stream_.slabs());
        made = build(next, [] {});
      }
      windows = std::move(next);
    }
  }

  [[nodiscard]] bool loses_bits() const { return loses_bits_; }
  [[nodiscard]] const ReconstructReport& report() const { return report_; }
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_.all(); }

 private:
  // Nothing where a coordinate would lose bits.
  using Made = std::optional<Result<std::optional<PlannedRange>>>;

  // None where no slab is left.
  [[nodiscard]] std::vector<SlabRange> windows_from(std::size_t slab) const {
    std::vector<SlabRange> windows;
    for (std::size_t k = 0; k < kWindowsOfThread * threads_ && slab < plan_.slabs(); ++k) {
      windows.push_back({slab, std::min(slab + window_, plan_.slabs())});
      slab = windows.back().end;
    }
    return windows;
  }

  // Windows next to each other, which end at slab `end`.
  Result<bool> settle_and_append(const std::vector<BuiltRange>& windows, std::size_t end) {
    bool any_open = false;
    for (const BuiltRange& window : windows) {
      for (const ClusterSpan& cluster : window.clusters) {
        any_open = any_open || cluster.beyond.any();
        clusters_.push_back(cluster);
      }
    }
    Settled settled;
    if (any_open) {
      Result<Settled> all = settle(plan_.slabs(), clusters_,
                                   [&](const SlabRange& slabs) { return build_one(slabs); });
      if (!all) return or_false(all.error());
      if (all->whole) return false;
      settled = std::move(*all);
      clusters_ = std::move(settled.clusters);
    }
    const Result<void> appended = append(windows, settled.ranges, end);
    if (!appended) return or_false(appended.error());
    return true;
  }

  Result<bool> or_false(const Error& error) const {
    if (loses_bits_) return false;
    return error;
  }

  // Each on one thread; on another, if there are several, what is to be done meanwhile.
  std::vector<Made> build(const std::vector<SlabRange>& windows,
                          const std::function<void()>& meanwhile) {
    std::vector<Made> made(windows.size());
    parallel_for(windows.size() + 1, threads_, [&](std::size_t k) {
      if (k == 0) return meanwhile();
      const SlabRange& slabs = windows[k - 1];
      made[k - 1].emplace(pieces::try_range(plan_, slabs, alone_));
      for (std::size_t slab = slabs.first; slab < slabs.end; ++slab) {
        if (told_ <= slab) work_.step_done();
      }
      work_.go_on();
    });
    if (!windows.empty()) told_ = std::max(told_, windows.back().end);
    return made;
  }

  Result<std::vector<BuiltRange>> take_all(std::vector<Made> made) {
    std::vector<BuiltRange> built;
    for (Made& window : made) {
      Result<BuiltRange> one = take(*std::move(window));
      if (!one) return one.error();
      built.push_back(std::move(*one));
    }
    return built;
  }

  Result<BuiltRange> build_one(const SlabRange& slabs) {
    work_.go_on();
    return take(pieces::try_range(plan_, slabs, alone_));
  }

  Result<BuiltRange> take(Result<std::optional<PlannedRange>> made) {
    if (!made) return made.error();
    if (!*made) {
      loses_bits_ = true;
      return Error{ErrorCode::unrepresentable, "", {}};  // which nobody hears of
    }
    PlannedRange& range = **made;
    add_up(range.report, report_);
    warnings_.add(std::move(range.warnings));
    return std::move(range.built);
  }

  // The windows up to slab `end`, but for what is in ranges, which may reach over both ends.
  Result<void> append(const std::vector<BuiltRange>& windows, const std::vector<BuiltRange>& ranges,
                      std::size_t end) {
    if (!ranges.empty()) stream_.back_to(ranges.front().slabs.first);
    for (const BuiltRange& range : ranges) {
      Result<void> done = append_up_to(range.slabs.first, windows);
      if (done) done = stream_.add(range.model, range.slabs);
      if (!done) return done;
    }
    if (plan_.slabs() == 0) return stream_.add(windows.front().model, {0, 0});
    return append_up_to(end, windows);
  }

  // What is in no window was appended before the stream went back: it is built again.
  Result<void> append_up_to(std::size_t end, const std::vector<BuiltRange>& windows) {
    for (const BuiltRange& window : windows) {
      Result<void> done = append_again(std::min(end, window.slabs.first));
      const SlabRange rest{stream_.slabs(), std::min(end, window.slabs.end)};
      if (done && rest.first < rest.end) done = stream_.add(window.model, rest);
      if (!done) return done;
    }
    return append_again(end);
  }

  Result<void> append_again(std::size_t end) {
    if (stream_.slabs() >= end) return {};
    const SlabRange slabs{stream_.slabs(), end};
    const Result<BuiltRange> again = build_one(slabs);
    if (!again) return again.error();
    return stream_.add(again->model, slabs);
  }

  const PlanFile& plan_;
  io::VtuStream& stream_;
  unsigned threads_;
  WatchedWork& work_;
  Execution alone_;
  std::size_t window_ = 0;  // slabs
  std::size_t told_ = 0;    // slabs whose steps were told
  bool loses_bits_ = false;
  std::vector<ClusterSpan> clusters_;
  ReconstructReport report_;
  pieces::DistinctWarnings warnings_;
};

using Clock = std::chrono::steady_clock;

// The plan in a scratch file.
struct ScratchPlan {
  PlanFile file;
  std::vector<Warning> warnings;
  StepSeconds seconds{};
};

Result<ScratchPlan> scratch_plan(const std::string& path, const SectionStore& store, Unit unit,
                                 const ReconstructOptions& options, WatchedWork& work) {
  io::ScratchFile scratch(path);
  Result<PlannedStack> planned = pieces::plan_stored(store, unit, options, {}, path, work, scratch);
  if (!planned) return planned.error();
  if (scratch.failure()) return *scratch.failure();
  Result<PlanFile> file = PlanFile::of(pieces::ArchiveReader::of(std::move(scratch), path), path);
  if (!file) return file.error();
  return ScratchPlan{std::move(*file), std::move(planned->warnings), planned->seconds};
}

class StreamedStack {
 public:
  StreamedStack(const std::string& path, const SectionStore& store, Clock::time_point start,
                Encoding encoding, io::TemporaryWatcher* watcher)
      : path_(path), store_(store), start_(start), encoding_(encoding), watcher_(watcher) {}

  // Nothing where the model, made in this unit, is none in the one given.
  Result<std::optional<StagedStream>> stage_in(Unit unit, const ReconstructOptions& options) {
    WatchedWork work(options.execution, 2 * store_.size() - 1);  // sections planned, slabs built
    Result<ScratchPlan> plan = scratch_plan(path_, store_, unit, options, work);
    if (!plan) return plan.error();
    StagedStream made;
    made.warnings = std::move(plan->warnings);
    made.report.seconds = plan->seconds;
    core::give_back_freed();
    io::VtuStream stream(path_);
    Streaming streaming(plan->file, stream, options.execution, work);
    Result<bool> streamed = streaming.run();
    if (!streamed) return streamed.error();
    if (!*streamed && streaming.loses_bits()) return std::optional<StagedStream>();
    if (!*streamed) {
      ReconstructOptions again = options;
      again.execution = untold(options.execution);
      return in_memory(again);
    }
    add_up(streaming.report(), made.report);
    made.report.slices = store_.size();
    made.report.contours = store_.contours();
    made.warnings.insert(made.warnings.end(), streaming.warnings().begin(),
                         streaming.warnings().end());
    if (Result<void> told = pieces::describe_streamed(stream, made.report); !told) {
      return told.error();
    }
    made.report.seconds_total = std::chrono::duration<double>(Clock::now() - start_).count();
    Result<io::Staged> file = stream.stage(encoding_, watcher_);
    if (!file) return file.error();
    take(std::move(*file), made);
    made.rest = std::move(stream.rest());
    return std::optional(std::move(made));
  }

  Result<std::optional<StagedStream>> in_memory(const ReconstructOptions& options) {
    const Result<ValidStack> stack = store_.stack();
    if (!stack) return stack.error();
    Result<Reconstruction> whole = reconstruct(*stack, options);
    if (!whole) return whole.error();
    Result<io::Staged> file = io::stage_model(path_, whole->model, {encoding_, {}}, watcher_);
    if (!file) return file.error();
    StagedStream made{whole->report, std::move(whole->model), std::move(whole->warnings), {}};
    take(std::move(*file), made);
    return std::optional(std::move(made));
  }

 private:
  static void take(io::Staged file, StagedStream& made) {
    made.warnings.insert(made.warnings.end(), file.warnings.begin(), file.warnings.end());
    made.files = std::move(file.files);
  }

  const std::string& path_;
  const SectionStore& store_;
  Clock::time_point start_;
  Encoding encoding_;
  io::TemporaryWatcher* watcher_;
};

Result<WrittenStream> commit_stream(Result<StagedStream> made) {
  if (!made) return made.error();
  return guard_internal([&]() -> Result<WrittenStream> {
    if (Result<void> done = io::commit_all(made->files); !done) return done.error();
    return WrittenStream{made->report, std::move(made->warnings)};
  });
}

}  // namespace

Result<StagedStream> pieces::stage_streamed(const std::string& path, const GivenStack& given,
                                            const ReconstructOptions& options, Encoding encoding,
                                            io::TemporaryWatcher* watcher) {
  StackStream sections(*given.stack);
  return stage_streamed(path, GivenSections{sections, given.nestings}, options, encoding, watcher);
}

Result<StagedStream> pieces::stage_streamed(const std::string& path, const GivenSections& given,
                                            const ReconstructOptions& options, Encoding encoding,
                                            io::TemporaryWatcher* watcher) {
  if (io::extension_of(path) != ".vtu") {
    Error error{ErrorCode::usage, "a stream is written as .vtu", {}};
    error.where.file = path;
    return error;
  }
  if (auto error = check_options(options)) return *error;
  const auto start = Clock::now();
  const Result<SectionStore> store = SectionStore::of(given, options.execution, path);
  if (!store) return store.error();
  return in_either_unit(options, [&](Unit unit, const ReconstructOptions& in_unit) {
    StreamedStack stack(path, *store, start, encoding, watcher);
    return store->frame() == Frame{} ? stack.stage_in(unit, in_unit) : stack.in_memory(in_unit);
  });
}

Result<WrittenStream> write_streamed(const std::string& path, const SectionStack& stack,
                                     const ReconstructOptions& options, Encoding encoding) {
  return commit_stream(pieces::stage_streamed(path, GivenStack(stack), options, encoding));
}
Result<WrittenStream> write_streamed(const std::string& path, const ValidStack& stack,
                                     const ReconstructOptions& options, Encoding encoding) {
  return commit_stream(pieces::stage_streamed(path, GivenStack(stack), options, encoding));
}
Result<WrittenStream> write_streamed(const std::string& path, SectionStream& sections,
                                     const ReconstructOptions& options, Encoding encoding) {
  return commit_stream(
      pieces::stage_streamed(path, pieces::GivenSections{sections}, options, encoding));
}

}  // namespace tetloft
