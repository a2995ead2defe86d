// A section as a part of a record.
#pragma once

#include <tetloft/section_stack.hpp>

#include "core/record.hpp"

namespace tetloft::internal {

void put_section(const Section& section, RecordWriter& out);
/// As it was written; whether it is valid is not looked at.
[[nodiscard]] Section get_section(RecordReader& in);

}  // namespace tetloft::internal
