#include "reconstruct/topology.hpp"

#include <algorithm>
#include <utility>

#include "sections/conforming_section.hpp"
#include "sections/inner_point.hpp"

namespace tetloft::internal {

namespace {

// Are all contours refined that are asked for?
bool is_refined(const Slab& slab, const RefineHere& here) {
  for (const bool upper : {false, true}) {
    const auto& gabriel = slab.section(upper).gabriel;
    for (const ContourId c : here.contours[upper ? 1 : 0]) {
      if (gabriel.empty() || !gabriel[c]) return false;
    }
  }
  return true;
}

// The contours at a void; of an exterior none, they are too many.
void add_contours(const Slab& slab, const SlabVoids& voids, SlabVoidId v, RefineHere& here) {
  const ContourId hole = voids.hole(v);
  if (!hole.valid()) return;
  const bool upper = voids.numbering().is_upper(v);
  const Nesting& nesting = slab.section(upper).nesting;
  for (const ContourId c : nesting.parent.ids()) {
    if (c == hole || nesting.parent[c] == hole) here.contours[upper ? 1 : 0].push_back(c);
  }
}

// Does no part of the void touch voids of two classes?
bool are_parted(const SlabVoids& voids, const std::vector<SlabVoidId>& joined) {
  for (std::size_t v = 0; v < joined.size(); ++v) {
    if (voids.class_of(joined[v]) != voids.class_of(SlabVoidId(v))) return false;
  }
  return true;
}

// Do its voids hang together?
bool is_open_link(const SlabVoidNumbering& numbering, const std::vector<SlabVoidId>& joined,
                  const Link& link) {
  return joined[numbering.in_slab(false, link.lower).index()] ==
         joined[numbering.in_slab(true, link.upper).index()];
}

}  // namespace

Topology::Topology(const ConformingSection& lower, const ConformingSection& upper,
                   const SlabLinks& links, Pits& pits)
    : lower_(lower), upper_(upper), links_(links), pits_(pits) {}

const sections::FaceOverlay& Topology::faces() {
  return links_.faces != nullptr ? *links_.faces : placed_faces();
}

const sections::FaceOverlay& Topology::placed_faces() {
  if (!faces_) {
    faces_.emplace(sections::given_section(lower_), lower_.nesting, sections::given_section(upper_),
                   upper_.nesting);
  }
  return *faces_;
}

Topology::Next Topology::make(const SlabView& view, Completion& completion, bool may_ask,
                              RuleCounts& rules) {
  if (links_.voids == nullptr) return Next::go_on;
  SlabVoids voids(view.slab.lower(), view.slab.upper(), *links_.voids);
  if (!part_voids(view, voids, completion, may_ask, rules)) return Next::refine;
  groups_ = expected_topology(faces(), view.slab.lower(), view.slab.upper(),
                              {links_.regions, *links_.voids, united_});
  const ChiGroups groups(view.slab, view.classes, view.active, chi_ranges(view));
  ComplexShape shape{groups.sums(completion.complex()), {}};
  // Nearly always there is nothing to do.
  if (voids.void_count() == 2 && groups.deviation(shape.sums) == 0) return Next::go_on;
  if (joined_.empty()) {
    joined_ = joined_voids(view.slab, view.classes, voids, completion.complex());
  }
  shape.joined = std::move(joined_);
  count(rules, Rule::filled_handle, fill_handles(groups, voids, completion, shape));
  TetsOver tets_over(view.slab);
  bridge_faces(view, groups, tets_over, completion, shape, rules);
  const Next next = open_faces(view, voids, groups, tets_over, completion, shape, may_ask);
  if (next == Next::go_on) drop_unrealised(view, voids, shape);
  return next;
}

// False where contours have to be finer before two voids are taken for one.
bool Topology::part_voids(const SlabView& view, SlabVoids& voids, Completion& completion,
                          bool may_ask, RuleCounts& rules) {
  united_.clear();
  joined_.clear();
  while (voids.class_count() > 1) {
    if (joined_.empty()) {
      joined_ = joined_voids(view.slab, view.classes, voids, completion.complex());
    }
    if (are_parted(voids, joined_)) break;
    Passages passages(view.slab, view.classes, view.active, voids, completion);
    const std::optional<Inseparable> stuck = passages.close();
    count(rules, Rule::closed_passage, passages.closed());
    if (passages.closed() > 0) joined_.clear();
    if (!stuck) break;
    RefineHere here;
    for (const SlabVoidId v : *stuck) add_contours(view.slab, voids, v, here);
    if (may_ask && !is_refined(view.slab, here)) {
      wanted_ = std::move(here);
      wanted_.optional = true;
      return false;
    }
    count(rules, Rule::united_voids);
    united_.push_back(*stuck);
    voids.unite((*stuck)[0], (*stuck)[1]);
  }
  return true;
}

// What is not open is no link; the rest implies another topology then.
void Topology::drop_unrealised(const SlabView& view, const SlabVoids& voids,
                               const ComplexShape& shape) {
  unrealised_.clear();
  if (voids.void_count() == 2) return;
  const std::vector<SlabVoidId>& joined = shape.joined;
  std::vector<Link> realised;
  for (const Link& link : *links_.voids) {
    (is_open_link(voids.numbering(), joined, link) ? realised : unrealised_).push_back(link);
  }
  if (unrealised_.empty()) return;
  // Voids of one class may hang together though the links between them do not.
  SlabVoids rest(view.slab.lower(), view.slab.upper(), realised);
  for (const auto& [a, b] : united_) rest.unite(a, b);
  for (std::size_t v = 0; v < joined.size(); ++v) {
    const SlabVoidId here(v);
    if (rest.class_of(joined[v]) == rest.class_of(here)) continue;
    united_.push_back({joined[v], here});
    rest.unite(joined[v], here);
  }
  groups_ = expected_topology(faces(), view.slab.lower(), view.slab.upper(),
                              {links_.regions, realised, united_});
}

// Of active classes; what ends in a prism has the topology of its region.
std::vector<ChiRange> Topology::chi_ranges(const SlabView& view) const {
  std::vector<ChiRange> ranges;
  for (const TopologyGroup& group : groups_) {
    ChiRange range{{}, group.least, group.most};
    for (const SlabRegionId r : group.regions) {
      const ClassId c = view.classes.of_region(r);
      if (view.active[c] == 0) {
        const SlabRegions& regions = view.classes.regions();
        const std::int32_t chi =
            region_chi(view.slab.section(regions.is_upper(r)).nesting, regions.in_section(r));
        range.least -= chi;
        range.most -= chi;
      } else if (view.classes.regions(c).front() == r) {
        range.classes.push_back(c);
      }
    }
    ranges.push_back(std::move(range));
  }
  return ranges;
}

// SS faces of a group above its range: what D holds over their middle becomes solid where that
// brings it nearer.
void Topology::bridge_faces(const SlabView& view, const ChiGroups& groups, TetsOver& tets_over,
                            Completion& completion, ComplexShape& shape, RuleCounts& rules) {
  ChiGroups::Sums& sums = shape.sums;
  if (!groups.any_high(sums)) return;
  const SlabVoids voids(view.slab.lower(), view.slab.upper(), *links_.voids);
  const VoidSpace space(view.slab, view.classes, voids, completion.complex());
  const SlabRegions& regions = view.classes.regions();
  const sections::FaceOverlay& overlay = placed_faces();
  for (const sections::FaceId f : overlay.faces().ids()) {
    const sections::OverlayFace& face = overlay.faces()[f];
    if (!face.lower.solid || !face.upper.solid) continue;
    const ClassId c = view.classes.of_region(regions.in_slab(false, face.lower.id));
    if (view.classes.of_region(regions.in_slab(true, face.upper.id)) != c) continue;
    if (!groups.is_high(c, sums)) continue;
    const std::optional<Point2> p = sections::inner_point(overlay, f);
    if (!p) continue;
    std::vector<Wall> walls;
    for (const TetId t : tets_over(*p)) {
      if (space.of_one_class(t, 0xF) && view.classes.of(view.slab.vertex(t, 0)) == c &&
          space.is_void(t)) {
        walls.push_back({t, 0xF, c});
      }
    }
    if (walls.empty()) continue;
    Completion trial = completion;
    trial.build(walls);
    const ChiGroups::Sums after = groups.sums(trial.complex());
    if (groups.deviation(after) >= groups.deviation(sums)) continue;
    if (joined_voids(view.slab, view.classes, voids, trial.complex()) != shape.joined) continue;
    completion.adopt(std::move(trial));
    count(rules, Rule::bridged_face);
    sums = after;
  }
}

// VV faces of a group above its range that are sealed get a vertex in their middle, in both planes.
Topology::Next Topology::open_faces(const SlabView& view, const SlabVoids& voids,
                                    const ChiGroups& groups, TetsOver& tets_over,
                                    const Completion& completion, const ComplexShape& shape,
                                    bool may_ask) {
  if (openings_ == Openings::given_up) return Next::go_on;
  const ChiGroups::Sums& sums = shape.sums;
  const std::vector<SlabVoidId>& joined = shape.joined;
  const auto sealed = std::count_if(
      links_.voids->begin(), links_.voids->end(),
      [&](const Link& link) { return !is_open_link(voids.numbering(), joined, link); });
  const std::int32_t deviation = groups.deviation(sums) + static_cast<std::int32_t>(sealed);
  if (openings_ == Openings::tried && deviation >= least_deviation_) {
    openings_ = Openings::given_up;
    pits_.close_pairs();
    return Next::again;
  }
  least_deviation_ = deviation;
  if (!groups.any_high(sums) && sealed == 0) return Next::go_on;
  const VoidSpace space(view.slab, view.classes, voids, completion.complex());
  const SlabRegions& regions = view.classes.regions();
  wanted_ = {};
  wanted_.optional = true;
  bool opened = false;
  const sections::FaceOverlay& overlay = placed_faces();
  for (const sections::FaceId f : overlay.faces().ids()) {
    const sections::OverlayFace& face = overlay.faces()[f];
    if (face.lower.solid || face.upper.solid || f == sections::kUnboundedFace) continue;
    const SlabVoidId below = voids.numbering().in_slab(false, face.lower.id);
    const SlabVoidId above = voids.numbering().in_slab(true, face.upper.id);
    if (voids.class_of(below) != voids.class_of(above)) continue;
    const bool high = std::any_of(face.border.begin(), face.border.end(), [&](const auto& border) {
      return groups.is_high(view.classes.of_region(regions.in_slab(border.upper, border.region)),
                            sums);
    });
    if (!high && joined[below.index()] == joined[above.index()]) continue;
    const std::optional<Point2> p = sections::inner_point(overlay, f);
    if (!p || is_open(view.slab, space, tets_over(*p), *p)) continue;
    if (pits_.has_room(*p)) {
      opened = pits_.open_at(*p) || opened;
    } else {
      wanted_.apart.push_back(*p);
    }
  }
  if (may_ask && !wanted_.apart.empty()) return Next::refine;
  if (!opened) return Next::go_on;
  openings_ = Openings::tried;
  return Next::again;
}

}  // namespace tetloft::internal
