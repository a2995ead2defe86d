// Candidates by drift (rule 1): regions without a link in a slab, where the only link that
// one of them has in the slab beyond says it moves to.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <tetloft/overlap.hpp>

#include "check/box_tree.hpp"
#include "check/partition.hpp"
#include "core/guard.hpp"

namespace tetloft::internal::checking {

namespace {

// The regions that each region is linked with in the section above, or below.
using Linked = std::vector<std::vector<std::size_t>>;

Box2 outer_box(const Contour& outer) {
  const Point2& start = outer.vertices.front();
  Box2 box{start, start};
  for (const Point2& p : outer.vertices) box.include({p, p});
  return box;
}

class DriftFinder {
 public:
  DriftFinder(const SectionStack& stack, const Regions& regions, const std::vector<Link>& overlap,
              double drift)
      : stack_(stack),
        regions_(regions),
        drift_(drift),
        up_(regions.size()),
        down_(regions.size()) {
    for (const Link& link : overlap) {
      up_[link.lower].push_back(link.upper);
      down_[link.upper].push_back(link.lower);
    }
    for (std::size_t r = 0; r < regions.size(); ++r) {
      const RegionOutline shape = outline_of(r);
      box_.push_back(outer_box(*shape.contours.front()));
    }
  }

  std::set<Link> run() {
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const std::size_t s = regions_.section[r];
      if (up_[r].empty() && down_[r].size() == 1 && s + 1 < stack_.sections.size()) {
        match(r, down_[r].front(), s + 1, down_);
      }
      if (down_[r].empty() && up_[r].size() == 1 && s > 0) match(r, up_[r].front(), s - 1, up_);
    }
    return std::move(links_);
  }

 private:
  // Region r, which came from `origin`, against the regions of section `to` that have no
  // link on its side.
  void match(std::size_t r, std::size_t origin, std::size_t to, const Linked& linked) {
    const double gap = std::abs(height(to) - height(regions_.section[r]));
    const double gap_before =
        std::abs(height(regions_.section[r]) - height(regions_.section[origin]));
    const double factor = gap / gap_before;
    const Point2 now = centre(r);
    const Point2 before = centre(origin);
    const Point2 d{(now.x - before.x) * factor, (now.y - before.y) * factor};
    const SectionStack moved = shifted(outline_of(r), d);
    if (!accepted(validate(moved))) return;
    const Section& section = moved.sections[SectionId(0)];
    const Nesting nesting = nest(section);
    if (!is_one_region(nesting)) return;
    const RegionOutline shape = outline(section, nesting, RegionId(0));
    const Box2 box = outer_box(*shape.contours.front());
    for (std::size_t q = regions_.first[to]; q < regions_.first[to + 1]; ++q) {
      if (!linked[q].empty() || !box.meets(box_[q])) continue;
      if (compare_overlap(outline_of(q), shape, drift_) != Sign::positive) continue;
      links_.insert({std::min(r, q), std::max(r, q)});
    }
  }

  // The first contour with holes in it, all others.
  static bool is_one_region(const Nesting& nesting) {
    return nesting.outer.size() == 1 && nesting.outer[RegionId(0)].index() == 0;
  }

  static SectionStack shifted(const RegionOutline& shape, const Point2& d) {
    Section section;
    for (const Contour* contour : shape.contours) {
      Contour there;
      for (const Point2& p : contour->vertices) there.vertices.push_back({p.x + d.x, p.y + d.y});
      section.contours.push_back(std::move(there));
    }
    SectionStack stack;
    stack.sections.push_back(std::move(section));
    return stack;
  }

  [[nodiscard]] double height(std::size_t section) const {
    return stack_.sections[SectionId(section)].z;
  }
  [[nodiscard]] Point2 centre(std::size_t r) const {
    const auto& [low, high] = box_[r];
    return {(low.x + high.x) / 2, (low.y + high.y) / 2};
  }
  [[nodiscard]] RegionOutline outline_of(std::size_t r) const {
    const std::size_t s = regions_.section[r];
    return outline(stack_.sections[SectionId(s)], regions_.nesting[s], regions_.local(r));
  }

  const SectionStack& stack_;
  const Regions& regions_;
  double drift_;
  Linked up_, down_;
  std::vector<Box2> box_;  // of outer contours
  std::set<Link> links_;
};

}  // namespace

std::vector<Link> drift_links(const SectionStack& stack, const Regions& regions,
                              const std::vector<Link>& overlap, double drift) {
  const std::set<Link> links = DriftFinder(stack, regions, overlap, drift).run();
  return {links.begin(), links.end()};
}

}  // namespace tetloft::internal::checking
