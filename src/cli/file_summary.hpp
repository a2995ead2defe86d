// What a file holds, for programs and for people.
#pragma once

#include <string>

#include <tetloft/tetloft.hpp>

#include "cli/json.hpp"

namespace tetloft::cli {

/// Members "format"; "structures"; "size", "spacing", "matrix", "space", "type", "range" and
/// "labels" of a volume; "planes", "points", "open", "closed" and "labels" of contours; "contours";
/// "unit". Counts are those of the file, but "contours" those of `stack` where the file's own are
/// not known.
void write_summary(JsonWriter& json, const FileSummary& file, const SectionStack* stack);
[[nodiscard]] std::string describe_summary(const FileSummary& file);

}  // namespace tetloft::cli
