// When is a section no longer needed? Slabs end in any order, on any thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "slab/numbering.hpp"

namespace tetloft::internal {

/// How many slabs beside each section are still to come, of those that are worked at. Safe to use
/// from several threads at once.
class SectionUses {
 public:
  SectionUses(std::size_t sections, const std::vector<SlabId>& slabs) : uses_(sections) {
    for (const SlabId slab : slabs) {
      for (const bool upper : {false, true}) ++uses_[section_of(slab, upper).index()];
    }
  }

  /// A slab is done, one of those given: calls release(s) for its sections that no other needs.
  template <class Release>
  void done(SlabId slab, const Release& release) {
    for (const bool upper : {false, true}) {
      const SectionId s = section_of(slab, upper);
      if (--uses_[s.index()] == 0) release(s);
    }
  }

 private:
  std::vector<std::atomic<std::uint32_t>> uses_;  // by section
};

}  // namespace tetloft::internal
