// The decision over the whole stack: union–find over regions, labels respected.
#include "reconstruct/correspondence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "core/union_find.hpp"

namespace tetloft {

namespace {

// The regions of all sections in one numbering, by (section, region).
class RegionNumbering {
 public:
  explicit RegionNumbering(const IdVector<SectionId, Nesting>& nestings) {
    first_.push_back(0);
    for (const Nesting& nesting : nestings) first_.push_back(first_.back() + nesting.outer.size());
  }
  [[nodiscard]] std::size_t of(SectionId s, RegionId r) const {
    return first_[s.index()] + r.index();
  }
  [[nodiscard]] std::size_t below(const Link& l) const {
    return of(SectionId(l.slab.index()), l.lower);
  }
  [[nodiscard]] std::size_t above(const Link& l) const {
    return of(SectionId(l.slab.index() + 1), l.upper);
  }
  [[nodiscard]] std::size_t size() const { return first_.back(); }

 private:
  std::vector<std::size_t> first_;
};

using RegionLabels = std::vector<std::optional<std::uint32_t>>;

Error label_error(const Label& label, std::string message) {
  Place place;
  place.section = label.section.index();
  place.contour = label.contour.index();
  return {ErrorCode::invalid_input, std::move(message), place};
}

Result<RegionLabels> labels_of_regions(const IdVector<SectionId, Nesting>& nestings,
                                       const RegionNumbering& numbering,
                                       const std::vector<Label>& labels) {
  RegionLabels result(numbering.size());
  for (const Label& label : labels) {
    if (label.section.index() >= nestings.size()) {
      return label_error(label, "the label names a section that does not exist");
    }
    const Nesting& nesting = nestings[label.section];
    if (label.contour.index() >= nesting.region.size()) {
      return label_error(label, "the label names a contour that does not exist");
    }
    auto& slot = result[numbering.of(label.section, nesting.region[label.contour])];
    if (slot && *slot != label.label) {
      return label_error(label, "two labels, " + std::to_string(*slot) + " and " +
                                    std::to_string(label.label) +
                                    ", on contours of one connected region");
    }
    slot = label.label;
  }
  return result;
}

// Sets of regions that know their label.
class LabelledSets {
 public:
  explicit LabelledSets(RegionLabels labels) : sets_(labels.size()), label_(std::move(labels)) {}

  [[nodiscard]] std::size_t find(std::size_t r) const { return sets_.find(r); }
  [[nodiscard]] const std::optional<std::uint32_t>& label(std::size_t r) const {
    return label_[sets_.find(r)];
  }
  [[nodiscard]] bool may_unite(std::size_t a, std::size_t b) const {
    return !label(a) || !label(b) || *label(a) == *label(b);
  }
  void unite(std::size_t a, std::size_t b) {
    const auto joint = label(a) ? label(a) : label(b);
    sets_.unite(a, b);
    label_[sets_.find(a)] = joint;
  }

 private:
  UnionFind sets_;
  RegionLabels label_;  // valid at representatives
};

// Distance of the nearest vertices of two regions, in the plane.
double vertex_distance(const RegionOutline& a, const RegionOutline& b) {
  double best = std::numeric_limits<double>::infinity();
  for (const Contour* c : a.contours) {
    for (const Contour* d : b.contours) {
      for (const Point2& p : c->vertices) {
        for (const Point2& q : d->vertices) best = std::min(best, std::hypot(p.x - q.x, p.y - q.y));
      }
    }
  }
  return best;
}

// Step 4 of the rule: links that connect what one label still leaves apart.
class LabelConnector {
 public:
  LabelConnector(const SectionStack& stack, const IdVector<SectionId, Nesting>& nestings,
                 const RegionNumbering& numbering, const RegionLabels& labels, LabelledSets& sets)
      : stack_(stack), nestings_(nestings), numbering_(numbering), labels_(labels), sets_(sets) {}

  // Adds the links for all labels, in increasing order; an Error if one cannot be realised.
  Result<void> connect(std::vector<Link>& accepted) {
    std::set<std::uint32_t> values;
    for (const auto& label : labels_) {
      if (label) values.insert(*label);
    }
    for (const std::uint32_t value : values) {
      while (const std::optional<std::size_t> apart = first_apart(value)) {
        if (!extend(value, accepted)) return unrealisable(value, *apart);
      }
    }
    return {};
  }

 private:
  // A way through sets: few links first, then short ones, then the lowest.
  struct Path {
    double distance = 0;
    std::vector<Link> links;
    [[nodiscard]] bool better_than(const Path& other) const {
      if (links.size() != other.links.size()) return links.size() < other.links.size();
      return distance != other.distance ? distance < other.distance : links < other.links;
    }
  };
  enum class State : std::uint8_t { unseen, open, done };

  [[nodiscard]] std::size_t first_with(std::uint32_t value) const {
    const auto at = std::find_if(labels_.begin(), labels_.end(),
                                 [&](const auto& label) { return label && *label == value; });
    return static_cast<std::size_t>(at - labels_.begin());
  }

  // A region of this label outside the set of its first one.
  [[nodiscard]] std::optional<std::size_t> first_apart(std::uint32_t value) const {
    const std::size_t home = sets_.find(first_with(value));
    for (std::size_t r = 0; r < labels_.size(); ++r) {
      if (labels_[r] && *labels_[r] == value && sets_.find(r) != home) return r;
    }
    return std::nullopt;
  }

  // Dijkstra from the set of the label's first region over sets of this label or none,
  // then accepts the links of the path found.
  bool extend(std::uint32_t value, std::vector<Link>& accepted) {
    const std::size_t home = sets_.find(first_with(value));
    // By representative of a set; the members of each set by representative.
    std::vector<State> state(numbering_.size(), State::unseen);
    std::vector<Path> path(numbering_.size());
    std::vector<std::vector<std::size_t>> members(numbering_.size());
    for (std::size_t r = 0; r < numbering_.size(); ++r) members[sets_.find(r)].push_back(r);

    std::vector<std::size_t> open{home};
    while (!open.empty()) {
      const auto nearest = std::min_element(
          open.begin(), open.end(),
          [&](std::size_t a, std::size_t b) { return path[a].better_than(path[b]); });
      const std::size_t set = *nearest;
      open.erase(nearest);
      state[set] = State::done;
      if (set != home && sets_.label(set) && *sets_.label(set) == value) {
        for (const Link& link : path[set].links) {
          accepted.push_back(link);
          sets_.unite(numbering_.below(link), numbering_.above(link));
        }
        return true;
      }
      for (const std::size_t r : members[set]) {
        for_each_neighbour(r, [&](const Link& link, std::size_t other) {
          const std::size_t to = sets_.find(other);
          if (state[to] == State::done) return;
          if (sets_.label(to) && *sets_.label(to) != value) return;
          Path longer = path[set];
          longer.distance += distance(link);
          longer.links.push_back(link);
          if (state[to] == State::unseen) {
            state[to] = State::open;
            open.push_back(to);
          } else if (!longer.better_than(path[to])) {
            return;
          }
          path[to] = std::move(longer);
        });
      }
    }
    return false;
  }

  // Smallest vertex distance of the two regions of a link, in space.
  double distance(const Link& link) {
    const auto [at, fresh] = distances_.try_emplace(link, 0.0);
    if (!fresh) return at->second;
    const SectionId below(link.slab.index());
    const SectionId above(link.slab.index() + 1);
    const double in_plane =
        vertex_distance(outline(stack_.sections[below], nestings_[below], link.lower),
                        outline(stack_.sections[above], nestings_[above], link.upper));
    return at->second = std::hypot(in_plane, stack_.sections[above].z - stack_.sections[below].z);
  }

  [[nodiscard]] std::pair<SectionId, RegionId> locate(std::size_t r) const {
    for (std::size_t s = 0;; ++s) {
      const std::size_t first = numbering_.of(SectionId(s), RegionId(0));
      if (r < first + nestings_[SectionId(s)].outer.size()) {
        return {SectionId(s), RegionId(r - first)};
      }
    }
  }
  template <class Visit>
  void for_each_neighbour(std::size_t r, const Visit& visit) const {
    const auto [s, region] = locate(r);
    if (s.index() > 0) {
      const SectionId below(s.index() - 1);
      for (std::size_t i = 0; i < nestings_[below].outer.size(); ++i) {
        const Link link{SlabId(below.index()), RegionId(i), region};
        visit(link, numbering_.below(link));
      }
    }
    if (s.index() + 1 < nestings_.size()) {
      const SectionId above(s.index() + 1);
      for (std::size_t i = 0; i < nestings_[above].outer.size(); ++i) {
        const Link link{SlabId(s.index()), region, RegionId(i)};
        visit(link, numbering_.above(link));
      }
    }
  }

  [[nodiscard]] Error unrealisable(std::uint32_t value, std::size_t apart) const {
    const auto name = [&](std::size_t r) {
      const auto [s, region] = locate(r);
      return "section " + std::to_string(s.index()) + " contour " +
             std::to_string(nestings_[s].outer[region].index());
    };
    const auto [s, region] = locate(apart);
    Place place;
    place.section = s.index();
    place.contour = nestings_[s].outer[region].index();
    return {ErrorCode::unrepresentable,
            "label " + std::to_string(value) +
                " cannot be realised: no way through regions of "
                "this label or none from " +
                name(first_with(value)) + " to " + name(apart),
            place};
  }

  const SectionStack& stack_;
  const IdVector<SectionId, Nesting>& nestings_;
  const RegionNumbering& numbering_;
  const RegionLabels& labels_;
  LabelledSets& sets_;
  std::map<Link, double> distances_;  // known ones
};

// Candidates in order of decreasing evidence.
std::vector<Link> by_evidence(const SectionStack& stack,
                              const IdVector<SectionId, Nesting>& nestings,
                              const IdVector<SlabId, std::vector<Link>>& candidates) {
  std::vector<std::pair<double, Link>> ranked;
  for (const std::vector<Link>& slab : candidates) {
    for (const Link& link : slab) {
      const SectionId below(link.slab.index());
      const SectionId above(link.slab.index() + 1);
      const double ratio =
          overlap_ratio(outline(stack.sections[below], nestings[below], link.lower),
                        outline(stack.sections[above], nestings[above], link.upper));
      ranked.emplace_back(-ratio, link);
    }
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<Link> links;
  links.reserve(ranked.size());
  for (const auto& entry : ranked) links.push_back(entry.second);
  return links;
}

}  // namespace

Result<Correspondence> decide_correspondence(const SectionStack& stack,
                                             const IdVector<SectionId, Nesting>& nestings,
                                             const IdVector<SlabId, std::vector<Link>>& candidates,
                                             const std::vector<Label>& labels) {
  const RegionNumbering numbering(nestings);
  const Result<RegionLabels> region_labels = labels_of_regions(nestings, numbering, labels);
  if (!region_labels) return region_labels.error();
  LabelledSets sets(*region_labels);

  std::vector<Link> accepted;
  if (labels.empty()) {
    for (const std::vector<Link>& slab : candidates) {
      accepted.insert(accepted.end(), slab.begin(), slab.end());
    }
    for (const Link& link : accepted) sets.unite(numbering.below(link), numbering.above(link));
  } else {
    for (const Link& link : by_evidence(stack, nestings, candidates)) {
      const std::size_t below = numbering.below(link);
      const std::size_t above = numbering.above(link);
      if (!sets.may_unite(below, above)) continue;
      sets.unite(below, above);
      accepted.push_back(link);
    }
    LabelConnector connector(stack, nestings, numbering, *region_labels, sets);
    if (Result<void> connected = connector.connect(accepted); !connected) {
      return connected.error();
    }
  }

  Correspondence result;
  result.links.resize(candidates.size());
  std::sort(accepted.begin(), accepted.end());
  accepted.erase(std::unique(accepted.begin(), accepted.end()), accepted.end());
  for (const Link& link : accepted) result.links[link.slab].push_back(link);

  // Components in order of their first contour.
  std::vector<ComponentId> component_of(numbering.size());
  std::size_t components = 0;
  result.component.resize(nestings.size());
  result.partition.resize(nestings.size());
  for (std::size_t s = 0; s < nestings.size(); ++s) {
    const Nesting& nesting = nestings[SectionId(s)];
    auto& of_region = result.component[SectionId(s)];
    auto& of_contour = result.partition[SectionId(s)];
    of_region.resize(nesting.outer.size());
    of_contour.resize(nesting.region.size());
    for (std::size_t c = 0; c < nesting.region.size(); ++c) {
      const RegionId region = nesting.region[ContourId(c)];
      ComponentId& id = component_of[sets.find(numbering.of(SectionId(s), region))];
      if (!id.valid()) id = ComponentId(components++);
      of_region[region] = id;
      of_contour[ContourId(c)] = id;
    }
  }
  return result;
}

}  // namespace tetloft
