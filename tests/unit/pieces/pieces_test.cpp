// Plans, pieces and joined models through files: the model of the single run, wherever the stack
// was cut; and what does not belong together is named.
#include <tetloft/pieces.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <tetloft/check.hpp>

#include "pieces/piece_file.hpp"
#include "property/same_model.hpp"
#include "support/slabs/cases.hpp"
#include "unit/pieces/pieces_support.hpp"

namespace tetloft::testing {
namespace {

using Cuts = std::vector<std::size_t>;  // where pieces begin, and the end

std::vector<std::string> write_pieces(const Folder& folder, const Cuts& cuts) {
  std::vector<std::string> paths;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    paths.push_back(folder / ("piece" + std::to_string(k) + ".vtu"));
    const auto piece = write_piece(paths.back(), folder / "plan", cuts[k], cuts[k + 1]);
    EXPECT_TRUE(piece.ok()) << to_string(piece.error());
  }
  return paths;
}

void write_planned(const Folder& folder, const SectionStack& stack,
                   const ReconstructOptions& options = {}) {
  const auto plan = write_plan(folder / "plan", stack, options);
  EXPECT_TRUE(plan.ok()) << to_string(plan.error());
}

// A plan and its pieces.
std::vector<std::string> write_pieces_of(const Folder& folder, const SectionStack& stack,
                                         const Cuts& cuts, const ReconstructOptions& options = {}) {
  write_planned(folder, stack, options);
  return write_pieces(folder, cuts);
}

void expect_joined(const SectionStack& stack, const ReconstructOptions& options, const Cuts& cuts,
                   std::size_t settled) {
  const Folder folder;
  const auto direct = reconstruct(stack, options);
  ASSERT_TRUE(direct.ok());
  std::vector<std::string> paths = write_pieces_of(folder, stack, cuts, options);
  std::reverse(paths.begin(), paths.end());
  JoinOptions joining;
  joining.plan = folder / "plan";
  const auto joined = join_pieces(paths, joining);
  ASSERT_TRUE(joined.ok()) << to_string(joined.error());
  EXPECT_TRUE(same_bits(joined->model, direct->model));
  EXPECT_EQ(*format_vtu(joined->model), *format_vtu(direct->model));
  EXPECT_EQ(joined->settled, settled);
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii, Encoding::compressed}) {
    const auto written = write_joined(folder / "joined.vtu", paths, joining, {encoding, {}});
    ASSERT_TRUE(written.ok()) << to_string(written.error());
    EXPECT_EQ(bytes_of(folder / "joined.vtu"), *format_vtu(direct->model, encoding));
    EXPECT_EQ(written->settled, settled);
    expect_same_figures(written->report, direct->report);
    EXPECT_EQ(written->report.rules, joined->report.rules);
    EXPECT_EQ(written->report.work, joined->report.work);
  }
  // What was built twice counts twice.
  if (settled == 0) {
    EXPECT_EQ(joined->report.rules, direct->report.rules);
  }
  expect_same_figures(joined->report, direct->report);
}

SectionStack three_sections_of_boxes() {
  return stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 3, 2), box(5, 0, 6, 2)}, {box(1, 0, 2, 2)}});
}

TEST(Pieces, JoinedAreTheModelOfTheSingleRun) {
  const SectionStack stack = sample("torus.cnt");
  const std::size_t slabs = stack.sections.size() - 1;
  for (const Cuts& cuts :
       {Cuts{0, slabs}, Cuts{0, 1, slabs}, Cuts{0, slabs - 1, slabs}, Cuts{0, 4, 9, 13, slabs}}) {
    expect_joined(stack, {}, cuts, 0);
    expect_joined(stack, with_ends_between_and_label(), cuts, 0);
  }
}

TEST(Pieces, OfAStackThatLiesElsewhereAndOtherFormatsAreWritten) {
  const Folder folder;
  SectionStack stack = sample("torus.cnt");
  stack.frame.origin = {1, 2, 3};
  const auto paths = write_pieces_of(folder, stack, {0, 7, 19});
  const Model model = reconstruct(stack)->model;
  ASSERT_TRUE(write_joined(folder / "joined.vtu", paths).ok());
  EXPECT_EQ(bytes_of(folder / "joined.vtu"), *format_vtu(model));
  ASSERT_TRUE(write_joined(folder / "joined.vtk", paths).ok());
  ASSERT_TRUE(write_model(folder / "direct.vtk", model).ok());
  EXPECT_EQ(bytes_of(folder / "joined.vtk"), bytes_of(folder / "direct.vtk"));
}

TEST(Pieces, ASingleSectionIsOnePiece) {
  expect_joined(stack_of_boxes({{box(0, 0, 4, 2)}}), {}, {0, 0}, 0);
}

TEST(Pieces, SlabsThatNeedMoreThanTheirPieceAreSettledByJoining) {
  const auto [stack, options] = stack_of_mends("----xx----");
  ASSERT_GT(
      reconstruct(stack, options)->report.rules[static_cast<std::size_t>(Rule::gabriel_refinement)],
      0U);
  expect_joined(stack, options, {0, 9}, 0);
  expect_joined(stack, options, {0, 2, 7, 9}, 0);
  expect_joined(stack, options, {0, 4, 9}, 3);     // below the slab
  expect_joined(stack, options, {0, 5, 9}, 3);     // above it
  expect_joined(stack, options, {0, 4, 5, 9}, 3);  // alone
  expect_joined(stack, options, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 3);

  const Folder folder;
  const auto without = join_pieces(write_pieces_of(folder, stack, {0, 4, 9}, options));
  ASSERT_FALSE(without.ok());
  EXPECT_EQ(without.error().code, ErrorCode::usage);
  EXPECT_NE(without.error().message.find("slabs 4:6"), std::string::npos)
      << without.error().message;
  EXPECT_EQ(read_piece(folder / "piece1.vtu")->open, (std::vector<std::size_t>{4, 5}));
}

// Slabs that all need refined contours, so that what is mended goes on from each to the next.
TEST(Pieces, AChainOfMendsIsSettledAsLongAsItIs) {
  const auto [stack, options] = stack_of_mends("xxxxx---xxxx");
  ASSERT_TRUE(reconstruct(stack, options).ok());
  expect_joined(stack, options, {0, 11}, 0);
  expect_joined(stack, options, {0, 2, 11}, 5);
  expect_joined(stack, options, {0, 6, 9, 11}, 4);
  expect_joined(stack, options, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, 9);
}

TEST(Pieces, EachIsASolidThatEveryToolReads) {
  const Folder folder;
  const SectionStack stack = sample("torus.cnt");
  const auto paths = write_pieces_of(folder, stack, {0, 7, 19});
  const auto model = read_vtu(paths[1]);
  ASSERT_TRUE(model.ok());
  for (const SlabId slab : model->slab) EXPECT_GE(slab.index(), 7U);
  SectionStack part;
  for (std::size_t s = 7; s < 20; ++s) part.sections.push_back(stack.sections[SectionId(s)]);
  EXPECT_GT(volume(*model), 0);
  const PieceSummary said = *read_piece(paths[1]);
  EXPECT_EQ(said.first, 7U);
  EXPECT_EQ(said.end, 19U);
  EXPECT_EQ(said.sections, 20U);
  EXPECT_EQ(said.plan, read_plan(folder / "plan")->identity);
  EXPECT_TRUE(said.open.empty());
}

void expect_refused(const Result<Joined>& joined, ErrorCode code, const std::string& why) {
  ASSERT_FALSE(joined.ok());
  EXPECT_EQ(joined.error().code, code);
  EXPECT_NE(to_string(joined.error()).find(why), std::string::npos) << to_string(joined.error());
}

TEST(Pieces, ThatDoNotBelongTogetherAreNamed) {
  const Folder folder;
  const SectionStack stack = sample("torus.cnt");
  const std::vector<std::string> p = write_pieces_of(folder, stack, {0, 7, 12, 19});
  using Paths = std::vector<std::string>;
  expect_refused(join_pieces(Paths{p[0], p[2]}), ErrorCode::invalid_input, "slabs 7:12");
  expect_refused(join_pieces(Paths{p[1], p[2]}), ErrorCode::invalid_input, "slabs 0:7");
  expect_refused(join_pieces(Paths{p[1], p[0]}), ErrorCode::invalid_input, "slabs 12:19");
  expect_refused(join_pieces(Paths{p[0], p[1], p[1], p[2]}), ErrorCode::invalid_input,
                 "slabs 7:12 is twice");
  expect_refused(join_pieces(Paths{}), ErrorCode::usage, "no piece");
  const std::string none = folder / "none.vtu";
  expect_refused(join_pieces(Paths{p[0], none, p[2]}), ErrorCode::io, none);
  ReconstructOptions other;
  other.ends = Ends::half;
  ASSERT_TRUE(write_plan(folder / "other", stack, other).ok());
  const std::string foreign = folder / "foreign.vtu";
  ASSERT_TRUE(write_piece(foreign, folder / "other", 7, 12).ok());
  expect_refused(join_pieces(Paths{p[0], foreign, p[2]}), ErrorCode::invalid_input, foreign);
  const std::string solid = folder / "solid.vtu";
  ASSERT_TRUE(write_vtu(solid, reconstruct(stack)->model).ok());
  expect_refused(join_pieces(Paths{p[0], solid, p[2]}), ErrorCode::invalid_input, "no piece");
}

TEST(Pieces, DamagedPlansAreRefused) {
  const Folder folder;
  const SectionStack stack = three_sections_of_boxes();
  const auto written = write_plan(folder / "plan", stack);
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(check_plan(folder / "plan")->identity, written->summary.identity);
  const std::string bytes = bytes_of(folder / "plan");
  const std::string path = folder / "damaged";
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    std::ofstream(path, std::ios::binary) << damaged;
    EXPECT_FALSE(check_plan(path).ok()) << at;
  }
  for (const std::size_t size : {std::size_t{0}, bytes.size() / 2, bytes.size() - 1}) {
    std::ofstream(path, std::ios::binary) << bytes.substr(0, size);
    EXPECT_FALSE(read_plan(path).ok()) << size;
  }
}

// What of a piece's bytes has no meaning may be anything; all else is missed.
TEST(Pieces, DamagedPiecesAreRefused) {
  const Folder folder;
  const SectionStack stack = three_sections_of_boxes();
  const auto paths = write_pieces_of(folder, stack, {0, 1, 2});
  const auto whole = join_pieces(paths);
  ASSERT_TRUE(whole.ok()) << to_string(whole.error());
  const std::string bytes = bytes_of(paths[1]);
  const std::size_t data = bytes.find("<AppendedData");
  ASSERT_LT(data, bytes.size());
  std::size_t refused = 0;
  std::size_t tried = 0;
  for (std::size_t at = 0; at < bytes.size(); at += 37) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    std::ofstream(paths[1], std::ios::binary) << damaged;
    const auto joined = join_pieces(paths);
    if (at >= data) ++tried;
    if (joined.ok()) {
      EXPECT_TRUE(same_bits(joined->model, whole->model)) << at;
      continue;
    }
    EXPECT_EQ(joined.error().where.file, paths[1]) << at;
    if (at >= data) ++refused;
  }
  EXPECT_GT(refused, tried * 9 / 10);
}

TEST(Pieces, AreListedAndAnIndexStandsForThem) {
  const Folder folder;
  const SectionStack stack = sample("torus.cnt");
  const auto paths = write_pieces_of(folder, stack, {0, 7, 12, 19});
  const auto written = write_index(folder / "all.pvtu", paths);
  ASSERT_TRUE(written.ok()) << to_string(written.error());
  EXPECT_EQ(written->pieces, paths);
  EXPECT_TRUE(written->written.empty());
  const std::vector<std::string> index{folder / "all.pvtu"};
  const auto joined = join_pieces(index);
  ASSERT_TRUE(joined.ok()) << to_string(joined.error());
  EXPECT_TRUE(same_bits(joined->model, reconstruct(stack)->model));
  EXPECT_EQ(written->tets, joined->model.tets.size());
  EXPECT_EQ(write_index(folder / "all.vtu", paths).error().code, ErrorCode::usage);
  EXPECT_EQ(check_piece(paths[2])->end, 19U);

  const std::string bytes = bytes_of(index[0]);
  for (std::size_t size = 0; size + 1 < bytes.size(); size += 5) {
    std::ofstream(index[0], std::ios::binary) << bytes.substr(0, size);
    EXPECT_FALSE(join_pieces(index).ok()) << size;
  }
}

void write_forged(const std::string& path, internal::pieces::WholePiece piece) {
  auto files = internal::pieces::stage_whole_piece(path, piece, Encoding::compressed, nullptr);
  ASSERT_TRUE(files.ok() && internal::io::commit_all(files->files).ok());
}

TEST(Pieces, ThatSayThatThePlanHasMoreSectionsAreRefused) {
  const Folder folder;
  const std::string path = write_pieces_of(folder, sample("torus.cnt"), {0, 19})[0];
  auto piece = internal::pieces::read_whole_piece(path);
  ASSERT_TRUE(piece.ok());
  piece->record.sections = 1000;
  piece->record.slabs = {0, 999};
  internal::ClusterSpan open{{998, 999}, {}};
  open.beyond.below = true;
  piece->record.clusters = {open};
  write_forged(path, *std::move(piece));
  JoinOptions options;
  options.plan = folder / "plan";
  expect_refused(join_pieces(std::vector<std::string>{path}, options), ErrorCode::usage,
                 "not the plan");
}

// No sample drops a link, so a piece is made to say that it did: all of the stack is built.
TEST(Pieces, WhereLinksHaveToBeDecidedAnewAllIsBuilt) {
  const Folder folder;
  const SectionStack stack = sample("torus.cnt");
  const auto paths = write_pieces_of(folder, stack, {0, 7, 12, 19});
  auto piece = internal::pieces::read_whole_piece(paths[1]);
  ASSERT_TRUE(piece.ok());
  internal::ClusterSpan cluster{{8, 9}, {}};
  cluster.beyond.decides = true;
  piece->record.clusters = {cluster};
  write_forged(paths[1], *std::move(piece));
  const Model direct = reconstruct(stack)->model;
  JoinOptions options;
  EXPECT_EQ(join_pieces(paths, options).error().code, ErrorCode::usage);
  options.plan = folder / "plan";
  const auto joined = join_pieces(paths, options);
  ASSERT_TRUE(joined.ok()) << to_string(joined.error());
  EXPECT_EQ(joined->settled, 19U);
  EXPECT_TRUE(same_bits(joined->model, direct));
  const auto index = write_index(folder / "all.pvtu", paths, options);
  ASSERT_TRUE(index.ok()) << to_string(index.error());
  EXPECT_EQ(index->written.size(), 3U);
  const auto again = join_pieces(index->pieces);
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_TRUE(same_bits(again->model, direct));
}

TEST(Pieces, SlabsThatThereAreNotAreRefused) {
  const Folder folder;
  ASSERT_TRUE(write_plan(folder / "plan", sample("torus.cnt")).ok());
  for (const auto& [first, end] : std::vector<std::pair<std::size_t, std::size_t>>{
           {3, 3}, {5, 4}, {0, 20}, {19, 20}, {0, 0}}) {
    const auto piece = write_piece(folder / "piece.vtu", folder / "plan", first, end);
    ASSERT_FALSE(piece.ok());
    EXPECT_EQ(piece.error().code, ErrorCode::usage);
    EXPECT_FALSE(std::filesystem::exists(folder / "piece.vtu"));
  }
}

}  // namespace
}  // namespace tetloft::testing
