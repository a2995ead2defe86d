// Readers of level lines and contours, and of points, each by its name: any bytes give a summary, a
// valid stack, closed along the frame or not, and points, or a clean error; what was read survives
// writing in every format of contours.
#include <array>
#include <string>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "fuzz/target.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::fuzz;

constexpr std::array kDrawings{"geojson", "svg", "dxf", "vtp", "csv", "cnt"};
constexpr std::array kPoints{"xyz", "node", "ply", "vtp"};

void survives_writing(const SectionStack& stack) {
  for (const char* name : {"geojson", "vtp", "csl"}) {
    const auto once = format_stack(stack, {.format = name});
    require(once.ok(), "a stack that was read cannot be written");
    // Planes in other directions are turned, which rounds.
    if (stack.frame != Frame()) continue;
    const auto again = parse_stack(once->bytes, "again", {.format = name});
    require(again.ok(), "a stack that was written cannot be read");
    require(again->stack.vertex_count() == stack.vertex_count(), "vertices were lost");
    require(format_stack(again->stack, {.format = name})->bytes == once->bytes,
            "a stack does not survive writing");
  }
}

void try_drawing(std::string_view bytes, ReadOptions options) {
  const auto summary = inspect_bytes(bytes, "fuzz", options);
  if (!fine(summary)) {
    require(summary.error().where.file == "fuzz" || summary.error().code == ErrorCode::usage,
            "an error without the file's name");
  } else {
    require(summary->lines.has_value(), "a drawing without a summary of its lines");
  }
  if (summary && !summary->structures.empty()) {
    options.structure = std::to_string(summary->structures.front().number);
  }
  const auto read = parse_stack(bytes, "fuzz", options);
  if (fine(read)) {
    require(validate(read->stack).ok(), "a reader hands out a stack that is not valid");
    survives_writing(read->stack);
  }
  options.validity = Validity::unchecked;
  static_cast<void>(fine(parse_stack(bytes, "fuzz", options)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes = text_of(data + 1, size - 1);
  const std::size_t which = data[0] % (2 * kDrawings.size() + kPoints.size());
  if (which < 2 * kDrawings.size()) {
    ReadOptions options{.format = kDrawings[which / 2]};
    options.close_on_frame = which % 2 == 1;
    try_drawing(bytes, options);
    return 0;
  }
  const ReadOptions options{.format = kPoints[which - 2 * kDrawings.size()]};
  const auto points = parse_points(bytes, "fuzz", options);
  if (!fine(points)) return 0;
  const auto once = format_points(points->points, {.format = "xyz"});
  require(once.ok(), "points that were read cannot be written");
  const auto again = parse_points(once->bytes, "again", {.format = "xyz"});
  require(again.ok() && format_points(again->points, {.format = "xyz"})->bytes == once->bytes,
          "points do not survive writing");
  return 0;
}
