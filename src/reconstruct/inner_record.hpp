// Sections put between those of a slab, as a part of a plan's record.
#pragma once

#include <cstddef>

#include "between/inner_sections.hpp"
#include "core/record.hpp"

namespace tetloft::internal {

void put_inner(const between::InnerSections& inner, RecordWriter& out);

/// `lower` and `upper`: the number of regions in the slab's two sections. Refused are sections that
/// are not valid, and classes and regions that there are not.
[[nodiscard]] between::InnerSections get_inner(RecordReader& in, std::size_t lower,
                                               std::size_t upper);

}  // namespace tetloft::internal
