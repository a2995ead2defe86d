// Distances are sampled once for all wanted regions of a slab that lie near each other.
#include "motion/region_motions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "motion/displacement.hpp"
#include "motion/distance_samples.hpp"
#include "motion/lattice_window.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

namespace {

using motion::DistanceSamples;
using motion::LatticeEdges;
using motion::LatticeWindow;

// Larger regions, in gaps along x or y, do not move: what they overlap hardly depends on a gap.
constexpr double kLargest = 12;
// A section farther beyond the slab, in gaps, says nothing of it.
constexpr double kFarthestNeighbour = 2;
// Doubles measure to a fraction of a step below this, in lattice units.
constexpr double kLargestUnits = 0x1p40;
// Below it, steps come near the end of what doubles hold.
constexpr double kLeastGap = 0x1p-1000;

// Whether doubles measure there; true of no box.
bool fits(const Box2& box) {
  return std::min(box.x0, box.y0) > -kLargestUnits && std::max(box.x1, box.y1) < kLargestUnits;
}

// A region to be moved, its bounds in lattice units.
struct Mover {
  bool upper = false;
  RegionId region;
  Box2 box;
};

// Movers near each other, and what is looked at around them.
struct Group {
  LatticeWindow window;
  std::vector<Mover> movers;
};

// Movers are together where that takes no more samples of a section `margin` around their windows.
std::vector<Group> grouped(const std::vector<Mover>& movers, std::int64_t margin) {
  const auto samples = [margin](const LatticeWindow& w) { return w.widened(margin).size(); };
  std::vector<Group> groups;
  for (const Mover& mover : movers) {
    const LatticeWindow window = motion::window_of(mover.box);
    const auto near = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return samples(group.window.joined(window)) <= samples(group.window) + samples(window);
    });
    if (near == groups.end()) {
      groups.push_back({window, {mover}});
    } else {
      near->window = near->window.joined(window);
      near->movers.push_back(mover);
    }
  }
  return groups;
}

// A slab with the sections beside it, in units of its lattice.
class SampledSlab {
 public:
  SampledSlab(SlabId slab, const SectionStack& stack) {
    const std::size_t k = slab.index();
    const auto section = [&](std::size_t s) -> const Section& {
      return stack.sections[SectionId(s)];
    };
    gap_ = section(k + 1).z - section(k).z;
    step_ = gap_ / motion::kStepsPerGap;
    if (!(gap_ >= kLeastGap)) return;
    if (k > 0) below_ = (section(k).z - section(k - 1).z) / gap_;
    if (k + 2 < stack.sections.size()) above_ = (section(k + 2).z - section(k + 1).z) / gap_;
    if (k > 0 && below_ <= kFarthestNeighbour) edges_[0].emplace(section(k - 1), step_);
    edges_[1].emplace(section(k), step_);
    edges_[2].emplace(section(k + 1), step_);
    if (k + 2 < stack.sections.size() && above_ <= kFarthestNeighbour) {
      edges_[3].emplace(section(k + 2), step_);
    }
    measurable_ = std::all_of(edges_.begin(), edges_.end(),
                              [](const auto& edges) { return !edges || fits(edges->box()); });
  }

  [[nodiscard]] bool measurable() const { return measurable_; }
  [[nodiscard]] double step() const { return step_; }

  /// The bounds of a contour, if it is small enough to move.
  [[nodiscard]] std::optional<Box2> movable(const Contour& contour) const {
    Box2 box;
    for (const Point2& p : contour.vertices) box.add(Point2{p.x / step_, p.y / step_});
    const double side = std::max(box.x1 - box.x0, box.y1 - box.y0);
    if (!(side <= kLargest * motion::kStepsPerGap)) return std::nullopt;
    return box;
  }

  void move(const Group& group, SlabMotions& motions) const {
    std::array<DistanceSamples, 4> samples;
    const std::array<double, 4> gaps{1 + below_, 1, 1, 1 + above_};
    for (std::size_t s = 0; s < 4; ++s) {
      if (!edges_[s]) continue;
      samples[s] =
          motion::sample_distances(*edges_[s], group.window.widened(motion::margin_of(gaps[s])));
    }
    const auto* const first = edges_[0] ? &samples[0] : nullptr;
    const auto* const last = edges_[3] ? &samples[3] : nullptr;
    for (const Mover& mover : group.movers) {
      if (mover.upper) {
        const Point2 u = motion::displacement(
            {last, &samples[2], &samples[1], first, above_, below_}, mover.box);
        motions.upper[mover.region] = Point2{-rounded(u.x), -rounded(u.y)};
      } else {
        const Point2 u = motion::displacement(
            {first, &samples[1], &samples[2], last, below_, above_}, mover.box);
        motions.lower[mover.region] = Point2{rounded(u.x), rounded(u.y)};
      }
    }
  }

 private:
  // Lattice units to those of the plane, on the lattice of motions.
  [[nodiscard]] double rounded(double u) const {
    const double unit = std::ldexp(1.0, std::ilogb(gap_) - 10);
    return std::round(u * step_ / unit) * unit;
  }

  double gap_ = 0, step_ = 0;
  double below_ = 0, above_ = 0;  // the gaps beside, by this one
  std::array<std::optional<LatticeEdges>, 4> edges_;
  bool measurable_ = false;
};

}  // namespace

SlabMotions estimate_motions(SlabId slab, const SectionStack& stack,
                             const IdVector<SectionId, Nesting>& nestings,
                             const WantedRegions& wanted) {
  const SectionId below(slab.index()), above(slab.index() + 1);
  SlabMotions motions;
  motions.lower.resize(nestings[below].outer.size());
  motions.upper.resize(nestings[above].outer.size());
  for (const RegionId r : wanted.lower) motions.lower[r] = Point2{};
  for (const RegionId r : wanted.upper) motions.upper[r] = Point2{};
  if (wanted.lower.empty() && wanted.upper.empty()) return motions;
  const SampledSlab sampled(slab, stack);
  if (!sampled.measurable()) return motions;
  std::vector<Mover> movers;
  const auto add = [&](SectionId section, bool upper, RegionId region) {
    const Contour& outer = stack.sections[section].contours[nestings[section].outer[region]];
    if (const auto box = sampled.movable(outer)) movers.push_back({upper, region, *box});
  };
  for (const RegionId r : wanted.lower) add(below, false, r);
  for (const RegionId r : wanted.upper) add(above, true, r);
  for (const Group& group : grouped(movers, motion::margin_of(2))) sampled.move(group, motions);
  return motions;
}

}  // namespace tetloft::internal
