// Plans, pieces and joined models up to the last step: files that are complete and appear when the
// caller commits them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/pieces.hpp>

#include "io/stage.hpp"
#include "io/vtu_stream.hpp"
#include "pieces/piece_record.hpp"
#include "pieces/plan_head.hpp"
#include "pieces/section_store.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal::pieces {

struct StagedPlan {
  PlanSummary summary;
  std::vector<Warning> warnings;
  std::vector<io::PendingFile> files;
};
/// As write_plan().
[[nodiscard]] Result<StagedPlan> stage_plan(const std::string& path, const GivenStack& given,
                                            const ReconstructOptions& options,
                                            const PlanSource& source,
                                            io::TemporaryWatcher* watcher = nullptr);
[[nodiscard]] Result<StagedPlan> stage_plan(const std::string& path, const GivenSections& given,
                                            const ReconstructOptions& options,
                                            const PlanSource& source,
                                            io::TemporaryWatcher* watcher = nullptr);

struct StagedPiece {
  PieceSummary summary;
  ReconstructReport report;
  std::vector<Warning> warnings;
  std::vector<io::PendingFile> files;
};
/// As write_piece().
[[nodiscard]] Result<StagedPiece> stage_piece(const std::string& path, const std::string& plan,
                                              const SlabRange& slabs, const PieceOptions& options,
                                              io::TemporaryWatcher* watcher = nullptr);

struct StagedJoin {
  ReconstructReport report;
  std::size_t settled = 0;
  std::vector<Warning> warnings;
  std::vector<io::PendingFile> files;
};
/// As write_joined().
[[nodiscard]] Result<StagedJoin> stage_joined(const std::string& path,
                                              std::span<const std::string> paths,
                                              const JoinOptions& options,
                                              const WriteOptions& writing,
                                              io::TemporaryWatcher* watcher = nullptr);

/// What is told of a whole model, as internal::describe(); and its input vertices.
[[nodiscard]] Result<void> describe_streamed(io::VtuStream& stream, ReconstructReport& report);

struct StagedStream {
  ReconstructReport report;
  Model rest;  ///< without points and tets
  std::vector<Warning> warnings;
  std::vector<io::PendingFile> files;
};
/// As write_streamed().
[[nodiscard]] Result<StagedStream> stage_streamed(const std::string& path, const GivenStack& given,
                                                  const ReconstructOptions& options,
                                                  Encoding encoding,
                                                  io::TemporaryWatcher* watcher = nullptr);
[[nodiscard]] Result<StagedStream> stage_streamed(const std::string& path,
                                                  const GivenSections& given,
                                                  const ReconstructOptions& options,
                                                  Encoding encoding,
                                                  io::TemporaryWatcher* watcher = nullptr);

/// Of a stack planned.
[[nodiscard]] PlanHead head_of(const BuiltStack& planned, const SectionStack& stack,
                               const ReconstructOptions& options, const PlanSource& source);
[[nodiscard]] PlanSummary summary_of(const PlanHead& head, std::uint64_t identity);
[[nodiscard]] PieceSummary summary_of(const PieceRecord& record);
/// Of the bytes of a file.
[[nodiscard]] Result<PieceRecord> piece_record_of(std::string_view file, const std::string& name);
/// The solid of the piece that has this record. Refused (invalid_input) where it is not the one
/// that was written.
[[nodiscard]] Result<Model> piece_model(const std::string& path, const PieceRecord& record);

struct WholePiece {
  PieceRecord record;
  Model model;
};
/// Both.
[[nodiscard]] Result<WholePiece> read_whole_piece(const std::string& path);

/// A .vtu of the piece that has this record, whose digest is set.
[[nodiscard]] Result<io::Staged> stage_whole_piece(const std::string& path, WholePiece& piece,
                                                   Encoding encoding,
                                                   io::TemporaryWatcher* watcher);

struct StagedIndex {
  WrittenIndex index;
  std::vector<io::PendingFile> files;
};
/// As write_index().
[[nodiscard]] Result<StagedIndex> stage_index(const std::string& path,
                                              std::span<const std::string> pieces,
                                              const JoinOptions& options,
                                              io::TemporaryWatcher* watcher = nullptr);

/// Whether it is a file whose contents are an index (.pvtu).
[[nodiscard]] bool is_index(const std::string& path);
/// Files of pieces: what each index among these lists, in its place.
[[nodiscard]] Result<std::vector<std::string>> listed_pieces(std::span<const std::string> paths);

/// What a file is, as its contents say; what is cut off or damaged counts, too.
enum class Part : std::uint8_t { none, plan, piece };
[[nodiscard]] Result<Part> part_of(const std::string& path);

}  // namespace tetloft::internal::pieces
