#include "correspondence/label_connector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <tetloft/overlap.hpp>

namespace tetloft::internal {

namespace {

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

class LabelConnector {
 public:
  LabelConnector(const SectionStack& stack, const IdVector<SectionId, Nesting>& nestings,
                 const StackRegions& regions, const RegionLabels& labels, const RegionNames& names,
                 const std::set<Link>& closed, LabelledSets& sets)
      : stack_(stack),
        nestings_(nestings),
        regions_(regions),
        labels_(labels),
        names_(names),
        closed_(closed),
        sets_(sets) {}

  // Adds the links for all labels, in increasing order; an Error if one cannot be realised.
  Result<void> connect(std::vector<Link>& accepted) {
    std::set<std::uint32_t> values;
    for (const auto& label : labels_) {
      if (label) values.insert(*label);
    }
    for (const std::uint32_t value : values) {
      while (const std::optional<StackRegionId> apart = first_apart(value)) {
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

  [[nodiscard]] StackRegionId first_with(std::uint32_t value) const {
    const auto at = std::find_if(labels_.begin(), labels_.end(),
                                 [&](const auto& label) { return label && *label == value; });
    return StackRegionId(at - labels_.begin());
  }

  // A region of this label outside the set of its first one.
  [[nodiscard]] std::optional<StackRegionId> first_apart(std::uint32_t value) const {
    const StackRegionId home = sets_.find(first_with(value));
    for (const StackRegionId r : labels_.ids()) {
      if (labels_[r] && *labels_[r] == value && sets_.find(r) != home) return r;
    }
    return std::nullopt;
  }

  // Dijkstra from the set of the label's first region over sets of this label or none,
  // then accepts the links of the path found.
  bool extend(std::uint32_t value, std::vector<Link>& accepted) {
    const StackRegionId home = sets_.find(first_with(value));
    // By representative of a set; the members of each set by representative.
    IdVector<StackRegionId, State> state(regions_.size(), State::unseen);
    IdVector<StackRegionId, Path> path(regions_.size());
    IdVector<StackRegionId, std::vector<StackRegionId>> members(regions_.size());
    for (const StackRegionId r : members.ids()) members[sets_.find(r)].push_back(r);

    std::vector<StackRegionId> open{home};
    while (!open.empty()) {
      const auto nearest = std::min_element(
          open.begin(), open.end(),
          [&](StackRegionId a, StackRegionId b) { return path[a].better_than(path[b]); });
      const StackRegionId set = *nearest;
      open.erase(nearest);
      state[set] = State::done;
      if (set != home && sets_.label(set) && *sets_.label(set) == value) {
        for (const Link& link : path[set].links) {
          accepted.push_back(link);
          sets_.unite(regions_.below(link), regions_.above(link));
        }
        return true;
      }
      for (const StackRegionId r : members[set]) {
        for_each_neighbour(r, [&](const Link& link, StackRegionId other) {
          const StackRegionId to = sets_.find(other);
          if (state[to] == State::done) return;
          if (sets_.label(to) && *sets_.label(to) != value) return;
          if (closed_.contains(link)) return;
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
    const SectionId below = lower_section(link.slab);
    const SectionId above = upper_section(link.slab);
    const double in_plane =
        vertex_distance(outline(stack_.sections[below], nestings_[below], link.lower),
                        outline(stack_.sections[above], nestings_[above], link.upper));
    return at->second = std::hypot(in_plane, stack_.sections[above].z - stack_.sections[below].z);
  }

  template <class Visit>
  void for_each_neighbour(StackRegionId r, const Visit& visit) const {
    const auto [s, region] = regions_.locate(r);
    if (s.index() > 0) {
      const SectionId below(s.index() - 1);
      for (std::size_t i = 0; i < nestings_[below].outer.size(); ++i) {
        const Link link{SlabId(below.index()), RegionId(i), region};
        visit(link, regions_.below(link));
      }
    }
    if (s.index() + 1 < nestings_.size()) {
      const SectionId above(s.index() + 1);
      for (std::size_t i = 0; i < nestings_[above].outer.size(); ++i) {
        const Link link{SlabId(s.index()), region, RegionId(i)};
        visit(link, regions_.above(link));
      }
    }
  }

  [[nodiscard]] Error unrealisable(std::uint32_t value, StackRegionId apart) const {
    const auto name = [&](StackRegionId r) {
      const auto [s, region] = regions_.locate(r);
      return "section " + std::to_string(s.index()) + " " + names_.of(s, region);
    };
    const auto [s, region] = regions_.locate(apart);
    return {ErrorCode::unrepresentable,
            "label " + std::to_string(value) + " cannot be realised: no way through " +
                names_.many() + " of this label or none from " + name(first_with(value)) + " to " +
                name(apart),
            names_.place(s, region)};
  }

  const SectionStack& stack_;
  const IdVector<SectionId, Nesting>& nestings_;
  const StackRegions& regions_;
  const RegionLabels& labels_;
  const RegionNames& names_;
  const std::set<Link>& closed_;
  LabelledSets& sets_;
  std::map<Link, double> distances_;  // known ones
};

}  // namespace

Result<void> connect_labels(const SectionStack& stack, const IdVector<SectionId, Nesting>& nestings,
                            const StackRegions& regions, const RegionLabels& labels,
                            const RegionNames& names, const std::set<Link>& closed,
                            LabelledSets& sets, std::vector<Link>& accepted) {
  return LabelConnector(stack, nestings, regions, labels, names, closed, sets).connect(accepted);
}

}  // namespace tetloft::internal
