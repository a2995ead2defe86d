// How far links are from the truth.
#pragma once

#include <cstddef>
#include <vector>

#include "corpus/link_facts.hpp"

namespace tetloft::bench {

/// Missing: unions to be added until no piece is in two classes; false: unions made that the solid
/// does not have.
struct UnionErrors {
  std::size_t missing = 0, wrong = 0;
  [[nodiscard]] std::size_t sum() const { return missing + wrong; }
  UnionErrors& operator+=(const UnionErrors& other) {
    missing += other.missing;
    wrong += other.wrong;
    return *this;
  }
};

/// Of one slab, whose regions, the lower ones first, belong to the pieces.
[[nodiscard]] UnionErrors union_errors(std::size_t lows, const std::vector<std::size_t>& piece,
                                       const Pairs& links);

/// How many components the links leave.
[[nodiscard]] std::size_t component_count(const std::vector<SlabFacts>& slabs,
                                          const std::vector<Pairs>& links);

}  // namespace tetloft::bench
