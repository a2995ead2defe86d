// Which contours form one component: the criteria of correspondence, as options, as a decision and
// as a report of every link. Decided in src/correspondence; recomputed independently by check.
//
// The rule, in full. Its objects are the regions of all sections, numbered by (section,
// region). A link joins two regions of neighbouring sections. Of two regions
//   r   is their overlap ratio (overlap_ratio()), which is compared exactly with thresholds; where
//       ratios are ordered among each other, or reported, it is the double that function gives;
//   d   is their distance as sets of the plane, region_distance(), over the gap, the difference in
//       z of their sections: doubles, by two further operations. 0 iff they meet;
//   m   is r; by `moved` the mean of r where A is moved by its motion u and B lies still, and of r
//       where A lies still and B is moved back by its own: (r + r) / 2 in doubles. A motion is one
//       of Model::motions, or 0: of a region at rest, and of one whose box, larger by the gap on
//       all sides, meets no box of a region of the other section. How motions are found:
//       src/motion/README.md. A moved region has the vertices (x ± ux, y ± uy), rounded, and if it
//       is no region any more (as a section not valid, or nested otherwise) its ratios are 0.
//       A is at rest iff it overlaps a region of the other section, and in all pairs of regions
//       that overlap of which A or a region that A overlaps is one, r ≥ 0.7;
//   s   is m − d, in doubles; of a candidate of rule 2 m is the larger ratio moved on.
//
// 1. Candidates, by criterion.
//    `overlap`: the pairs with r > tau, except weak links between two well-connected regions:
//    r < 1/4 while each of the two has another link of ratio ≥ 1/4 in the same slab.
//    `moved`: the pairs with m > tau + d, in doubles.
//    `reverse`: the pairs (region of a vertex below, region of a vertex above) of every reverse
//    tetrahedron (type II or IE).
// 2. Chains, unless `reverse`, or `chain` is off. A region without candidate in a slab is single
//    there. A single region A below moves on by the difference of its centre to that of its
//    origin, times the gap of this slab over that of the slab beneath: per coordinate, in doubles,
//    (centre − centre of origin) · (gap / gap). A centre is that of the bounding box of a region's
//    outer contour, (least + largest) / 2. Its origin: if A has one candidate in the slab beneath,
//    the other region of it; if none, the region of least d there (then of least number), if that
//    d ≤ 2; otherwise A has no origin. Likewise, downwards, for a single region above. Two single
//    regions with d ≤ 2 are a candidate iff either of them, moved on, has an overlap ratio > 0.1
//    with the other. A moved region has the vertices (x + dx, y + dy), rounded, and counts if it
//    is still a region: as a section it is valid and nested as before. Chains look at the
//    candidates of 1 alone.
// 3. Lone regions, unless `reverse`, or `lone` is off. A region without a candidate of 1 or 2 on
//    any side, of the first and last section, too, is lone. Of all pairs it is in, it gets the one
//    of largest s (then of lower slab, of lower number of the other region), among those with
//    d < 1/2, or d < 1 where its area, its holes left out, is below (gap / 2)², exactly. Lone
//    regions choose all at once: two may choose each other, or choose differently.
// 4. Decisions of the user's on single links: a parted pair is no candidate, a joined one is.
// 5. Without labels every candidate is accepted.
// 6. With labels: joined pairs first, then candidates in order of decreasing s, then by (slab,
//    lower region, upper region); one is accepted unless it joins two sets of different labels,
//    sets being the unions of accepted links over the whole stack and having the label of any
//    member. A joined pair that does is refused.
// 7. For each label in increasing order, while its regions lie in several sets: from the
//    set of the label's first region, the path to another set of this label by links
//    between neighbouring sections, none of them a parted pair, through sets of this label or of
//    none, that takes the fewest new links, then the least sum of distances (smallest distance in
//    space of a vertex of the one region to a vertex of the other), then the lowest links. Its
//    links are accepted. If there is none, the labels cannot be realised.
// 8. A candidate that the slab's Delaunay triangulation cannot realise, however contours are
//    divided, is dropped, the one of least s first, and reported; unless labels or a decision ask
//    for it: then the stack is refused.
//
// Components of the object are the sets of step 7, less 8; classes of a slab are the unions of
// the links accepted in that slab alone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

namespace tetloft {

enum class Criterion : std::uint8_t {
  /// Regions of neighbouring sections are united when their overlap ratio r exceeds tau,
  /// unless r < 1/4 and both regions have another link of ratio ≥ 1/4 (in the same slab).
  overlap,
  /// Definition 2 of Nonato et al. (2000): united by a reverse tetrahedron.
  reverse,
  /// By how far they overlap where they are moved as their surroundings move from section to
  /// section; the more, the farther apart they lie.
  moved,
};

/// The thresholds tau of the criteria that have one.
inline constexpr double kDefaultOverlap = 0.02;
inline constexpr double kDefaultMoved = 0.10;
/// Rest, by `moved`: regions that overlap so far do not move.
inline constexpr double kRestOverlap = 0.7;
/// The guard of the overlap criterion: a link at least this strong is trusted, and
/// outrules weaker ones between two regions that both have one. Both numbers are settled by
/// measurement on solids of known truth: bench/corpus/README.md.
inline constexpr double kStrongOverlap = 0.25;
/// What a region that is moved on as it came must overlap (rule 2).
inline constexpr double kChainOverlap = 0.1;
/// How far chains reach, in gaps; and lone regions, large and small ones (rule 3).
inline constexpr double kChainReach = 2.0;
inline constexpr double kLoneReach = 0.5;
inline constexpr double kSmallLoneReach = 1.0;

/// A user's label on one contour. It belongs to the whole region the contour bounds.
struct Label {
  SectionId section;
  ContourId contour;
  std::uint32_t label = 0;
};

/// A user's decision on one link, between the regions that two contours bound.
struct LinkDecision {
  SlabId slab;
  ContourId lower;  ///< of the section below the slab
  ContourId upper;
  bool join = true;  ///< or part
};

/// What a user decides: the contents of a file of labels.
struct Labels {
  std::vector<Label> labels = {};
  std::vector<LinkDecision> decisions = {};
  /// Of voids: those of VoidOptions.
  std::vector<Label> hole_labels = {};
  std::vector<LinkDecision> void_decisions = {};
};

/// How voids correspond: the rule in full in tetloft/voids.hpp.
enum class VoidRule : std::uint8_t {
  overlap,  ///< by overlap, chains and rims
  near,     ///< the same; and a hole left without link, to the nearest void within reach
  free,     ///< as it comes: nothing is decided, closed or checked; takes no labels or decisions
};
/// By `near`, if nothing else is said: in gaps.
inline constexpr double kDefaultVoidReach = 0.5;

/// What a user decides of voids. A hole is named by its contour, the exterior by an invalid one.
struct VoidOptions {
  VoidRule rule = VoidRule::overlap;
  /// Of `near`, in gaps; finite, and not negative.
  double reach = kDefaultVoidReach;
  /// Labels of holes; there is none for the exterior.
  std::vector<Label> labels = {};
  std::vector<LinkDecision> decisions = {};
};

struct CorrespondenceOptions {
  Criterion criterion = Criterion::moved;
  /// The threshold of `overlap` and `moved`, in [0, 1); none: kDefaultOverlap, kDefaultMoved.
  std::optional<double> tau = std::nullopt;
  /// Rule 2: oblique parts whose neighbouring sections do not overlap.
  bool chain = true;
  /// Rule 3: a region that nothing else links belongs to what is nearest. Turn it off for
  /// particles, of which many are met by one section alone.
  bool lone = true;
  /// Same label: same component; different labels: different components, whatever the
  /// geometry. Regions without label follow the criterion.
  std::vector<Label> labels = {};
  /// No two on one pair of regions, unless they agree.
  std::vector<LinkDecision> decisions = {};
  VoidOptions voids = {};
};

/// tau, or the criterion's default.
[[nodiscard]] TETLOFT_API double threshold_of(const CorrespondenceOptions& options);

/// A partition of the contours of a stack: class_of[section][contour], classes numbered in
/// order of their first contour by (section, contour).
using ContourPartition = IdVector<SectionId, IdVector<ContourId, ComponentId>>;

/// What a link, made or not, rests on. The values are stored in files.
enum class Evidence : std::uint8_t {
  overlap = 0,   ///< the regions overlap as they lie
  reverse = 1,   ///< a reverse tetrahedron
  motion = 2,    ///< they overlap as they are moved
  chain = 3,     ///< rule 2
  lone = 4,      ///< rule 3
  label = 5,     ///< rule 7
  decision = 6,  ///< rule 4
  rim = 7,       ///< of voids: rule V3 of voids.hpp
};
inline constexpr int kEvidences = 8;
[[nodiscard]] TETLOFT_API const char* name_of(Evidence evidence);

/// What became of a link. The values are stored in files.
enum class LinkFate : std::uint8_t {
  made = 0,
  too_weak = 1,      ///< below the threshold, or out of reach
  outruled = 2,      ///< by the guard, or another link that a lone region preferred
  labels_part = 3,   ///< it would join different labels
  decided_part = 4,  ///< the user's decision
  unrealisable = 5,  ///< rule 8
  forced = 6,        ///< of voids: rule V6 of voids.hpp, no wall can stand between
};
inline constexpr int kLinkFates = 7;
[[nodiscard]] TETLOFT_API const char* name_of(LinkFate fate);

/// A link that was made, or nearly, and how surely. Regions are named by their outer contours.
struct RegionLink {
  SlabId slab;
  ContourId lower, upper;
  Evidence evidence = Evidence::overlap;
  LinkFate fate = LinkFate::made;
  double ratio = 0;     ///< r
  double moved = 0;     ///< m; of a chain, the ratio that made it
  double distance = 0;  ///< d, in gaps
  /// How far the decision was from going the other way: what was measured (r, s, the ratio moved
  /// on, or by how much a lone region is within its reach) less what it must exceed; negative
  /// where it falls short. 1 for labels and decisions, r for reverse tets, which know no degree.
  double margin = 0;
  /// s less the largest s of another pair, made or not, of one of the two regions in this slab;
  /// for a lone region in any slab. None: no other pair came into question.
  std::optional<double> lead = std::nullopt;
};

/// How a region moves through a slab, from its lower plane to its upper one.
struct RegionMotion {
  SlabId slab;
  bool upper = false;  ///< a region of the upper section
  ContourId contour;   ///< its outer one
  Point2 by;           ///< in units of the stack
};

}  // namespace tetloft
