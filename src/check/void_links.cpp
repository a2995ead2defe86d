#include "check/void_links.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "check/partition.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::checking {

namespace {

using VoidLabel = std::optional<std::uint32_t>;

Error refused(const char* why, std::size_t section, ContourId contour) {
  Place place;
  place.section = section;
  if (contour.valid()) place.contour = contour.index();
  return {ErrorCode::invalid_input, why, place};
}

// Rules V0 to V3.
class VoidCandidates {
 public:
  VoidCandidates(const StackVoids& stack, const std::vector<Faces>& faces,
                 const std::vector<Link>& of_regions, const VoidOptions& options)
      : stack_(stack), faces_(faces), voids_(stack.voids()), options_(options) {
    find_walls(of_regions);
  }

  // With s, if labels ask for it. The exteriors' links are not among them.
  std::map<Link, double> run() {
    const std::vector<Link> by_overlap = overlaps();
    for (const Link& link : by_overlap) found_.emplace(link, score(link));
    const ChainRule rule{kVoidChainReach, true};
    for (const Candidate& chain : chain_links(voids_, by_overlap, rule)) {
      found_.emplace(chain.link, chain.s);
    }
    std::vector<Link> links;
    for (const auto& [link, s] : found_) links.push_back(link);
    const LinkedRegions linked(voids_.size(), links);
    for (std::size_t v = 0; v < voids_.size(); ++v) {
      if (stack_.is_exterior(v)) continue;
      const std::size_t s = voids_.section[v];
      if (s > 0 && linked.down[v].empty()) link_to_near(v, s - 1);
      if (s + 1 < voids_.section_count() && linked.up[v].empty()) link_to_near(v, s + 1);
    }
    return std::move(found_);
  }

  [[nodiscard]] double score(const Link& link) const {
    return options_.labels.empty() ? 0 : voids_.ratio(link) - *voids_.distance(link);
  }

 private:
  // V0: all faces of the two, if any, have to be walled off.
  void find_walls(const std::vector<Link>& of_regions) {
    const std::set<Link> linked(of_regions.begin(), of_regions.end());
    std::set<Link> open;
    for (std::size_t s = 0; s < faces_.size(); ++s) {
      std::set<Link> meeting;
      for (const sections::RegionMeeting& m : faces_[s].meetings) {
        meeting.insert(region_link(s, m.lower, m.upper));
      }
      for (const sections::OverlayFace& face : faces_[s].faces) {
        if (face.lower.solid || face.upper.solid) continue;
        const Link voids{voids_.first[s] + face.lower.id.index(),
                         voids_.first[s + 1] + face.upper.id.index()};
        bool wall = face.chi == 0 && face.border.size() == 2 && !face.border[0].upper &&
                    face.border[1].upper;
        if (wall) {
          const Link regions = region_link(s, face.border[0].region, face.border[1].region);
          wall = linked.count(regions) != 0 && meeting.count(regions) == 0;
          if (!stack_.is_exterior(voids.lower) && !stack_.is_exterior(voids.upper)) {
            const Link around{stack_.region_around(voids.lower), stack_.region_around(voids.upper)};
            wall = wall && linked.count(around) == 0;
          }
        }
        (wall ? walled_ : open).insert(voids);
      }
    }
    for (const Link& link : open) walled_.erase(link);
  }
  [[nodiscard]] Link region_link(std::size_t s, RegionId lower, RegionId upper) const {
    return {stack_.regions().first[s] + lower.index(),
            stack_.regions().first[s + 1] + upper.index()};
  }

  // V1. Only where the two have a face in common do they overlap at all.
  [[nodiscard]] std::vector<Link> overlaps() const {
    std::set<Link> common;
    for (std::size_t s = 0; s < faces_.size(); ++s) {
      for (const sections::OverlayFace& face : faces_[s].faces) {
        if (face.lower.solid || face.upper.solid) continue;
        common.insert(
            {voids_.first[s] + face.lower.id.index(), voids_.first[s + 1] + face.upper.id.index()});
      }
    }
    std::vector<Link> links;
    for (const Link& link : common) {
      if (stack_.is_exterior(link.lower) && stack_.is_exterior(link.upper)) continue;
      if (walled_.count(link) != 0) continue;
      if (compare_overlap(voids_.shape[link.lower], voids_.shape[link.upper], kVoidOverlap) ==
          Sign::positive) {
        links.push_back(link);
      }
    }
    return links;
  }

  // V3, of a hole without candidate on the side of section `to`.
  void link_to_near(std::size_t hole, std::size_t to) {
    if (options_.rule == VoidRule::near) {
      link_to_nearest(hole, to);
      return;
    }
    const Link rim = link_between(hole, voids_.first[to]);
    if (walled_.count(rim) != 0) return;
    const std::optional<double> d = voids_.distance(rim, kRimReach);
    if (d.has_value() && *d < kRimReach) found_.emplace(rim, score(rim));
  }

  void link_to_nearest(std::size_t hole, std::size_t to) {
    std::set<std::pair<double, std::size_t>> near;
    const double reach = options_.reach * voids_.gap(voids_.section[hole], to);
    voids_.for_each_meeting(to, surroundings(voids_.box[hole], reach), [&](std::size_t v) {
      if (walled_.count(link_between(hole, v)) != 0) return;
      const auto d = voids_.distance(link_between(hole, v), options_.reach);
      if (d.has_value() && *d < options_.reach) near.emplace(*d, v);
    });
    if (near.empty()) return;
    const Link nearest = link_between(hole, near.begin()->second);
    found_.emplace(nearest, score(nearest));
  }

  const StackVoids& stack_;
  const std::vector<Faces>& faces_;
  const Regions& voids_;
  const VoidOptions& options_;
  std::set<Link> walled_;
  std::map<Link, double> found_;
};

// V4.
Result<DecidedLinks> decided_void_links(const StackVoids& stack,
                                        const std::vector<LinkDecision>& decisions) {
  DecidedLinks decided;
  for (const LinkDecision& decision : decisions) {
    const std::size_t s = decision.slab.index();
    const auto refuse = [&](const char* why) { return refused(why, s, decision.lower); };
    if (!decision.slab.valid() || s + 1 >= stack.section_count()) {
      return refuse("a decision on voids names no slab");
    }
    const auto lower = stack.find_void(s, decision.lower);
    const auto upper = stack.find_void(s + 1, decision.upper);
    if (!lower.has_value() || !upper.has_value()) {
      return refuse("a decision on voids names a contour that is no hole");
    }
    if (stack.is_exterior(*lower) && stack.is_exterior(*upper)) {
      return refuse("a decision on voids names no hole");
    }
    const Link link{*lower, *upper};
    (decision.join ? decided.joined : decided.parted).insert(link);
    if (decided.joined.count(link) != 0 && decided.parted.count(link) != 0) {
      return refuse("decisions both join and part its void and another");
    }
  }
  return decided;
}

Result<std::vector<VoidLabel>> label_voids(const StackVoids& stack,
                                           const std::vector<Label>& labels) {
  std::vector<VoidLabel> of_void(stack.voids().size());
  for (const Label& label : labels) {
    const std::size_t s = label.section.index();
    std::optional<std::size_t> hole;
    if (s < stack.section_count() && label.contour.valid())
      hole = stack.find_void(s, label.contour);
    if (!hole.has_value()) {
      return refused("a label of voids names a contour that is no hole", s, label.contour);
    }
    VoidLabel& of = of_void[*hole];
    if (of.has_value() && *of != label.label) {
      return refused("two labels on one hole", s, label.contour);
    }
    of = label.label;
  }
  return of_void;
}

std::string claim_text(const VoidLink& claim) {
  const auto name = [](ContourId hole) {
    return hole.valid() ? "hole " + std::to_string(hole.index()) : "the exterior";
  };
  return "link of voids in slab " + std::to_string(claim.slab.index()) + ", " + name(claim.lower) +
         " and " + name(claim.upper) + ": ";
}

// What a model says of V6: `objection` tells what is wrong with a link of the fate that is asked
// for, or nothing.
template <class Objection>
std::set<SlabVoids> claimed_links(const StackVoids& stack, std::span<const VoidLink> claims,
                                  LinkFate fate, std::vector<std::string>& wrong,
                                  Objection&& objection) {
  std::set<SlabVoids> links;
  for (const VoidLink& claim : claims) {
    if (claim.fate != fate) continue;
    const std::size_t s = claim.slab.index();
    std::optional<std::size_t> lower;
    std::optional<std::size_t> upper;
    if (claim.slab.valid() && s + 1 < stack.section_count()) {
      lower = stack.find_void(claim.planes == VoidPlanes::upper ? s + 1 : s, claim.lower);
      upper = stack.find_void(claim.planes == VoidPlanes::lower ? s : s + 1, claim.upper);
    }
    const char* why = nullptr;
    if (!lower.has_value() || !upper.has_value()) {
      why = "no such voids";
    } else if (links.count({s, {*lower, *upper}}) != 0) {
      why = "told twice";
    } else {
      why = objection(SlabVoids{s, {*lower, *upper}});
    }
    if (why != nullptr) {
      wrong.push_back(claim_text(claim) + why);
    } else {
      links.insert({s, {*lower, *upper}});
    }
  }
  return links;
}

// The candidates of rule 6 there: all exteriors are one, before anything else.
std::vector<Candidate> as_candidates(const StackVoids& stack, const std::map<Link, double>& found,
                                     const DecidedLinks& decided) {
  std::vector<Candidate> candidates;
  for (std::size_t s = 0; s + 1 < stack.section_count(); ++s) {
    candidates.push_back({{stack.voids().first[s], stack.voids().first[s + 1]}, 0, true});
  }
  for (const auto& [link, s] : found) {
    candidates.push_back({link, s, decided.joined.count(link) != 0});
  }
  return candidates;
}

}  // namespace

Result<ExpectedVoids> expected_voids(const StackVoids& stack, const std::vector<Faces>& faces,
                                     const std::vector<Link>& of_regions,
                                     const VoidOptions& options, std::span<const VoidLink> claims) {
  auto label = label_voids(stack, options.labels);
  if (!label.ok()) return label.error();
  auto decided = decided_void_links(stack, options.decisions);
  if (!decided.ok()) return decided.error();
  VoidCandidates finder(stack, faces, of_regions, options);
  std::map<Link, double> found = finder.run();
  for (const Link& link : decided->parted) found.erase(link);
  for (const Link& link : decided->joined) found.emplace(link, finder.score(link));

  ExpectedVoids expected;
  std::set<Link> closed;
  for (const SlabVoids& claim : claimed_links(
           stack, claims, LinkFate::unrealisable, expected.wrong, [&](const SlabVoids& pair) {
             return found.count(pair.voids) == 0 ? "it is no candidate" : nullptr;
           })) {
    closed.insert(claim.voids);
  }
  expected.unrealisable = closed.size();
  for (const Link& link : closed) found.erase(link);
  closed.merge(decided->parted);

  RegionSets sets = unite_regions(stack.complement(), stack.voids(),
                                  as_candidates(stack, found, *decided), *label, closed);
  if (sets.contradicted.has_value()) {
    const std::size_t v = sets.contradicted->lower;
    return refused("a decision joins its void to one of another label", stack.voids().section[v],
                   stack.is_exterior(v) ? ContourId() : stack.hole(v));
  }
  expected.unrealised = sets.unrealised;
  expected.links = std::move(sets.accepted);

  // Void classes of each slab, by its parity: neighbouring slabs share voids.
  std::vector<UnionFind> of_slab(2, UnionFind(stack.voids().size()));
  for (const Link& link : expected.links) {
    of_slab[stack.voids().section[link.lower] % 2].unite(link.lower, link.upper);
  }
  const std::set<SlabVoids> forced =
      claimed_links(stack, claims, LinkFate::forced, expected.wrong, [&](const SlabVoids& pair) {
        return of_slab[pair.slab % 2].same(pair.voids.lower, pair.voids.upper)
                   ? "they are one void anyway"
                   : nullptr;
      });
  expected.forced.assign(forced.begin(), forced.end());
  return expected;
}

}  // namespace tetloft::internal::checking
