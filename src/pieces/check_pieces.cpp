// The check of a solid that is in pieces: some at a time.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/pieces.hpp>

#include "check/segments.hpp"
#include "check/view.hpp"
#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "model/segment.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/piece_set.hpp"

namespace tetloft {

using namespace internal;

namespace {

using pieces::PieceAt;

constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

// Ids have 32 bits, and one number stands for none.
constexpr std::size_t kMostNumbers = 0xFFFFFFFFU;

// What is known of a piece before any is checked.
struct PlacedPiece {
  std::size_t section_vertices = 0;  // of pieces below, without those that are in this one, too
  std::size_t constructed = 0;       // of pieces below
  std::size_t tets = 0;              // likewise
  // Are its seams in their planes? The lowest of its vertices but those of the lower one, and the
  // highest but those of the upper one.
  bool lower_is_flat = true, upper_is_flat = true;
  double lowest = kBeyondAll, highest = -kBeyondAll;
};

Error error_of_piece(const Result<AddedSegment>& added, const PieceAt& piece) {
  Error error = added.error();
  error.where.file = piece.path;
  return error;
}

void place_heights(const Model& model, const AddedSegment& added, const SlabRange& slabs,
                   const SectionStack& stack, PlacedPiece& place) {
  const auto z = [&](std::size_t s) { return stack.sections[SectionId(s)].z; };
  const bool has_upper = slabs.end + 1 < stack.sections.size();
  for (const VertexId v : model.points.ids()) {
    if (added.number[v.index()] == AddedSegment::kNone) continue;
    const double height = model.points[v].z;
    const SectionId s = model.section[v];
    const bool finite = checking::is_finite(model.points[v]);
    const bool lower = slabs.first > 0 && s.valid() && s.index() == slabs.first;
    const bool upper = has_upper && s.valid() && s.index() == slabs.end;
    if (lower) place.lower_is_flat = place.lower_is_flat && finite && height == z(slabs.first);
    if (upper) place.upper_is_flat = place.upper_is_flat && finite && height == z(slabs.end);
    if (!finite) continue;  // in no sound tet
    if (!lower) place.lowest = std::min(place.lowest, height);
    if (!upper) place.highest = std::max(place.highest, height);
  }
}

// Reads all pieces once, so that it is known how the whole is numbered, and which seams are flat.
class PieceGroups {
 public:
  PieceGroups(const std::vector<PieceAt>& all, const SectionStack& stack)
      : all_(all), stack_(stack) {}

  Result<void> place(WatchedWork& work) {
    const bool same_sections = all_.front().record.sections == stack_.sections.size();
    for (const PieceAt& piece : all_) {
      work.go_on();
      const Result<Model> model = pieces::piece_model(piece.path, piece.record);
      if (!model) return model.error();
      PlacedPiece place;
      place.constructed = numbers_.constructed();
      place.tets = numbers_.tets();
      const Result<AddedSegment> added = numbers_.add(*model, piece.record.slabs);
      if (!added) return error_of_piece(added, piece);
      const auto of_sections = std::count_if(added->number.begin(), added->number.end(),
                                             [](std::int64_t number) { return number >= 0; });
      place.section_vertices = numbers_.section_vertices() - static_cast<std::size_t>(of_sections);
      if (same_sections) place_heights(*model, *added, piece.record.slabs, stack_, place);
      places_.push_back(place);
      work.step_done();
    }
    if (std::max(numbers_.vertices(), numbers_.tets()) >= kMostNumbers) {
      return Error{ErrorCode::invalid_input, "2^32 - 1 vertices or tets, or more", {}};
    }
    if (same_sections) find_flat_seams();
    return {};
  }

  /// How many pieces from this one on are to be looked at together.
  [[nodiscard]] std::size_t group_end(std::size_t first) const {
    std::size_t end = first + 1;
    while (end < all_.size() && (flat_.empty() || !flat_[end])) ++end;
    return end;
  }

  [[nodiscard]] Result<checking::Segment> segment(std::size_t first, std::size_t end) const {
    checking::Segment segment;
    JoinedModel joined(all_[first].record.slabs.first);
    for (std::size_t k = first; k < end; ++k) {
      const Result<Model> model = pieces::piece_model(all_[k].path, all_[k].record);
      if (!model) return model.error();
      const Result<void> added = joined.add(*model, all_[k].record.slabs);
      if (!added) return added.error();
      const std::string file = std::filesystem::path(all_[k].path).filename().string();
      segment.name += (k == first ? "" : " and ") + file;
    }
    segment.model = joined.take();
    segment.sections = {all_[first].record.slabs.first, all_[end - 1].record.slabs.end + 1};
    if (all_.size() == end - first) segment.sections = {0, stack_.sections.size()};
    segment.first_tet = places_[first].tets;
    std::size_t of_section = places_[first].section_vertices;
    std::size_t constructed = numbers_.section_vertices() + places_[first].constructed;
    for (const SectionId s : segment.model.section) {
      segment.number.emplace_back(s.valid() ? of_section++ : constructed++);
    }
    return segment;
  }

 private:
  // All below lies below, and all above above.
  void find_flat_seams() {
    flat_.assign(all_.size(), true);
    double highest = -kBeyondAll;
    for (std::size_t k = 1; k < all_.size(); ++k) {
      highest = std::max(highest, places_[k - 1].highest);
      flat_[k] = places_[k - 1].upper_is_flat && places_[k].lower_is_flat && highest < seam_z(k);
    }
    double lowest = kBeyondAll;
    for (std::size_t k = all_.size(); k-- > 1;) {
      lowest = std::min(lowest, places_[k].lowest);
      flat_[k] = flat_[k] && lowest > seam_z(k);
    }
  }
  // Between piece k and the one below.
  [[nodiscard]] double seam_z(std::size_t k) const {
    return stack_.sections[SectionId(all_[k].record.slabs.first)].z;
  }

  const std::vector<PieceAt>& all_;
  const SectionStack& stack_;
  SegmentNumbers numbers_;
  std::vector<PlacedPiece> places_;
  std::vector<bool> flat_;  // by the piece above the seam; empty: none is
};

Result<CheckReport> check_all(std::span<const std::string> paths, const SectionStack& stack,
                              const CheckOptions& options) {
  if (auto good = checking::check_arguments(stack, options); !good) return good.error();
  const Result<std::vector<PieceAt>> all = pieces::read_pieces(paths);
  if (!all) return all.error();
  if (const Result<void> closed = pieces::check_closed(*all); !closed) return closed.error();
  // Pieces placed, and checked.
  WatchedWork work(options.execution, 2 * all->size() + checking::SegmentCheck::kReportSteps);
  PieceGroups groups(*all, stack);
  if (const Result<void> placed = groups.place(work); !placed) return placed.error();
  checking::SegmentCheck check(stack, options, work);
  for (std::size_t first = 0; first < all->size();) {
    const std::size_t end = groups.group_end(first);
    Result<checking::Segment> segment = groups.segment(first, end);
    if (!segment) return segment.error();
    check.add(std::move(*segment));
    for (; first < end; ++first) work.step_done();
  }
  return check.report();
}

}  // namespace

Result<CheckReport> check_pieces(std::span<const std::string> pieces, const SectionStack& stack,
                                 const CheckOptions& options) {
  return guard_threads(options,
                       [&](const CheckOptions& own) { return check_all(pieces, stack, own); });
}

}  // namespace tetloft
