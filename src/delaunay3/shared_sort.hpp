// Sorting by 64-bit keys on several threads.
#pragma once

#include <span>

#include "spatial/sort_by_key.hpp"

namespace tetloft::internal::delaunay3_detail {

/// As sort_by_key(): dealt out to ranges of keys first, which threads then sort for themselves.
void sort_by_key_shared(std::span<Keyed> entries, unsigned threads);

}  // namespace tetloft::internal::delaunay3_detail
