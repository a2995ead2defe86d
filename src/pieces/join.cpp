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
#include "model/segment.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/piece_set.hpp"
#include "reconstruct/report_of.hpp"

namespace tetloft {

using namespace internal;

namespace {

using pieces::PieceAt;
using pieces::SettledPieces;
using pieces::Stretch;

Error of_piece(Error error, const PieceAt* piece) {
  if (piece != nullptr) error.where.file = piece->path;
  return error;
}

void report_joined(const std::vector<PieceAt>& all, const ReconstructReport& settled,
                   unsigned threads, Joined& joined) {
  ReconstructReport& sum = joined.report;
  add_up(settled, sum);
  for (const PieceAt& piece : all) add_up(piece.record.report, sum);
  sum.slices = all.front().record.sections;
  sum.input_vertices = static_cast<std::size_t>(
      std::count(joined.model.origin.begin(), joined.model.origin.end(), PointOrigin::input));
  describe(joined.model, threads, sum);
}

Result<Joined> put_together(const std::vector<PieceAt>& all, SettledPieces& settled,
                            unsigned threads) {
  JoinedModel whole;
  Joined joined;
  for (const PieceAt& piece : all) {
    std::optional<Model> left;  // of the piece
    for (const Stretch& stretch : pieces::stretches_of(piece, settled.ranges)) {
      if (stretch.built == nullptr && !left) {
        Result<Model> read = pieces::piece_model(piece.path, piece.record);
        if (!read) return read.error();
        left = std::move(*read);
      }
      if (stretch.built != nullptr) joined.settled += stretch.slabs.end - stretch.slabs.first;
      const Model& from = stretch.built != nullptr ? *stretch.built : *left;
      const Result<void> added = whole.add(from, stretch.slabs);
      if (!added) return of_piece(added.error(), stretch.piece);
    }
  }
  joined.model = whole.take();
  report_joined(all, settled.report, threads, joined);
  joined.warnings = std::move(settled.warnings);
  return joined;
}

}  // namespace

Result<Joined> join_pieces(std::span<const std::string> paths, const JoinOptions& options) {
  return guard_threads(options, [&](const JoinOptions& own) -> Result<Joined> {
    const Result<std::vector<PieceAt>> all = pieces::read_pieces(paths);
    if (!all) return all.error();
    Result<SettledPieces> settled = pieces::settle_pieces(*all, own);
    if (!settled) return settled.error();
    if (settled->whole) {
      Reconstruction& made = *settled->whole;
      return Joined{std::move(made.model), made.report, all->front().record.sections - 1,
                    std::move(made.warnings)};
    }
    return put_together(*all, *settled, own.execution.threads);
  });
}

}  // namespace tetloft
