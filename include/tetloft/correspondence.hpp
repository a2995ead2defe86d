// Which contours form one component: the criteria of correspondence, as options and as a
// result. Decided in src/correspondence; recomputed independently by check.
//
// The rule, in full. Its objects are the regions of all sections, numbered by (section,
// region). A link joins two regions of neighbouring sections.
//
// 1. Candidates. By `overlap`: the pairs with ratio r > tau (exactly), except weak links
//    between two well-connected regions: r < 1/4 while each of the two has another link
//    of ratio ≥ 1/4 in the same slab. By `reverse`: the pairs (region of a vertex below,
//    region of a vertex above) of every reverse tetrahedron (type II or IE).
//    By `overlap` with `drift`, further ones, found from those above alone. A region without
//    candidate in a slab is single there. A single region with exactly one candidate in the
//    slab on its other side, to a region B, drifts: in this slab by
//    d = (centre − centre of B) · (gap of this slab / gap of that slab), per coordinate, in
//    doubles, in this order. A gap is the difference in z; a centre is that of the bounding
//    box of the region's outer contour, (least + largest) / 2. The region moved by d has the
//    vertices (x + d.x, y + d.y), rounded, and counts if it is still a region: as a section
//    it is valid and nested as before. Two single regions A below and C above are a candidate
//    iff A moved by its drift and C, or A and C moved by its drift, have a ratio > drift
//    (exactly).
// 2. Without labels every candidate is accepted.
// 3. With labels: candidates in order of decreasing overlap_ratio (both criteria), then
//    by (slab, lower region, upper region); one is accepted unless it joins two sets of
//    different labels, sets being the unions of accepted links over the whole stack and
//    having the label of any member.
// 4. For each label in increasing order, while its regions lie in several sets: from the
//    set of the label's first region, the path to another set of this label by links
//    between neighbouring sections through sets of this label or of none, that takes the
//    fewest new links, then the least sum of distances (smallest distance in space of a
//    vertex of the one region to a vertex of the other), then the lowest links. Its links
//    are accepted. If there is none, the labels cannot be realised.
//
// Components of the object are the sets of step 4; classes of a slab are the unions of the
// links accepted in that slab alone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

enum class Criterion : std::uint8_t {
  /// Regions of neighbouring sections are united when their overlap ratio r exceeds tau,
  /// unless r < 1/4 and both regions have another link of ratio ≥ 1/4 (in the same slab).
  overlap,
  /// Definition 2 of Nonato et al. (2000): united by a reverse tetrahedron.
  reverse,
};

inline constexpr double kDefaultOverlap = 0.02;
/// The guard of the overlap criterion: a link at least this strong is trusted, and
/// outrules weaker ones between two regions that both have one. Both numbers are settled by
/// measurement on solids of known truth: bench/corpus/README.md.
inline constexpr double kStrongOverlap = 0.25;

/// A user's label on one contour. It belongs to the whole region the contour bounds.
struct Label {
  SectionId section;
  ContourId contour;
  std::uint32_t label = 0;
};

struct CorrespondenceOptions {
  Criterion criterion = Criterion::overlap;
  double tau = kDefaultOverlap;
  /// For oblique tubes whose neighbouring sections do not overlap: with `overlap` only, also
  /// unites regions without link whose overlap exceeds this ratio, in [0, 1), where one of
  /// them is moved on as far as it came from the section before (or after). Off: not done.
  std::optional<double> drift = std::nullopt;
  /// Same label: same component; different labels: different components, whatever the
  /// geometry. Regions without label follow the criterion.
  std::vector<Label> labels = {};
};

/// A partition of the contours of a stack: class_of[section][contour], classes numbered in
/// order of their first contour by (section, contour).
using ContourPartition = IdVector<SectionId, IdVector<ContourId, ComponentId>>;

}  // namespace tetloft
