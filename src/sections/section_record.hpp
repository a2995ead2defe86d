// A conforming section as bytes, for slabs that are built elsewhere or later.
#pragma once

#include <string>
#include <string_view>

#include <tetloft/conforming_section.hpp>

namespace tetloft::internal::sections {

[[nodiscard]] std::string to_record(const ConformingSection& section);

/// The section written by to_record(), the same in every bit. Refused (invalid_input; `name` stands
/// for the file) where the bytes are no such record, or none of a triangulated section: ids,
/// order, orientation and adjacency are verified; that it is Delaunay, that contours follow its
/// edges, and how they nest, is the writer's.
[[nodiscard]] Result<ConformingSection> section_from_record(std::string_view bytes,
                                                            const std::string& name);

}  // namespace tetloft::internal::sections
