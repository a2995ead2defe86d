#include "reconstruct/topology.hpp"

#include <algorithm>
#include <utility>

#include "completion/sealed_faces.hpp"
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

// Do its voids hang together?
bool is_open_link(const SlabVoidNumbering& numbering, const std::vector<SlabVoidId>& joined,
                  const Link& link) {
  return joined[numbering.in_slab(false, link.lower).index()] ==
         joined[numbering.in_slab(true, link.upper).index()];
}

}  // namespace

Topology::Topology(const ConformingSection& lower, const ConformingSection& upper,
                   const SlabLinks& links, Pits& pits)
    : links_(links), pits_(pits) {
  if (links.voids == nullptr) return;
  faces_.emplace(sections::given_section(lower), lower.nesting, sections::given_section(upper),
                 upper.nesting);
}

Topology::Next Topology::make(const SlabView& view, Completion& completion, bool may_ask,
                              RuleCounts& rules) {
  if (links_.voids == nullptr) return Next::go_on;
  SlabVoids voids(view.slab.lower(), view.slab.upper(), *links_.voids);
  if (!part_voids(view, voids, completion, may_ask, rules)) return Next::refine;
  groups_ = expected_topology(*faces_, view.slab.lower(), view.slab.upper(),
                              {links_.regions, *links_.voids, united_});
  const ChiGroups groups(view.slab, view.classes, view.active, chi_ranges(view));
  ComplexState state(groups, voids, completion);
  // Nearly always there is nothing to do.
  if (voids.void_count() == 2 && groups.deviation(state.sums()) == 0) return Next::go_on;
  count(rules, Rule::filled_handle, fill_handles(state));
  bridge_faces(view, state, rules);
  const Next next = open_faces(view, state, may_ask);
  if (next == Next::go_on) drop_unrealised(view, state);
  return next;
}

// False where contours have to be finer before two voids are taken for one.
bool Topology::part_voids(const SlabView& view, SlabVoids& voids, Completion& completion,
                          bool may_ask, RuleCounts& rules) {
  united_.clear();
  while (voids.class_count() > 1) {
    Passages passages(view.slab, view.classes, view.active, voids, completion);
    const std::optional<Inseparable> stuck = passages.close();
    count(rules, Rule::closed_passage, passages.closed());
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
void Topology::drop_unrealised(const SlabView& view, ComplexState& state) {
  const SlabVoids& voids = state.voids();
  unrealised_.clear();
  if (voids.void_count() == 2) return;
  const std::vector<SlabVoidId>& joined = state.joined();
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
  groups_ = expected_topology(*faces_, view.slab.lower(), view.slab.upper(),
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
void Topology::bridge_faces(const SlabView& view, ComplexState& state, RuleCounts& rules) {
  if (!state.groups().any_high(state.sums())) return;
  const VoidSpace space(view.slab, view.classes, state.voids(), state.completion().complex());
  const SlabRegions& regions = view.classes.regions();
  for (const sections::FaceId f : faces_->faces().ids()) {
    const sections::OverlayFace& face = faces_->faces()[f];
    if (!face.lower.solid || !face.upper.solid) continue;
    const ClassId c = view.classes.of_region(regions.in_slab(false, face.lower.id));
    if (view.classes.of_region(regions.in_slab(true, face.upper.id)) != c) continue;
    if (!state.groups().is_high(c, state.sums())) continue;
    const std::optional<Point2> p = sections::inner_point(*faces_, f);
    if (!p) continue;
    std::vector<Wall> walls;
    for (const TetId t : tets_over(view.slab, *p)) {
      if (space.of_one_class(t, 0xF) && view.classes.of(view.slab.vertex(t, 0)) == c &&
          space.is_void(t)) {
        walls.push_back({t, 0xF, c});
      }
    }
    if (!walls.empty() && state.try_walls(walls) > 0) count(rules, Rule::bridged_face);
  }
}

// VV faces of a group above its range that are sealed get a vertex in their middle, in both planes.
Topology::Next Topology::open_faces(const SlabView& view, ComplexState& state, bool may_ask) {
  if (openings_ == Openings::given_up) return Next::go_on;
  const SlabVoids& voids = state.voids();
  const ChiGroups& groups = state.groups();
  const ChiGroups::Sums& sums = state.sums();
  const std::vector<SlabVoidId>& joined = state.joined();
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
  const VoidSpace space(view.slab, view.classes, voids, state.completion().complex());
  const SlabRegions& regions = view.classes.regions();
  wanted_ = {};
  wanted_.optional = true;
  bool opened = false;
  for (const sections::FaceId f : faces_->faces().ids()) {
    const sections::OverlayFace& face = faces_->faces()[f];
    if (face.lower.solid || face.upper.solid || f == sections::kUnboundedFace) continue;
    const SlabVoidId below = voids.numbering().in_slab(false, face.lower.id);
    const SlabVoidId above = voids.numbering().in_slab(true, face.upper.id);
    if (voids.class_of(below) != voids.class_of(above)) continue;
    const bool high = std::any_of(face.border.begin(), face.border.end(), [&](const auto& border) {
      return groups.is_high(view.classes.of_region(regions.in_slab(border.upper, border.region)),
                            sums);
    });
    if (!high && joined[below.index()] == joined[above.index()]) continue;
    const std::optional<Point2> p = sections::inner_point(*faces_, f);
    if (!p || is_open(view.slab, space, tets_over(view.slab, *p), *p)) continue;
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
