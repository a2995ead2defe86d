// All pieces of a stack: what joining them and listing them have in common.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tetloft/pieces.hpp>
#include <tetloft/reconstruct.hpp>

#include "pieces/piece_record.hpp"
#include "reconstruct/settle.hpp"

namespace tetloft::internal::pieces {

struct PieceAt {
  std::string path;
  PieceRecord record;
};

/// What these, and those that indices among them list, say of themselves, by slabs. Refused
/// (invalid_input), naming files and slabs, where they are of different plans, overlap, or leave
/// slabs out; (usage) where there are none.
[[nodiscard]] Result<std::vector<PieceAt>> read_pieces(std::span<const std::string> paths);

/// Refused as above where they are not of one plan, or not all slabs of it are there, each once.
[[nodiscard]] Result<void> sort_by_slabs(std::vector<PieceAt>& all);
/// Refused (usage) where slabs are left open.
[[nodiscard]] Result<void> check_closed(const std::vector<PieceAt>& all);

/// What was left open, built from the plan.
struct SettledPieces {
  std::vector<BuiltRange> ranges;  ///< disjoint, by slab, in the place of what the pieces have
  /// Where links had to be decided anew: all of the stack instead.
  std::optional<Reconstruction> whole;
  ReconstructReport report;  ///< of all that was built on the way to `ranges`
  std::vector<Warning> warnings;
};
/// Nothing where nothing is open. Refused (usage) where something is, and the options name no plan,
/// or another one.
[[nodiscard]] Result<SettledPieces> settle_pieces(const std::vector<PieceAt>& all,
                                                  const JoinOptions& options);

/// Slabs, and where their solid is: in a piece, or in what was built.
struct Stretch {
  SlabRange slabs;
  const PieceAt* piece = nullptr;  // or
  const Model* built = nullptr;
};
/// Of a piece, from below; a range that goes on in other pieces is cut off.
[[nodiscard]] std::vector<Stretch> stretches_of(const PieceAt& piece,
                                                const std::vector<BuiltRange>& ranges);

/// "slab 3", "slabs 3:7".
[[nodiscard]] std::string text_of(const SlabRange& slabs);

}  // namespace tetloft::internal::pieces
