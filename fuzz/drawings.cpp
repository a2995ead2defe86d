// Readers of drawings, each by its name: any bytes give a summary or a clean error; what a summary
// counts adds up; every structure gives a valid stack or a clean error.
#include <array>
#include <string>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "fuzz/target.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::fuzz;

constexpr std::array kNames{"rtstruct", "cxt", "csl", "slc", "imod"};

void try_stack(std::string_view bytes, ReadOptions options) {
  for (const Validity validity : {Validity::required, Validity::unchecked}) {
    options.validity = validity;
    const auto read = parse_stack(bytes, "fuzz", options);
    if (!fine(read) || validity == Validity::unchecked) continue;
    require(validate(read->stack).ok(), "a reader hands out a stack that is not valid");
  }
}

void check_counts(const FileSummary& summary) {
  require(summary.lines.has_value(), "a drawing without a summary of its lines");
  if (summary.structures.empty()) return;
  std::size_t contours = 0;
  std::size_t points = 0;
  for (const StructureSummary& structure : summary.structures) {
    contours += structure.contours;
    points += structure.points;
    std::size_t of_types = 0;
    for (const auto& [type, count] : structure.types) of_types += count;
    require(of_types == structure.contours, "types that do not add up");
  }
  require(contours == summary.lines->contours && points == summary.lines->points,
          "structures that do not add up");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes = text_of(data + 1, size - 1);
  ReadOptions options{.format = kNames[data[0] % kNames.size()]};
  const auto summary = inspect_bytes(bytes, "fuzz", options);
  if (!fine(summary)) {
    require(summary.error().where.file == "fuzz", "an error without the file's name");
    return 0;
  }
  check_counts(*summary);
  try_stack(bytes, options);
  constexpr std::size_t kMost = 3;
  for (std::size_t i = 0; i < summary->structures.size() && i < kMost; ++i) {
    options.structure = std::to_string(summary->structures[i].number);
    try_stack(bytes, options);
  }
  return 0;
}
