// Sections put between those of a slab, as a part of a plan's record.
#pragma once

#include <cstddef>

#include "between/inner_sections.hpp"
#include "core/record.hpp"

namespace tetloft::internal {

void put_section(const Section& section, RecordWriter& out);
/// As it was written; whether it is valid is not looked at.
[[nodiscard]] Section get_section(RecordReader& in);

void put_inner(const between::InnerSections& inner, RecordWriter& out);
/// Refused are sections that are not valid.
[[nodiscard]] between::InnerSections get_inner(RecordReader& in);
/// Do they fit a slab of so many regions below and above?
[[nodiscard]] bool fits_slab(const between::InnerSections& inner, std::size_t lower,
                             std::size_t upper);

}  // namespace tetloft::internal
