#include "pieces/piece_set.hpp"

#include <algorithm>
#include <utility>

#include "io/files.hpp"
#include "pieces/distinct_warnings.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/plan_file.hpp"
#include "reconstruct/report_of.hpp"

namespace tetloft::internal::pieces {

namespace {

Error piece_set_error(ErrorCode code, const std::string& file, std::string message) {
  Error error{code, std::move(message), {}};
  error.where.file = file;
  return error;
}

Error missing_slabs(const SlabRange& slabs) {
  Error error{ErrorCode::invalid_input, text_of(slabs) + ": there is no piece with it", {}};
  error.where.slab = slabs.first;
  return error;
}

// All of one plan, and each slab in one of them.
Result<void> check_cover(const std::vector<PieceAt>& all) {
  const PieceAt& first = all.front();
  const std::size_t slabs = first.record.sections - 1;
  std::size_t next = 0;
  const PieceAt* below = nullptr;
  for (const PieceAt& piece : all) {
    if (piece.record.plan != first.record.plan || piece.record.sections != first.record.sections) {
      return piece_set_error(ErrorCode::invalid_input, piece.path,
                             "it is a piece of another plan than " + first.path);
    }
    const SlabRange& range = piece.record.slabs;
    if (below != nullptr && (range.first < next || range.first == range.end)) {
      return piece_set_error(ErrorCode::invalid_input, piece.path,
                             text_of({range.first, std::min(range.end, next)}) + " is twice: in " +
                                 below->path + ", too");
    }
    if (range.first > next) return missing_slabs({next, range.first});
    next = std::max(next, range.end);
    below = &piece;
  }
  if (next < slabs) return missing_slabs({next, slabs});
  return {};
}

// Links have to be decided anew, which takes all of the stack.
Result<Reconstruction> build_whole(const PlanFile& plan, const Execution& execution) {
  Result<SectionStack> stack = plan.stack();
  if (!stack) return stack.error();
  ReconstructOptions options = plan.head().options;
  options.execution = execution;
  return reconstruct(*stack, options);
}

}  // namespace

std::string text_of(const SlabRange& slabs) {
  return slabs.end == slabs.first + 1
             ? "slab " + std::to_string(slabs.first)
             : "slabs " + std::to_string(slabs.first) + ':' + std::to_string(slabs.end);
}

Result<void> sort_by_slabs(std::vector<PieceAt>& all) {
  std::stable_sort(all.begin(), all.end(), [](const PieceAt& a, const PieceAt& b) {
    return a.record.slabs.first < b.record.slabs.first;
  });
  return check_cover(all);
}

Result<void> check_closed(const std::vector<PieceAt>& all) {
  for (const PieceAt& piece : all) {
    for (const ClusterSpan& cluster : piece.record.clusters) {
      if (!cluster.beyond.any()) continue;
      return piece_set_error(
          ErrorCode::usage, piece.path,
          text_of(cluster.slabs) +
              " was left open where the stack was cut: join the pieces, or list them in an index");
    }
  }
  return {};
}

Result<std::vector<PieceAt>> read_pieces(std::span<const std::string> paths) {
  if (paths.empty()) return Error{ErrorCode::usage, "there is no piece to join", {}};
  const Result<std::vector<std::string>> files = listed_pieces(paths);
  if (!files) return files.error();
  std::vector<PieceAt> all;
  for (const std::string& path : *files) {
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    Result<PieceRecord> record = piece_record_of(*bytes, path);
    if (!record) return record.error();
    all.push_back({path, std::move(*record)});
  }
  if (Result<void> whole = sort_by_slabs(all); !whole) return whole.error();
  return all;
}

Result<SettledPieces> settle_pieces(const std::vector<PieceAt>& all, const JoinOptions& options) {
  SettledPieces done;
  std::vector<ClusterSpan> clusters;
  const ClusterSpan* open = nullptr;
  for (const PieceAt& piece : all) {
    for (const ClusterSpan& cluster : piece.record.clusters) {
      if (cluster.beyond.any() && open == nullptr) open = &cluster;
      clusters.push_back(cluster);
    }
  }
  if (open == nullptr) return done;
  if (options.plan.empty()) {
    return Error{ErrorCode::usage,
                 text_of(open->slabs) +
                     " was left open where the stack was cut: the plan is needed to build it "
                     "(--plan)",
                 {}};
  }
  Result<PlanFile> plan = PlanFile::open(options.plan);
  if (!plan) return plan.error();
  const PieceRecord& any = all.front().record;
  if (plan->identity() != any.plan || plan->head().facts.sections != any.sections) {
    return piece_set_error(ErrorCode::usage, options.plan, "it is not the plan of these pieces");
  }
  DistinctWarnings warnings;
  Result<Settled> settled =
      settle(any.sections - 1, clusters, [&](const SlabRange& slabs) -> Result<BuiltRange> {
        Result<PlannedRange> made = build_range(*plan, slabs, options.execution);
        if (!made) return made.error();
        add_up(made->report, done.report);
        warnings.add(std::move(made->warnings));
        return std::move(made->built);
      });
  if (!settled) return settled.error();
  if (settled->whole) {
    Result<Reconstruction> whole = build_whole(*plan, options.execution);
    if (!whole) return whole.error();
    done.whole = std::move(*whole);
    return done;
  }
  done.ranges = std::move(settled->ranges);
  done.warnings = warnings.all();
  return done;
}

std::vector<Stretch> stretches_of(const PieceAt& piece, const std::vector<BuiltRange>& ranges) {
  std::vector<Stretch> all;
  std::size_t at = piece.record.slabs.first;
  const std::size_t end = piece.record.slabs.end;
  for (const BuiltRange& made : ranges) {
    if (made.slabs.end <= at || made.slabs.first >= end) continue;
    if (made.slabs.first > at) all.push_back({{at, made.slabs.first}, &piece, nullptr});
    const SlabRange part{std::max(at, made.slabs.first), std::min(end, made.slabs.end)};
    all.push_back({part, nullptr, &made.model});
    at = part.end;
  }
  if (at < end || piece.record.sections == 1) all.push_back({{at, end}, &piece, nullptr});
  return all;
}

}  // namespace tetloft::internal::pieces
