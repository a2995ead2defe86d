// Guarantee 4: components by spreading, against correspondence_oracle.hpp.
#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "support/correspondence_oracle.hpp"
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
  if (options_.correspondence.criterion == Criterion::reverse) {
    if (!verdict_.holds[3].has_value() || *verdict_.holds[3]) verdict_.holds[3] = std::nullopt;
    return;
  }
  const ExpectedSets expected = expected_sets(model_, stack_, options_.correspondence);
  if (!expected.realised) violate(4, "label not realised");
  if (!expected.claims_hold) violate(4, "motions or dropped links that the rule has not");
  for (std::size_t c = 0; c < expected.set.size(); ++c) {
    for (std::size_t d = 0; d < c; ++d) {
      const bool together = of_contour[c] == of_contour[d];
      if (together != (expected.set[c] == expected.set[d])) violate(4, "partition");
    }
  }
}

}  // namespace tetloft::oracle
