// The Euler characteristic of what each slab should hold of each solid class: FACES of
// tetloft/voids.hpp, from the sections and the links of regions and voids.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "check/stack_voids.hpp"
#include "check/void_links.hpp"

namespace tetloft::internal::checking {

/// What an Euler characteristic may be: touches are solid or void.
struct ChiRange {
  long least = 0, most = 0;
  void add(long both) {
    least += both;
    most += both;
  }
  [[nodiscard]] bool holds(long chi) const { return least <= chi && chi <= most; }
  friend bool operator==(const ChiRange&, const ChiRange&) = default;
};

/// One slab. Classes, and groups of them, are named by their lowest region.
struct SlabTopology {
  std::size_t first = 0;                ///< the lowest region of the slab
  std::vector<std::size_t> class_of;    ///< of region `first` + i
  std::map<std::size_t, ChiRange> chi;  ///< expected, of each group
  std::vector<std::size_t> group_of;    ///< of region `first` + i
};

/// Per slab; `faces` are those of the stack. The links are those accepted, of regions, sorted, and
/// of voids.
[[nodiscard]] std::vector<SlabTopology> expected_topology(const StackVoids& stack,
                                                          const std::vector<Faces>& faces,
                                                          const std::vector<Link>& links,
                                                          const ExpectedVoids& voids);

/// 1 − its holes.
[[nodiscard]] long chi_of_region(const Regions& regions, std::size_t region);

/// Of the whole solid, ends beyond the stack included: they are prisms over regions, or nothing.
[[nodiscard]] ChiRange expected_chi(const StackVoids& stack,
                                    const std::vector<SlabTopology>& slabs);

/// The void of each void of all sections, over the stack: equal numbers, the same void. That of
/// section 0's exterior is the outside, to which beyond its ends the stack's holes lead.
[[nodiscard]] std::vector<std::size_t> expected_void_sets(const StackVoids& stack,
                                                          const ExpectedVoids& links);

}  // namespace tetloft::internal::checking
