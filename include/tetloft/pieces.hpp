// Stacks beyond one machine: what has to be decided over the whole stack is decided once, as a
// plan; pieces of it, some slabs each, are built from the plan anywhere, in any order; joined they
// are the model of the single run, bit for bit, however the stack was cut.
//
// A plan is a file with the sections and all that was decided about them; of it a piece reads its
// own part alone. A piece is a .vtu that any tool reads: the solid of its slabs, with numbers of
// slabs, sections and components of the whole stack, and what joining needs as data of the whole.
// Both say which plan they are of. Files appear complete or not at all.
//
// A slab may need finer contours in a section that it shares with the next piece. Such slabs are
// left open, and joining builds them from the plan, with all that they touch: the solids of others
// do not depend on them (src/reconstruct/README.md, "Clusters").
//
// Errors: io where a file cannot be read or written; invalid_input, naming the file, where it is no
// plan or piece, is damaged or of another version.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/formats.hpp>
#include <tetloft/io.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/section_stream.hpp>
#include <tetloft/valid_stack.hpp>

namespace tetloft {

/// The file that a planned stack was read from, so that another one is not taken for it. Empty: it
/// came from none.
struct PlanSource {
  std::string name;  ///< without folders
  std::uint64_t bytes = 0;
  std::uint64_t checksum = 0;
  std::uint64_t sampled = 0;  ///< checksum of parts of it, all over the file, some MiB in all
  friend bool operator==(const PlanSource&, const PlanSource&) = default;
};
/// Of a file as it is now. Reads all of it.
[[nodiscard]] TETLOFT_API Result<PlanSource> plan_source(const std::string& path);

/// What a plan is about.
struct PlanSummary {
  /// Of two plans of one file by the same options the same.
  std::uint64_t identity = 0;
  PlanSource source;
  ReconstructOptions options;  ///< as it was made with; the execution is not kept
  std::size_t sections = 0;
  std::size_t contours = 0;
  std::size_t vertices = 0;
  double lowest = 0;   ///< z of the first section
  double highest = 0;  ///< of the last
  std::size_t components = 0;
  std::size_t cavities = 0;  ///< that are decided; 0 by VoidRule::free
};

struct WrittenPlan {
  PlanSummary summary;
  std::vector<Warning> warnings;  ///< those of reconstruct() that are about the whole stack
};
/// Decides all that reconstruct() decides over the stack, and writes it to a file. Refused as
/// reconstruct() does, but for what only shows when slabs are built.
[[nodiscard]] TETLOFT_API Result<WrittenPlan> write_plan(const std::string& path,
                                                         const SectionStack& stack,
                                                         const ReconstructOptions& options = {},
                                                         const PlanSource& source = {});
[[nodiscard]] TETLOFT_API Result<WrittenPlan> write_plan(const std::string& path,
                                                         const ValidStack& stack,
                                                         const ReconstructOptions& options = {},
                                                         const PlanSource& source = {});
/// The same of sections one after the other. Memory: some tens of sections, a few numbers for each,
/// and a number for each component; the sections wait in unnamed temporaries beside the file, three
/// times as large as it at most. But by Criterion::reverse, and with labels or decisions, what is
/// decided anywhere may depend on all, and all sections are in memory.
[[nodiscard]] TETLOFT_API Result<WrittenPlan> write_plan(const std::string& path,
                                                         SectionStream& sections,
                                                         const ReconstructOptions& options = {},
                                                         const PlanSource& source = {});
/// What a plan says of itself. Its sections are not looked at.
[[nodiscard]] TETLOFT_API Result<PlanSummary> read_plan(const std::string& path);
/// Reads all of it: refused where any part is damaged or does not fit.
[[nodiscard]] TETLOFT_API Result<PlanSummary> check_plan(const std::string& path);

struct PieceOptions {
  Encoding encoding = Encoding::binary;
  Execution execution = {};
};

/// What a piece is.
struct PieceSummary {
  std::uint64_t plan = 0;  ///< the identity of its plan
  std::size_t first = 0;   ///< its slabs are first … end − 1
  std::size_t end = 0;
  std::size_t sections = 0;            ///< of the whole stack
  std::vector<std::size_t> open = {};  ///< the slabs that are left to joining
};

struct WrittenPiece {
  PieceSummary summary;
  ReconstructReport report;  ///< of its slabs; vertices and sections shared with others count
  std::vector<Warning> warnings;
};
/// Builds the slabs first … end − 1 (of a stack of one section 0 and 0) of a plan, and writes them
/// to a .vtu. Refused (usage) are slabs that the plan has not, or none, and a path without ".vtu";
/// and what reconstruct() would refuse in these slabs.
[[nodiscard]] TETLOFT_API Result<WrittenPiece> write_piece(const std::string& path,
                                                           const std::string& plan,
                                                           std::size_t first, std::size_t end,
                                                           const PieceOptions& options = {});
/// What a piece says of itself. Its solid is not looked at.
[[nodiscard]] TETLOFT_API Result<PieceSummary> read_piece(const std::string& path);
/// Reads all of it: refused where its solid is not the one that was written.
[[nodiscard]] TETLOFT_API Result<PieceSummary> check_piece(const std::string& path);

struct JoinOptions {
  /// Needed where slabs are left open, not else. Empty: none.
  std::string plan = {};
  /// Of the pieces that write_index() writes anew.
  Encoding encoding = Encoding::binary;
  Execution execution = {};
};

struct Joined {
  Model model;
  /// Work and rules are sums over all that was built, what joining built again too; seconds are
  /// those of what joining built: a piece does not keep its own, which no two runs have alike.
  ReconstructReport report;
  std::size_t settled = 0;  ///< slabs built by joining
  std::vector<Warning> warnings;
};
/// The model of all pieces of a stack, given in any order: that of the single run. A .pvtu stands
/// for the pieces that it lists. Refused
/// (invalid_input), naming files and slabs, where pieces are of different plans, overlap, are
/// missing, damaged, or differ in the section that they share; (usage) where slabs are open and no
/// plan is given, or one that is not theirs.
[[nodiscard]] TETLOFT_API Result<Joined> join_pieces(std::span<const std::string> pieces,
                                                     const JoinOptions& options = {});

struct WrittenJoin {
  ReconstructReport report;  ///< as Joined::report
  std::size_t settled = 0;
  std::vector<Warning> warnings;
};
/// As join_pieces() and write_model(), the same bytes. A .vtu of pieces that lie where their stack
/// does (Model::frame) takes memory of about one piece, what is built from the plan, and the tables
/// of the whole; compressed, its packed arrays too. What it is put together from stands meanwhile
/// in unnamed temporaries beside it, as large as the file. Else the whole model is in memory.
[[nodiscard]] TETLOFT_API Result<WrittenJoin> write_joined(const std::string& path,
                                                           std::span<const std::string> pieces,
                                                           const JoinOptions& options = {},
                                                           const WriteOptions& writing = {});

struct WrittenStream {
  /// Seconds, work and rules are sums over all that was built, some slabs twice.
  ReconstructReport report;
  std::vector<Warning> warnings;
};
/// As reconstruct() and write_vtu(), the same bytes, in one process; the solid is never in memory:
/// slabs are built from the plan, some tens at a time for each thread, and wait in unnamed
/// temporaries beside the file, as large as it. In memory are the stack and the tables of the
/// whole. All of the solid is, too, where the stack's frame is not Frame{}, or links have to be
/// decided anew, which is rare. Refused (usage) is a path without ".vtu".
[[nodiscard]] TETLOFT_API Result<WrittenStream> write_streamed(
    const std::string& path, const SectionStack& stack, const ReconstructOptions& options = {},
    Encoding encoding = Encoding::binary);
[[nodiscard]] TETLOFT_API Result<WrittenStream> write_streamed(
    const std::string& path, const ValidStack& stack, const ReconstructOptions& options = {},
    Encoding encoding = Encoding::binary);
/// The same of sections one after the other: the stack is never in memory either, nor what is
/// decided about it, where write_plan() needs it not.
[[nodiscard]] TETLOFT_API Result<WrittenStream> write_streamed(
    const std::string& path, SectionStream& sections, const ReconstructOptions& options = {},
    Encoding encoding = Encoding::binary);

struct WrittenIndex {
  std::vector<std::string> pieces;   ///< the files that are listed, from the lowest slabs up
  std::vector<std::string> written;  ///< those of them that were written anew
  std::size_t settled = 0;           ///< slabs built by joining
  std::size_t tets = 0;
  std::size_t components = 0;
  std::vector<Warning> warnings;
};
/// All pieces of a stack, given in any order, as one solid that stays where it is: writes a .pvtu,
/// which lists the pieces by their paths from its folder. Pieces with slabs that were left open are
/// written anew, these slabs built from the plan, beside it: of "out.pvtu" the k-th one as
/// "out_k.vtu"; what was given stays. Sections between two pieces have their vertices in both, bit
/// for bit. All files appear or none. Memory: two pieces, and what is built. Refused as
/// join_pieces() does, and (usage) a path without ".pvtu".
[[nodiscard]] TETLOFT_API Result<WrittenIndex> write_index(const std::string& path,
                                                           std::span<const std::string> pieces,
                                                           const JoinOptions& options = {});

/// A piece that an index lists.
struct ListedPiece {
  std::string path;                   ///< of its file
  std::optional<PieceSummary> piece;  ///< what it says of itself
  std::size_t vertices = 0;           ///< as its file announces them
  std::size_t tets = 0;
  std::optional<Error> wrong;  ///< why it says nothing: it is missing, damaged, or no piece
};
struct IndexSummary {
  std::vector<ListedPiece> pieces;  ///< as they are listed
  /// Why these are not all of one stack, each once, without open slabs: the first reason. None:
  /// they are.
  std::optional<Error> wrong;
};
/// What a .pvtu lists. The heads of its pieces are read, one after the other; their solids are not
/// looked at.
[[nodiscard]] TETLOFT_API Result<IndexSummary> read_index(const std::string& path);

/// As check() of what join_pieces() makes of these, the same verdict, piece by piece: in memory are
/// two pieces, the stack, and what follows from it. Places name the files of pieces where they
/// speak of their tets and vertices; numbers are those of the whole.
///
/// Two pieces share one section, whose vertices lie in its plane, and all else of them lies on its
/// two sides. Where that is not so, which is a failure, the pieces on both sides are in memory
/// together; of another stack, all. Equal are verdicts, their conditions and counts, and figures,
/// but for: the volume, a sum by pieces; counts of 3.3 beyond a thousand, a limit that each piece
/// has; which places are told first; and 3.4 where guarantee 1 fails, too.
///
/// Refused as check() and join_pieces() do; (usage) where slabs are left open: an index that
/// write_index() made has none. A .pvtu stands for the pieces that it lists.
[[nodiscard]] TETLOFT_API Result<CheckReport> check_pieces(std::span<const std::string> pieces,
                                                           const SectionStack& stack,
                                                           const CheckOptions& options = {});

}  // namespace tetloft
