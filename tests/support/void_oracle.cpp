#include "support/void_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/overlay_oracle.hpp"

namespace tetloft::oracle {

namespace {

SectionStack complement(SectionStack stack) {
  double largest = 0x1p-60;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
      }
    }
  }
  double side = 0x1p-60;
  while (side < 4 * largest) side *= 2;
  for (Section& section : stack.sections) {
    section.contours.push_back({{{-side, -side}, {side, -side}, {side, side}, {-side, side}}});
  }
  return stack;
}

// The section with a solid that is larger by some, or smaller: of axis-parallel boxes and of
// triangles (x, y), (x + a, y), (x, y + a).
constexpr double kBy = 0x1p-7;
Section grown(const Section& section, double larger) {
  const Nesting nesting = nest(section);
  Section result = section;
  for (const ContourId c : section.contours.ids()) {
    std::vector<Point2>& v = result.contours[c].vertices;
    const double by = nesting.depth[c] % 2 == 0 ? larger : -larger;
    const Point2 low = v[0];
    if (v.size() == 3) {
      const double a = v[1].x - low.x + 3 * by;  // the oblique side moves by `by` along both axes
      v = {{low.x - by, low.y - by}, {low.x - by + a, low.y - by}, {low.x - by, low.y - by + a}};
    } else {
      const Point2 high = v[2];
      v = {{low.x - by, low.y - by},
           {high.x + by, low.y - by},
           {high.x + by, high.y + by},
           {low.x - by, high.y + by}};
    }
  }
  return result;
}

class VoidRuleByWord : private LinkRule {
 public:
  // Pairs of `walled` are those of V0.
  VoidRuleByWord(const Model& model, const SectionStack& complement, const VoidOptions& options,
                 std::set<RegionPair> walled)
      : LinkRule(complement, options.labels, options.decisions, {kVoidChainReach, true}),
        model_(model),
        options_(options),
        walled_(std::move(walled)) {}

  void run(ExpectedTopology& result) {
    by_overlap();
    by_chains();
    by_rims();
    decide();
    take_labels();
    drop(result);
    for (const RegionPair& pair : pairs_) {
      if (is_exterior(pair.first) && is_exterior(pair.second)) joined_.insert(pair);
    }
    accept();
    if (!options_.labels.empty() && !refused_) connect_labels();
    result.refused = refused_;
    result.realised = realised_;
    if (!refused_) force(result);
    result.links = links_;
  }

  // What the stack's voids are: those of the first and last section lead outside.
  [[nodiscard]] std::vector<std::size_t> sets() const {
    std::set<RegionPair> together = links_;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const std::size_t s = regions_[r].section;
      if (s == 0 || s + 1 == stack_.sections.size()) together.emplace(0, r);
    }
    return spread(regions_.size(), together);
  }

  [[nodiscard]] const std::vector<Region>& voids() const { return regions_; }

  // Numbers that are the same where pairs connect.
  static std::vector<std::size_t> spread(std::size_t size, const std::set<RegionPair>& pairs) {
    std::vector<std::size_t> number(size);
    for (std::size_t r = 0; r < size; ++r) number[r] = r;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [a, b] : pairs) {
        const std::size_t least = std::min(number[a], number[b]);
        changed |= number[a] != least || number[b] != least;
        number[a] = number[b] = least;
      }
    }
    return number;
  }

 private:
  // V1.
  void by_overlap() {
    for (const RegionPair& pair : pairs_) {
      if (is_exterior(pair.first) && is_exterior(pair.second)) continue;
      if (walled_.count(pair) != 0) continue;
      if (ratio(pair) > Rational::exactly(kVoidOverlap)) candidates_[pair] = s(pair);
    }
  }

  double s(const RegionPair& pair) { return rounded(ratio(pair)) - distance(pair); }

  // V3.
  void by_rims() {
    std::set<RegionPair> rims;
    for (std::size_t h = 0; h < regions_.size(); ++h) {
      if (is_exterior(h)) continue;
      for (const bool up : {false, true}) {
        const std::size_t here = regions_[h].section;
        if (here + (up ? 1 : 0) >= stack_.sections.size() || (!up && here == 0)) continue;
        const std::size_t there = up ? here + 1 : here - 1;
        if (!partners(h, there).empty()) continue;
        std::optional<RegionPair> best;
        for (const RegionPair& pair : pairs_) {
          if ((up ? pair.first : pair.second) != h) continue;
          if (walled_.count(pair) != 0) continue;
          const bool near = options_.rule == VoidRule::near;
          if (!near && !is_exterior(up ? pair.second : pair.first)) continue;
          if (!(distance(pair) < (near ? options_.reach : kRimReach))) continue;
          if (!best || distance(pair) < distance(*best)) best = pair;
        }
        if (best) rims.insert(*best);
      }
    }
    for (const RegionPair& pair : rims) candidates_[pair] = s(pair);
  }

  // V6.
  void drop(ExpectedTopology& result) {
    std::set<RegionPair> dropped;
    for (const VoidLink& claim : model_.void_links) {
      if (claim.fate != LinkFate::unrealisable) continue;
      const auto pair = pair_of(claim.slab, claim.lower, claim.upper, true);
      if (!pair || candidates_.count(*pair) == 0 || !dropped.insert(*pair).second) {
        result.claims_hold = false;
      }
    }
    result.unrealisable = dropped.size();
    for (const RegionPair& pair : dropped) {
      candidates_.erase(pair);
      joined_.erase(pair);
      closed_.insert(pair);
    }
  }

  void force(ExpectedTopology& result) {
    std::set<RegionPair> forced;
    for (const VoidLink& claim : model_.void_links) {
      if (claim.fate != LinkFate::forced) continue;
      const auto pair = pair_of(claim.slab, claim.lower, claim.upper, true);
      std::set<RegionPair> here;
      for (const RegionPair& link : links_) {
        if (regions_[link.first].section == claim.slab.value()) here.insert(link);
      }
      const std::vector<std::size_t> classes = spread(regions_.size(), here);
      if (!pair || classes[pair->first] == classes[pair->second] || !forced.insert(*pair).second) {
        result.claims_hold = false;
      }
    }
    result.forced = forced.size();
    links_.insert(forced.begin(), forced.end());
  }

  const Model& model_;
  const VoidOptions& options_;
  std::set<RegionPair> walled_;
};

// FACES, for one slab. All regions and voids of the stack are numbered.
class FacesByWord {
 public:
  FacesByWord(const std::vector<Region>& regions, const std::vector<Region>& voids,
              const std::set<RegionPair>& links, const std::set<RegionPair>& void_links,
              std::size_t slab)
      : regions_(regions),
        voids_(voids),
        slab_(slab),
        solid_(VoidRuleByWord::spread(regions.size(), within(links, regions))),
        hollow_(VoidRuleByWord::spread(voids.size(), within(void_links, voids))) {}

  // Where regions touch is an SS face, too, or where voids do a VV face: the overlay of solids that
  // are larger or smaller tells.
  std::map<std::size_t, long> run(const CellOverlay& of_solids, const CellOverlay& of_voids) {
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (!is_here(regions_[r])) continue;
      chi_[solid_[r]] += 2 - static_cast<long>(regions_[r].contours.size());
    }
    for (const CellOverlay::Face& face : of_solids.faces()) {
      if (face.side[0].solid && face.side[1].solid) count_solid(face);
    }
    for (const CellOverlay::Face& face : of_voids.faces()) {
      if (!face.side[0].solid && !face.side[1].solid) count_void(face);
    }
    count_bars();
    count_tunnels();
    const std::vector<std::size_t> group = VoidRuleByWord::spread(regions_.size(), grouped_);
    std::map<std::size_t, long> sums;
    for (const auto& [of_class, chi] : chi_) sums[group[of_class]] += chi;
    return sums;
  }

 private:
  [[nodiscard]] bool is_here(const Region& region) const {
    return region.section == slab_ || region.section == slab_ + 1;
  }
  [[nodiscard]] std::set<RegionPair> within(const std::set<RegionPair>& links,
                                            const std::vector<Region>& regions) const {
    std::set<RegionPair> here;
    for (const RegionPair& link : links) {
      if (regions[link.first].section == slab_) here.insert(link);
    }
    return here;
  }
  static std::size_t number(const std::vector<Region>& regions, std::size_t section,
                            std::uint32_t id) {
    std::size_t first = 0;
    while (regions[first].section < section) ++first;
    return first + id;
  }

  void count_solid(const CellOverlay::Face& face) {
    const std::size_t a = number(regions_, slab_, face.side[0].id);
    const std::size_t b = number(regions_, slab_ + 1, face.side[1].id);
    if (solid_[a] != solid_[b]) return;
    chi_[solid_[a]] -= face.chi;
    held_.emplace(a, b);
  }

  void count_void(const CellOverlay::Face& face) {
    const std::size_t a = number(voids_, slab_, face.side[0].id);
    const std::size_t b = number(voids_, slab_ + 1, face.side[1].id);
    if (hollow_[a] == hollow_[b]) {
      open_.emplace(a, b);
      return;
    }
    std::vector<std::size_t> around;
    for (const CellOverlay::Border& border : face.border) {
      around.push_back(number(regions_, slab_ + border.section, border.region));
    }
    chi_[solid_[around[0]]] += face.chi;
    for (const std::size_t r : around) {
      grouped_.emplace(solid_[around[0]], solid_[r]);
      for (const std::size_t q : around) {
        if (solid_[q] == solid_[r]) held_.emplace(q, r);
      }
    }
  }

  void count_bars() {
    const std::vector<std::size_t> piece = VoidRuleByWord::spread(regions_.size(), held_);
    std::map<std::size_t, std::set<std::size_t>> pieces;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (is_here(regions_[r])) pieces[solid_[r]].insert(piece[r]);
    }
    for (const auto& [of_class, all] : pieces) chi_[of_class] -= static_cast<long>(all.size()) - 1;
  }

  void count_tunnels() {
    const std::vector<std::size_t> piece = VoidRuleByWord::spread(voids_.size(), open_);
    std::map<std::size_t, std::set<std::size_t>> pieces;
    std::map<std::size_t, std::set<std::size_t>> around;
    for (std::size_t v = 0; v < voids_.size(); ++v) {
      if (!is_here(voids_[v])) continue;
      pieces[hollow_[v]].insert(piece[v]);
      if (const auto r = region_around(v)) around[hollow_[v]].insert(solid_[*r]);
    }
    for (const auto& [of_class, all] : pieces) {
      if (all.size() == 1) continue;
      const std::set<std::size_t>& solids = around[of_class];
      chi_[*solids.begin()] -= static_cast<long>(all.size()) - 1;
      for (const std::size_t solid : solids) grouped_.emplace(*solids.begin(), solid);
    }
  }

  // The region of which the void's outline is a hole. Contours of the complement are numbered with
  // one more in each section.
  [[nodiscard]] std::optional<std::size_t> region_around(std::size_t v) const {
    const std::vector<Point2>& outline = voids_[v].shape[0];
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (regions_[r].section != voids_[v].section) continue;
      const auto& shape = regions_[r].shape;
      if (std::find(shape.begin() + 1, shape.end(), outline) != shape.end()) return r;
    }
    return std::nullopt;
  }

  const std::vector<Region>& regions_;
  const std::vector<Region>& voids_;
  std::size_t slab_;
  std::vector<std::size_t> solid_, hollow_;     // classes
  std::set<RegionPair> held_, open_, grouped_;  // regions by faces, voids by faces, classes
  std::map<std::size_t, long> chi_;             // of classes
};

// The number of the first region of a section, and so on.
std::size_t number(const std::vector<Region>& of, std::size_t section, std::uint32_t id) {
  const auto first =
      std::find_if(of.begin(), of.end(), [&](const Region& r) { return r.section == section; });
  return static_cast<std::size_t>(first - of.begin()) + id;
}

// The region around a hole; none around the exterior, void 0. Complements have a contour more than
// each section.
std::optional<std::size_t> region_around(const SectionStack& stack,
                                         const std::vector<Region>& regions,
                                         const std::vector<Region>& voids, std::size_t s,
                                         std::uint32_t id) {
  if (id == 0) return std::nullopt;
  std::size_t contour = voids[number(voids, s, id)].contours.front();
  for (std::size_t t = 0; t < s; ++t) contour -= stack.sections[SectionId(t)].contours.size() + 1;
  const Nesting nesting = nest(stack.sections[SectionId(s)]);
  return number(regions, s, nesting.region[ContourId(contour)].value());
}

// V0: pairs of voids, as the rule numbers them, all of whose common faces are walled off.
std::set<RegionPair> walled_pairs(const SectionStack& stack, const std::vector<Region>& regions,
                                  const std::vector<Region>& voids,
                                  const std::set<RegionPair>& links) {
  std::set<RegionPair> walled, open;
  for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
    const Section& lower = stack.sections[SectionId(s)];
    const Section& upper = stack.sections[SectionId(s + 1)];
    const CellOverlay overlay(lower, nest(lower), upper, nest(upper));
    for (const CellOverlay::Face& face : overlay.faces()) {
      if (face.side[0].solid || face.side[1].solid) continue;
      bool wall = face.chi == 0 && face.border.size() == 2 && face.border[0].section == 0 &&
                  face.border[1].section == 1;
      if (wall) {
        const RegionPair pair{number(regions, s, face.border[0].region),
                              number(regions, s + 1, face.border[1].region)};
        wall = links.count(pair) != 0 &&
               squared_distance(regions[pair.first], regions[pair.second]) > Rational::exactly(0);
        const auto around_below = region_around(stack, regions, voids, s, face.side[0].id);
        const auto around_above = region_around(stack, regions, voids, s + 1, face.side[1].id);
        wall = wall &&
               (!around_below || !around_above || links.count({*around_below, *around_above}) == 0);
      }
      (wall ? walled : open)
          .emplace(number(voids, s, face.side[0].id), number(voids, s + 1, face.side[1].id));
    }
  }
  for (const RegionPair& pair : open) walled.erase(pair);
  return walled;
}

}  // namespace

ExpectedTopology expected_topology(const Model& model, const SectionStack& stack,
                                   const VoidOptions& options, const std::set<RegionPair>& links) {
  ExpectedTopology result;
  const SectionStack around = complement(stack);
  const std::vector<Region> regions = regions_of(stack);
  VoidRuleByWord rule(model, around, options,
                      walled_pairs(stack, regions, regions_of(around), links));
  rule.run(result);
  if (result.refused) return result;
  result.set = rule.sets();
  for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
    const Section& lower = stack.sections[SectionId(s)];
    const Section& upper = stack.sections[SectionId(s + 1)];
    const CellOverlay overlay(lower, nest(lower), upper, nest(upper));
    const auto overlay_of = [&](double larger) {
      const Section below = grown(lower, larger);
      const Section above = grown(upper, larger);
      return CellOverlay(below, nest(below), above, nest(above));
    };
    const auto chi_of = [&](const CellOverlay& of_solids, const CellOverlay& of_voids) {
      return FacesByWord(regions, rule.voids(), links, result.links, s).run(of_solids, of_voids);
    };
    result.chi.push_back(chi_of(overlay, overlay_of(-kBy)));
    result.chi_of_touches.push_back(chi_of(overlay_of(kBy), overlay));
  }
  return result;
}

}  // namespace tetloft::oracle
