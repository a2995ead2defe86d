// What an index over pieces lists.
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/pieces.hpp>

#include "core/guard.hpp"
#include "io/files.hpp"
#include "io/vtu_piece.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/piece_set.hpp"

namespace tetloft {

using namespace internal;

namespace {

// The record, too, where the piece has a sound one.
ListedPiece read_listed(const std::string& path, std::vector<pieces::PieceAt>& sound) {
  ListedPiece listed;
  listed.path = path;
  const auto told = [&]() -> Result<void> {
    const Result<std::string> file = io::read_file(path);
    if (!file) return file.error();
    const Result<io::PieceBytes> head = io::piece_bytes(*file, path);
    if (!head) return head.error();
    Result<pieces::PieceRecord> record = pieces::piece_from_record(head->bytes, path);
    if (!record) return record.error();
    listed.piece = pieces::summary_of(*record);
    listed.vertices = head->points;
    listed.tets = head->tets;
    sound.push_back({path, std::move(*record)});
    return {};
  }();
  if (!told) listed.wrong = told.error();
  return listed;
}

}  // namespace

Result<IndexSummary> read_index(const std::string& path) {
  return guard_internal([&]() -> Result<IndexSummary> {
    if (!pieces::is_index(path)) {
      Error error{ErrorCode::invalid_input, "it is no index over pieces (.pvtu)", {}};
      error.where.file = path;
      return error;
    }
    const Result<std::vector<std::string>> paths = pieces::listed_pieces(std::span(&path, 1));
    if (!paths) return paths.error();
    IndexSummary index;
    std::vector<pieces::PieceAt> sound;
    for (const std::string& listed : *paths) {
      index.pieces.push_back(read_listed(listed, sound));
      if (!index.wrong) index.wrong = index.pieces.back().wrong;
    }
    if (index.wrong) return index;
    Result<void> whole = pieces::sort_by_slabs(sound);
    if (whole) whole = pieces::check_closed(sound);
    if (!whole) index.wrong = whole.error();
    return index;
  });
}

}  // namespace tetloft
