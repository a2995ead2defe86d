// Labels: rules 5 to 7 of correspondence.hpp, decided for the whole stack.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "check/box_tree.hpp"
#include "check/partition.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::checking {

namespace {

using RegionLabel = std::optional<std::uint32_t>;

// Sets of regions, and the label that any of their members has.
class LabelledSets {
 public:
  explicit LabelledSets(const std::vector<RegionLabel>& label)
      : sets_(label.size()), label_(label) {}

  [[nodiscard]] std::size_t find(std::size_t region) const { return sets_.find(region); }
  [[nodiscard]] RegionLabel label(std::size_t region) const { return label_[find(region)]; }

  [[nodiscard]] bool may_unite(std::size_t a, std::size_t b) const {
    const RegionLabel of_a = label(a);
    const RegionLabel of_b = label(b);
    return !of_a.has_value() || !of_b.has_value() || *of_a == *of_b;
  }
  void unite(std::size_t a, std::size_t b) {
    const RegionLabel joint = label(a).has_value() ? label(a) : label(b);
    sets_.unite(a, b);
    label_[find(a)] = joint;
  }

 private:
  UnionFind sets_;
  std::vector<RegionLabel> label_;  // of representatives
};

// The vertices of each region as a tree, for smallest vertex distances.
class VertexDistances {
 public:
  VertexDistances(const SectionStack& stack, const Regions& regions)
      : regions_(regions), points_(regions.size()), trees_(regions.size()) {
    for (std::size_t s = 0; s < stack.sections.size(); ++s) {
      const auto& contours = stack.sections[SectionId(s)].contours;
      for (std::size_t c = 0; c < contours.size(); ++c) {
        std::vector<Point2>& points = points_[regions.of(s, c)];
        const auto& vertices = contours[ContourId(c)].vertices;
        points.insert(points.end(), vertices.begin(), vertices.end());
      }
    }
    for (std::size_t r = 0; r < regions.size(); ++r) {
      std::vector<Box2> boxes;
      for (const Point2& p : points_[r]) boxes.push_back({p, p});
      trees_[r] = BoxTree(std::move(boxes));
    }
  }

  [[nodiscard]] double between(const Link& link) {
    const auto [at, fresh] = known_.try_emplace(link, 0.0);
    if (!fresh) return at->second;
    double best = std::numeric_limits<double>::infinity();
    for (const Point2& p : points_[link.lower]) {
      best = trees_[link.upper].nearest(p, 0, best, [&](std::uint32_t i) {
        const Point2& q = points_[link.upper][i];
        return std::hypot(p.x - q.x, p.y - q.y);
      });
    }
    return at->second = std::hypot(best, regions_.gap(link));
  }

 private:
  const Regions& regions_;
  std::vector<std::vector<Point2>> points_;
  std::vector<BoxTree> trees_;
  std::map<Link, double> known_;
};

// A path through sets, compared as rule 7 says.
struct Path {
  double distance = 0;
  std::vector<Link> links;

  [[nodiscard]] bool better_than(const Path& other) const {
    if (links.size() != other.links.size()) return links.size() < other.links.size();
    if (distance != other.distance) return distance < other.distance;
    return links < other.links;
  }
};

// Rule 7 for one label: the path from the set of `start` to another set of its label.
// Dijkstra's algorithm over sets.
class PathFinder {
 public:
  PathFinder(const Regions& regions, const LabelledSets& sets, const std::set<Link>& closed,
             VertexDistances& distances)
      : regions_(regions), sets_(sets), closed_(closed), distances_(distances) {
    for (std::size_t r = 0; r < regions.size(); ++r) members_[sets.find(r)].push_back(r);
  }

  std::optional<Path> find(std::size_t start, std::uint32_t label) {
    std::map<std::size_t, Path> open{{sets_.find(start), {}}};
    std::map<std::size_t, Path> done;
    while (!open.empty()) {
      auto next = open.begin();
      for (auto i = open.begin(); i != open.end(); ++i) {
        if (i->second.better_than(next->second)) next = i;
      }
      const auto [set, path] = *next;
      open.erase(next);
      if (!path.links.empty() && sets_.label(set) == RegionLabel(label)) return path;
      for (const std::size_t region : members_[set]) {
        const std::size_t s = regions_.section[region];
        if (s > 0) expand(path, region, s - 1, label, open, done);
        if (s + 2 < regions_.first.size()) expand(path, region, s + 1, label, open, done);
      }
      done.emplace(set, path);
    }
    return std::nullopt;
  }

 private:
  void expand(const Path& path, std::size_t region, std::size_t section, std::uint32_t label,
              std::map<std::size_t, Path>& open, const std::map<std::size_t, Path>& done) {
    for (std::size_t to = regions_.first[section]; to < regions_.first[section + 1]; ++to) {
      const std::size_t set = sets_.find(to);
      const RegionLabel of_set = sets_.label(set);
      if (set == sets_.find(region) || done.count(set) != 0 ||
          (of_set.has_value() && *of_set != label)) {
        continue;
      }
      const Link link = link_between(region, to);
      if (closed_.count(link) != 0) continue;
      Path longer = path;
      longer.distance += distances_.between(link);
      longer.links.push_back(link);
      const auto [at, fresh] = open.try_emplace(set, longer);
      if (!fresh && longer.better_than(at->second)) at->second = std::move(longer);
    }
  }

  const Regions& regions_;
  const LabelledSets& sets_;
  const std::set<Link>& closed_;
  VertexDistances& distances_;
  std::map<std::size_t, std::vector<std::size_t>> members_;
};

// Rules 5 and 6. Returns a joined pair of different labels, if there is one.
std::optional<Link> accept_by_evidence(std::vector<Candidate> candidates, LabelledSets& sets,
                                       std::vector<Link>& accepted) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    if (a.joined != b.joined) return a.joined;
    if (!a.joined && a.s != b.s) return a.s > b.s;
    return a.link < b.link;
  });
  for (const auto& [link, s, joined] : candidates) {
    if (sets.may_unite(link.lower, link.upper)) {
      sets.unite(link.lower, link.upper);
      accepted.push_back(link);
    } else if (joined) {
      return link;
    }
  }
  return std::nullopt;
}

// Rule 7. Returns a label that cannot be realised, if there is one.
RegionLabel connect_labels(const SectionStack& stack, const Regions& regions,
                           const std::vector<RegionLabel>& label, const std::set<Link>& closed,
                           LabelledSets& sets, std::vector<Link>& accepted) {
  std::map<std::uint32_t, std::vector<std::size_t>> regions_of;
  for (std::size_t r = 0; r < label.size(); ++r) {
    if (label[r].has_value()) regions_of[*label[r]].push_back(r);
  }
  VertexDistances distances(stack, regions);
  for (const auto& [value, members] : regions_of) {
    const auto apart = [&, &own = members] {
      return std::any_of(own.begin(), own.end(),
                         [&](std::size_t r) { return sets.find(r) != sets.find(own.front()); });
    };
    while (apart()) {
      const auto path = PathFinder(regions, sets, closed, distances).find(members.front(), value);
      if (!path.has_value()) return value;
      for (const Link& link : path->links) {
        sets.unite(link.lower, link.upper);
        accepted.push_back(link);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

RegionSets unite_regions(const SectionStack& stack, const Regions& regions,
                         std::vector<Candidate> candidates, const std::vector<RegionLabel>& label,
                         const std::set<Link>& closed) {
  LabelledSets sets(label);
  RegionSets result;
  result.contradicted = accept_by_evidence(std::move(candidates), sets, result.accepted);
  const bool labelled =
      std::any_of(label.begin(), label.end(), [](const RegionLabel& l) { return l.has_value(); });
  if (labelled && !result.contradicted.has_value()) {
    result.unrealised = connect_labels(stack, regions, label, closed, sets, result.accepted);
  }
  std::sort(result.accepted.begin(), result.accepted.end());
  for (std::size_t r = 0; r < regions.size(); ++r) result.set.push_back(sets.find(r));
  return result;
}

}  // namespace tetloft::internal::checking
