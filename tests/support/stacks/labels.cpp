#include <algorithm>
#include <vector>

#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

std::vector<Label> random_labels(Prng& prng, const SectionStack& stack) {
  const std::size_t n = stack.sections.size();
  // Unlabelled regions of each section, by their outer contour.
  std::vector<std::vector<ContourId>> unlabelled(n);
  for (std::size_t s = 0; s < n; ++s) {
    const Nesting nesting = nest(stack.sections[SectionId(s)]);
    unlabelled[s].assign(nesting.outer.begin(), nesting.outer.end());
    prng.shuffle(unlabelled[s]);
  }

  std::vector<Label> labels;
  const std::size_t wanted = number(prng, 1, 4);
  for (std::size_t k = 0; k < wanted; ++k) {
    // Label numbers need not be consecutive, nor in order of sections.
    const auto label = static_cast<std::uint32_t>(10 * prng.below(100) + k);
    const std::size_t first = number(prng, 0, n - 1);
    std::vector<std::pair<std::size_t, ContourId>> chosen;
    for (std::size_t s = first; s < n && !unlabelled[s].empty(); ++s) {
      const std::size_t most = std::min<std::size_t>(unlabelled[s].size(), 3);
      for (std::size_t take = number(prng, 1, most); take > 0; --take) {
        chosen.push_back({s, unlabelled[s].back()});
        unlabelled[s].pop_back();
      }
      if (prng.chance(0.3)) break;
    }
    if (!chosen.empty() && chosen.front().first == chosen.back().first) chosen.resize(1);
    for (const auto& [section, contour] : chosen) {
      labels.push_back({SectionId(section), contour, label});
    }
  }
  return labels;
}

}  // namespace tetloft::testing
