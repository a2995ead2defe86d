// Pieces become one model.
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/pieces.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "io/files.hpp"
#include "io/stage.hpp"
#include "io/vtu_stream.hpp"
#include "model/segment.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/piece_set.hpp"
#include "reconstruct/report_of.hpp"

namespace tetloft {

using namespace internal;

namespace {

using pieces::PieceAt;
using pieces::SettledPieces;
using pieces::StagedJoin;
using pieces::Stretch;

// An error that names no file is one of the piece: one of writing names what is written.
Error of_piece(Error error, const PieceAt* piece) {
  if (piece != nullptr && error.where.file.empty()) error.where.file = piece->path;
  return error;
}

// add(model, slabs) -> Result<void>, from below; one piece is in memory at a time. Returns how many
// slabs were built by joining.
template <class Add>
Result<std::size_t> for_each_stretch(const std::vector<PieceAt>& all, const SettledPieces& settled,
                                     const Add& add) {
  std::size_t built = 0;
  for (const PieceAt& piece : all) {
    std::optional<Model> left;  // of the piece
    for (const Stretch& stretch : pieces::stretches_of(piece, settled.ranges)) {
      if (stretch.built == nullptr && !left) {
        Result<Model> read = pieces::piece_model(piece.path, piece.record);
        if (!read) return read.error();
        left = std::move(*read);
      }
      if (stretch.built != nullptr) built += stretch.slabs.end - stretch.slabs.first;
      const Model& from = stretch.built != nullptr ? *stretch.built : *left;
      const Result<void> added = add(from, stretch.slabs);
      if (!added) return of_piece(added.error(), stretch.piece);
    }
  }
  return built;
}

// Of all that was built.
ReconstructReport sum_of(const std::vector<PieceAt>& all, const SettledPieces& settled) {
  ReconstructReport sum;
  add_up(settled.report, sum);
  for (const PieceAt& piece : all) add_up(piece.record.report, sum);
  sum.slices = all.front().record.sections;
  return sum;
}

Result<Joined> put_together(const std::vector<PieceAt>& all, SettledPieces& settled,
                            unsigned threads) {
  JoinedModel whole;
  const Result<std::size_t> built = for_each_stretch(
      all, settled,
      [&](const Model& model, const SlabRange& slabs) { return whole.add(model, slabs); });
  if (!built) return built.error();
  Joined joined;
  joined.settled = *built;
  joined.model = whole.take();
  joined.report = sum_of(all, settled);
  joined.report.input_vertices = static_cast<std::size_t>(
      std::count(joined.model.origin.begin(), joined.model.origin.end(), PointOrigin::input));
  describe(joined.model, threads, joined.report);
  joined.warnings = std::move(settled.warnings);
  return joined;
}

Result<Joined> join(const std::vector<PieceAt>& all, SettledPieces& settled, unsigned threads) {
  if (!settled.whole) return put_together(all, settled, threads);
  Reconstruction& made = *settled.whole;
  return Joined{std::move(made.model), made.report, all.front().record.sections - 1,
                std::move(made.warnings)};
}

void add_warnings(const std::vector<Warning>& more, std::vector<Warning>& warnings) {
  warnings.insert(warnings.end(), more.begin(), more.end());
}

// Nothing, and nothing is done, of a model that lies elsewhere than its stack.
Result<std::optional<StagedJoin>> stream_into(const std::string& path,
                                              const std::vector<PieceAt>& all,
                                              const SettledPieces& settled, Encoding encoding,
                                              io::TemporaryWatcher* watcher) {
  io::VtuStream stream(path);
  bool placed = false;
  const Result<std::size_t> built = for_each_stretch(
      all, settled, [&](const Model& model, const SlabRange& slabs) -> Result<void> {
        placed = placed || model.frame != Frame{};
        return placed ? Result<void>() : stream.add(model, slabs);
      });
  if (!built) return built.error();
  if (placed) return std::optional<StagedJoin>();
  StagedJoin joined{sum_of(all, settled), *built, settled.warnings, {}};
  if (Result<void> told = pieces::describe_streamed(stream, joined.report); !told) {
    return told.error();
  }
  Result<io::Staged> file = stream.stage(encoding, watcher);
  if (!file) return file.error();
  add_warnings(file->warnings, joined.warnings);
  joined.files = std::move(file->files);
  return std::optional(std::move(joined));
}

bool is_vtu(const std::string& path, const WriteOptions& writing) {
  return io::extension_of(path) == ".vtu" && (writing.format.empty() || writing.format == "vtu");
}

}  // namespace

Result<Joined> join_pieces(std::span<const std::string> paths, const JoinOptions& options) {
  return guard_threads(options, [&](const JoinOptions& own) -> Result<Joined> {
    const Result<std::vector<PieceAt>> all = pieces::read_pieces(paths);
    if (!all) return all.error();
    Result<SettledPieces> settled = pieces::settle_pieces(*all, own);
    if (!settled) return settled.error();
    return join(*all, *settled, own.execution.threads);
  });
}

Result<StagedJoin> pieces::stage_joined(const std::string& path, std::span<const std::string> paths,
                                        const JoinOptions& options, const WriteOptions& writing,
                                        io::TemporaryWatcher* watcher) {
  return guard_threads(options, [&](const JoinOptions& own) -> Result<StagedJoin> {
    const Result<std::vector<PieceAt>> all = pieces::read_pieces(paths);
    if (!all) return all.error();
    Result<SettledPieces> settled = pieces::settle_pieces(*all, own);
    if (!settled) return settled.error();
    if (!settled->whole && is_vtu(path, writing)) {
      auto streamed = stream_into(path, *all, *settled, writing.encoding, watcher);
      if (!streamed) return streamed.error();
      if (*streamed) return std::move(**streamed);
    }
    Result<Joined> joined = join(*all, *settled, own.execution.threads);
    if (!joined) return joined.error();
    Result<io::Staged> file = io::stage_model(path, joined->model, writing, watcher);
    if (!file) return file.error();
    add_warnings(file->warnings, joined->warnings);
    return StagedJoin{joined->report, joined->settled, std::move(joined->warnings),
                      std::move(file->files)};
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

Result<WrittenJoin> write_joined(const std::string& path, std::span<const std::string> paths,
                                 const JoinOptions& options, const WriteOptions& writing) {
  Result<StagedJoin> joined = pieces::stage_joined(path, paths, options, writing);
  if (!joined) return joined.error();
  return guard_internal([&]() -> Result<WrittenJoin> {
    if (Result<void> done = io::commit_all(joined->files); !done) return done.error();
    return WrittenJoin{joined->report, joined->settled, std::move(joined->warnings)};
  });
}

}  // namespace tetloft
