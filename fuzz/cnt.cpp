// The .cnt reader: any bytes give a valid stack or a clean error, and what was read is the same
// after mending, snapping and validating again; repaired stacks are valid. Sections that are read
// one after the other, in blocks of any size, are those of the whole, told of in the same words.
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <tetloft/io.hpp>
#include <tetloft/sections.hpp>

#include "fuzz/target.hpp"
#include "io/cnt_sections.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::fuzz;

void compare_sections(std::string_view text, const Result<ReadStack>& whole) {
  using namespace internal::io;
  const std::string name = "fuzz.cnt";
  const CntBlocks blocks{1 + text.size() % 61, 1 + text.size() % 127, kLargestFile};
  auto file = std::make_unique<MemoryBytes>(text);
  auto survey = survey_cnt(*file, name, blocks, {});
  if (!survey) {
    require(!whole && to_string(survey.error()) == to_string(whole.error()),
            "sections are refused in other words: " + to_string(survey.error()));
    return;
  }
  if (!survey->has_value()) return;
  require(whole.ok(), "sections of a faulty file are handed out");
  const auto& warnings = (*survey)->warnings;
  require(warnings.size() == whole->warnings.size(), "another number of warnings");
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    require(to_string(warnings[i]) == to_string(whole->warnings[i]), "another warning");
  }
  CntSections sections(std::move(file), name, **std::move(survey), blocks);
  for (const Section& section : whole->stack.sections) {
    const auto next = sections.next();
    require(next.ok() && next->has_value(), "a section is missing");
    require((*next)->z == section.z && (*next)->contours.size() == section.contours.size(),
            "another section");
    for (const ContourId c : section.contours.ids()) {
      require((*next)->contours[c].vertices == section.contours[c].vertices, "another contour");
    }
  }
  const auto end = sections.next();
  require(end.ok() && !end->has_value(), "a section too many");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  if (const auto raw = parse_cnt(text_of(data, size), "fuzz.cnt", Validity::unchecked);
      raw && raw->stack.vertex_count() < 300) {
    for (const FillRule fill : {FillRule::odd, FillRule::unite, FillRule::winding}) {
      const double width = 0.25 * static_cast<double>(size % 16);
      const auto repaired = repair(
          raw->stack, {.fill = fill, .keyholes = width > 0 ? std::optional(width) : std::nullopt});
      if (!repaired) require_clean(repaired.error());
      require(!repaired || repaired->stack.contour_count() == 0 || validate(repaired->stack).ok(),
              "a repaired stack is not valid");
    }
    const auto arranged = arrange_planes(raw->stack, {PlaneRule::merge, 0.5});
    require(!arranged || arranged->stack.contour_count() == raw->stack.contour_count(),
            "planes lose contours");
    for (const Section& section : raw->stack.sections.raw()) {
      for (const Contour& contour : section.contours.raw()) {
        for (const Point2& p : contour.vertices) {
          require(std::isfinite(p.x) && std::isfinite(p.y), "a coordinate that is not finite");
        }
      }
    }
  }
  const auto read = parse_cnt(text_of(data, size), "fuzz.cnt");
  compare_sections(text_of(data, size), read);
  if (!read) {
    require_clean(read.error());
    require(!read.error().where.file.empty(), "an error without the file's name");
    return 0;
  }
  require(validate(read->stack).ok(), "the reader hands out a stack that is not valid");
  SectionStack mended = read->stack;
  require(mend(mended).empty(), "the reader leaves something to mend");
  for (std::size_t s = 0; s < read->stack.sections.size(); ++s) {
    require(read->lines[SectionId(s)].size() == read->stack.sections[SectionId(s)].contours.size(),
            "lines for each contour");
    const Nesting nesting = nest(read->stack.sections[SectionId(s)]);
    for (const ContourId outer : nesting.outer) {
      require(nesting.depth[outer] % 2 == 0, "an outer contour at an odd depth");
    }
  }
  const auto snapped = snap(read->stack, 20);
  if (!snapped) {
    require_clean(snapped.error());
  } else {
    require(validate(snapped->stack).ok(), "snapping breaks a stack");
  }
  return 0;
}
