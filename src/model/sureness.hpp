// How sure a link is, as its users are told: least_sure_first() of links.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <tetloft/correspondence.hpp>

namespace tetloft::internal {

/// |margin|, or of a lone region |lead| if that is less; the less, the less sure.
[[nodiscard]] inline double sureness(const RegionLink& link) {
  if (link.fate == LinkFate::decided_part) return 1;  // as what a decision joined
  const double margin = std::abs(link.margin);
  return link.evidence == Evidence::lone && link.lead ? std::min(margin, std::abs(*link.lead))
                                                      : margin;
}

}  // namespace tetloft::internal
