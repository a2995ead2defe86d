// Correspondence `moved`: which regions may move, how a model says they do, and how far pairs
// overlap then.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>

#include "check/regions.hpp"
#include "check/shifted_region.hpp"

namespace tetloft::internal::checking {

/// A region in the slab above it, or in the one beneath.
struct Passage {
  std::size_t region = 0;
  bool up = false;
  friend auto operator<=>(const Passage&, const Passage&) = default;
};

/// From the lower plane of the slab to the upper one; 0 where there is none.
using Motions = std::map<Passage, Point2>;

/// Where the rule has a motion, sorted: of regions that are neither at rest nor without anything
/// near enough to move to.
[[nodiscard]] std::vector<Passage> moving_passages(const Regions& regions);

/// What a model says of motions, in its own unit. `wrong` says which of them the rule has not, and
/// why; they are left out.
struct ClaimedMotions {
  Motions motions;
  std::vector<std::string> wrong;
};
[[nodiscard]] ClaimedMotions claimed_motions(const Regions& regions,
                                             std::span<const RegionMotion> claims);

/// Times 2^exponent.
[[nodiscard]] Motions in_unit(Motions motions, int exponent);

/// The motions as src/motion estimates them, and as the stack's vertices say: all that are not 0.
[[nodiscard]] Motions estimated_motions(const SectionStack& stack, const Regions& regions);

/// m of the rule.
class MovedRatios {
 public:
  /// Both must outlive this.
  MovedRatios(const Regions& regions, const Motions& motions);

  [[nodiscard]] double operator()(const Link& link) const;
  /// The pairs whose m is not 0, and perhaps others; sorted.
  [[nodiscard]] std::vector<Link> pairs() const;

 private:
  // The ratio of `moving` where its motion in this passage brings it, and of `still` where it lies.
  [[nodiscard]] double one_way(const Passage& moving, std::size_t still) const;

  const Regions& regions_;
  // Of passages that have a motion; none where the region is none any more.
  std::map<Passage, std::optional<ShiftedRegion>> there_;
};

/// s of a pair by rule 1 or 3.
[[nodiscard]] double score(const Regions& regions, const MovedRatios& m, const Link& link);

}  // namespace tetloft::internal::checking
