// How far links part and join the regions of slabs as the solid does.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/sections.hpp>

namespace tetloft::bench {

/// Missing: unions to be added until no piece is in two classes; wrong: unions that the links made
/// and the solid does not.
struct UnionErrors {
  std::size_t missing = 0;
  std::size_t wrong = 0;
  [[nodiscard]] std::size_t sum() const { return missing + wrong; }
  UnionErrors& operator+=(const UnionErrors& other) {
    missing += other.missing;
    wrong += other.wrong;
    return *this;
  }
};

/// Over all slabs, of the links that were made. piece[k][r]: the piece of region r of slab k, those
/// below first, numbered as by nest().
[[nodiscard]] UnionErrors union_errors(const SectionStack& stack,
                                       const std::vector<RegionLink>& links,
                                       const std::vector<std::vector<std::size_t>>& piece);

}  // namespace tetloft::bench
