// Guarantee 4: components by spreading, overlaps by areas.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "support/guarantee_oracle_parts.hpp"

namespace tetloft::oracle {

namespace {

struct Region {
  std::size_t section;
  std::vector<const Contour*> shape;  // the outer contour first
  std::vector<Polygon> outline;
  Rational area;  // twice
  std::vector<std::size_t> contours;
};

using Links = std::vector<std::pair<std::size_t, std::size_t>>;  // of regions, lower first

bool linked(const Links& links, std::size_t lower, std::size_t upper) {
  return std::count(links.begin(), links.end(), std::pair(lower, upper)) != 0;
}

Point2 centre(const Region& region) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Point2& p : region.shape[0]->vertices) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  const auto middle = [](const std::vector<double>& v) {
    return (*std::min_element(v.begin(), v.end()) + *std::max_element(v.begin(), v.end())) / 2;
  };
  return {middle(x), middle(y)};
}

// Do a, moved on as it came from `origin`, and b overlap by more than `drift`?
bool drifts_onto(const SectionStack& stack, const Region& origin, const Region& a, const Region& b,
                 double drift) {
  const auto gap = [&](const Region& r, const Region& q) {
    return std::abs(stack.sections[SectionId(r.section)].z -
                    stack.sections[SectionId(q.section)].z);
  };
  const double scale = gap(a, b) / gap(a, origin);
  const Point2 d{(centre(a).x - centre(origin).x) * scale,
                 (centre(a).y - centre(origin).y) * scale};
  std::vector<Polygon> moved;
  Rational area(0);
  for (const Contour* contour : a.shape) {
    Polygon polygon;
    for (const Point2& p : contour->vertices) {
      const Point2 q{p.x + d.x, p.y + d.y};
      if (!(std::max(std::abs(q.x), std::abs(q.y)) < kLargestCoordinate)) return false;
      polygon.push_back(exactly(q));
    }
    const Rational enclosed = twice_area(polygon).abs();
    area = moved.empty() ? enclosed : area - enclosed;
    moved.push_back(std::move(polygon));
  }
  if (!are_disjoint_simple(moved)) return false;
  for (std::size_t h = 1; h < moved.size(); ++h) {
    for (std::size_t c = 0; c < moved.size(); ++c) {
      if (c != h && is_inside(moved[h][0], moved[c]) != (c == 0)) return false;
    }
  }
  return Rational(2) * common_area(moved, b.outline) >
         Rational::exactly(drift) * std::min(area, b.area);
}

// The further links by drift, by definition.
[[maybe_unused]] Links drift_links(const SectionStack& stack, const std::vector<Region>& regions,
                                   const Links& overlap, double drift) {
  // The regions of section s that r is linked with.
  const auto partners = [&](std::size_t r, std::size_t s) {
    std::vector<std::size_t> result;
    for (std::size_t q = 0; q < regions.size(); ++q) {
      if (regions[q].section != s) continue;
      if (linked(overlap, r, q) || linked(overlap, q, r)) result.push_back(q);
    }
    return result;
  };
  Links links;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t j = 0; j < regions.size(); ++j) {
      const std::size_t s = regions[i].section;
      if (regions[j].section != s + 1) continue;
      if (!partners(i, s + 1).empty() || !partners(j, s).empty()) continue;
      const auto from_below = s == 0 ? std::vector<std::size_t>() : partners(i, s - 1);
      const auto from_above = partners(j, s + 2);
      if ((from_below.size() == 1 &&
           drifts_onto(stack, regions[from_below[0]], regions[i], regions[j], drift)) ||
          (from_above.size() == 1 &&
           drifts_onto(stack, regions[from_above[0]], regions[j], regions[i], drift))) {
        links.emplace_back(i, j);
      }
    }
  }
  return links;
}

std::vector<Region> regions_of(const SectionStack& stack) {
  std::vector<Region> regions;
  std::size_t number = 0;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    const auto contour = [&](std::size_t c) {
      return &stack.sections[SectionId(s)].contours[ContourId(c)];
    };
    std::vector<Polygon> polygons;
    for (const Contour& c : stack.sections[SectionId(s)].contours) {
      polygons.push_back(input_polygon(c));
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
      Region region{s, {contour(c)}, {polygons[c]}, twice_area(polygons[c]).abs(), {number + c}};
      for (std::size_t d = 0; d < polygons.size(); ++d) {
        const auto outside = around(d);
        if (outside.size() != around(c).size() + 1 ||
            std::count(outside.begin(), outside.end(), c) == 0) {
          continue;
        }
        region.shape.push_back(contour(d));
        region.outline.push_back(polygons[d]);
        region.area = region.area - twice_area(polygons[d]).abs();
        region.contours.push_back(number + d);
      }
      regions.push_back(region);
    }
    number += polygons.size();
  }
  return regions;
}

// By the overlap rule, without drift.
Links overlap_links(const std::vector<Region>& regions, double least_ratio) {
  struct Pair {
    std::size_t lower, upper;
    bool strong;
  };
  std::vector<Pair> pairs;
  const Rational tau = Rational::exactly(least_ratio);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t j = 0; j < regions.size(); ++j) {
      if (regions[j].section != regions[i].section + 1) continue;
      const Rational common = Rational(2) * common_area(regions[i].outline, regions[j].outline);
      const Rational least = std::min(regions[i].area, regions[j].area);
      if (common > tau * least) pairs.push_back({i, j, Rational(4) * common >= least});
    }
  }
  Links links;
  for (const Pair& pair : pairs) {
    const auto strong_at = [&](auto same) {
      return std::any_of(pairs.begin(), pairs.end(),
                         [&](const Pair& p) { return p.strong && same(p); });
    };
    const bool outruled = !pair.strong &&
                          strong_at([&](const Pair& p) { return p.lower == pair.lower; }) &&
                          strong_at([&](const Pair& p) { return p.upper == pair.upper; });
    if (!outruled) links.emplace_back(pair.lower, pair.upper);
  }
  return links;
}

}  // namespace

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
  const std::vector<Region> regions = regions_of(stack_);
  const Links links = overlap_links(regions, threshold_of(options_.correspondence));
  std::vector<std::size_t> set(stack_.contour_count());
  for (std::size_t c = 0; c < set.size(); ++c) set[c] = c;
  const auto unite = [&](std::size_t a, std::size_t b) {
    const std::size_t from = std::max(set[a], set[b]);
    const std::size_t to = std::min(set[a], set[b]);
    std::replace(set.begin(), set.end(), from, to);
  };
  for (const Region& region : regions) {
    for (const std::size_t c : region.contours) unite(region.contours[0], c);
  }
  for (const auto& [lower, upper] : links) {
    unite(regions[lower].contours[0], regions[upper].contours[0]);
  }
  return set;
}

}  // namespace tetloft::oracle
