// Guarantee 4: components by spreading, overlaps by areas.
#include <algorithm>
#include <optional>
#include <set>

#include "support/guarantee_oracle_parts.hpp"

namespace tetloft::oracle {

void Oracle::components() {
  std::vector<std::size_t> component(tets_.size());
  for (std::size_t t = 0; t < tets_.size(); ++t) component[t] = t;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [face, uses] : uses_) {
      std::size_t least = component[uses[0].tet];
      for (const Use& use : uses) least = std::min(least, component[use.tet]);
      for (const Use& use : uses) {
        changed |= component[use.tet] != least;
        component[use.tet] = least;
      }
    }
  }
  // The components of every contour vertex, inserted ones included by their edges.
  std::vector<std::set<std::size_t>> of_contour;
  std::set<std::size_t> with_contour;
  for (std::size_t s = 0; s < stack_.sections.size(); ++s) {
    for (const Contour& contour : stack_.sections[SectionId(s)].contours) {
      of_contour.emplace_back();
      for (const Point2& p : contour.vertices) {
        for (std::size_t v = 0; v < points_.size(); ++v) {
          if (model_.points[VertexId(v)] != Point3{p.x, p.y, z(s)} || star_.count(v) == 0) continue;
          for (const std::size_t t : star_.at(v)) of_contour.back().insert(component[t]);
        }
      }
      with_contour.insert(of_contour.back().begin(), of_contour.back().end());
      if (of_contour.back().size() != 1) violate(4, "contour not on one component");
    }
  }
  for (const std::size_t c : component) {
    if (with_contour.count(c) == 0) violate(4, "component without contour");
  }
  if (options_.correspondence.criterion != Criterion::overlap ||
      !options_.correspondence.labels.empty()) {
    if (!verdict_.holds[3].has_value() || *verdict_.holds[3]) verdict_.holds[3] = std::nullopt;
    return;
  }
  const std::vector<std::size_t> expected = expected_sets();
  for (std::size_t c = 0; c < expected.size(); ++c) {
    for (std::size_t d = 0; d < c; ++d) {
      const bool together = of_contour[c] == of_contour[d];
      if (together != (expected[c] == expected[d])) violate(4, "partition");
    }
  }
}

std::vector<std::size_t> Oracle::expected_sets() const {
  struct Region {
    std::size_t section;
    std::vector<Polygon> outline;
    Rational area;  // twice
    std::vector<std::size_t> contours;
  };
  std::vector<Region> regions;
  std::size_t number = 0;
  for (std::size_t s = 0; s < stack_.sections.size(); ++s) {
    std::vector<Polygon> polygons;
    for (const Contour& contour : stack_.sections[SectionId(s)].contours) {
      polygons.push_back(input_polygon(contour));
    }
    const auto around = [&](std::size_t c) {
      std::vector<std::size_t> result;
      for (std::size_t d = 0; d < polygons.size(); ++d) {
        if (c != d && is_inside(polygons[c][0], polygons[d])) result.push_back(d);
      }
      return result;
    };
    for (std::size_t c = 0; c < polygons.size(); ++c) {
      if (around(c).size() % 2 == 1) continue;
      Region region{s, {polygons[c]}, twice_area(polygons[c]).abs(), {number + c}};
      for (std::size_t d = 0; d < polygons.size(); ++d) {
        const auto outside = around(d);
        if (outside.size() != around(c).size() + 1 ||
            std::count(outside.begin(), outside.end(), c) == 0) {
          continue;
        }
        region.outline.push_back(polygons[d]);
        region.area = region.area - twice_area(polygons[d]).abs();
        region.contours.push_back(number + d);
      }
      regions.push_back(region);
    }
    number += polygons.size();
  }
  struct Pair {
    std::size_t lower, upper;
    bool strong;
  };
  std::vector<Pair> pairs;
  const Rational tau = Rational::exactly(options_.correspondence.tau);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t j = 0; j < regions.size(); ++j) {
      if (regions[j].section != regions[i].section + 1) continue;
      const Rational common = Rational(2) * common_area(regions[i].outline, regions[j].outline);
      const Rational least = std::min(regions[i].area, regions[j].area);
      if (common > tau * least) pairs.push_back({i, j, Rational(4) * common >= least});
    }
  }
  std::vector<std::size_t> set(number);
  for (std::size_t c = 0; c < number; ++c) set[c] = c;
  const auto unite = [&](std::size_t a, std::size_t b) {
    const std::size_t from = std::max(set[a], set[b]);
    const std::size_t to = std::min(set[a], set[b]);
    std::replace(set.begin(), set.end(), from, to);
  };
  for (const Region& region : regions) {
    for (const std::size_t c : region.contours) unite(region.contours[0], c);
  }
  for (const Pair& pair : pairs) {
    const auto strong_at = [&](auto same) {
      return std::any_of(pairs.begin(), pairs.end(),
                         [&](const Pair& p) { return p.strong && same(p); });
    };
    const bool outruled = !pair.strong &&
                          strong_at([&](const Pair& p) { return p.lower == pair.lower; }) &&
                          strong_at([&](const Pair& p) { return p.upper == pair.upper; });
    if (!outruled) unite(regions[pair.lower].contours[0], regions[pair.upper].contours[0]);
  }
  return set;
}

}  // namespace tetloft::oracle
