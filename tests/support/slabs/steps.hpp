// The steps of a slab up to where a test wants to look.
#pragma once

#include <cstdint>
#include <vector>

#include "completion/completion.hpp"
#include "subdivision/lifting.hpp"
#include "subdivision/subdivision.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;

struct Completed {
  IdVector<ClassId, std::uint8_t> active;
  Complex seed;
  Complex complex;
  std::vector<LeftApart> apart;
  RuleCounts rules{};
};
[[nodiscard]] Completed complete(const SlabCase& c, bool lone_too);

/// With lone classes.
struct Subdivided {
  Complex complex;
  Subdivision subdivision;
  RuleCounts rules{};
};
[[nodiscard]] Subdivided subdivide_case(const SlabCase& c);

[[nodiscard]] inline std::uint64_t fired(const RuleCounts& rules, Rule rule) {
  return rules.at(static_cast<std::size_t>(rule));
}

}  // namespace tetloft::testing
