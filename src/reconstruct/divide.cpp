#include "reconstruct/divide.hpp"

#include <cstddef>
#include <utility>

#include "core/guard.hpp"
#include "sections/coarse_edges.hpp"

namespace tetloft::internal {

namespace {

// In one section. Hundreds of coarse contours around each other have tets as the product of what
// is inserted into two sections; such a stack is none that someone drew.
constexpr std::size_t kMostInserted = 4096;

}  // namespace

bool divides_coarse(const ReconstructOptions& options) {
  return options.divide_coarse && options.correspondence.criterion != Criterion::reverse;
}

SectionDivision divide_section(const Section& section, std::span<const Section* const> neighbours,
                               double least_long) {
  SectionDivision result;
  std::vector<EdgeDivision> edges = sections::divide_coarse_edges(section, neighbours, least_long);
  if (edges.empty()) return result;
  std::size_t inserted = 0;
  for (const EdgeDivision& edge : edges) inserted += edge.parts - 1;
  if (inserted > kMostInserted) {
    result.refused = "it would take " + std::to_string(inserted) + " vertices";
    return result;
  }
  SectionStack alone;
  alone.sections.push_back(sections::divided(section, edges));
  if (const Result<void> valid = validate(alone, {.threads = 1}); !accepted(valid)) {
    result.refused = "rounding leaves no room: " + valid.error().message;
    return result;
  }
  result.edges = std::move(edges);
  return result;
}

Warning not_divided(SectionId s, const std::string& reason) {
  Place place;
  place.section = s.index();
  return {
      "its contours have few vertices and are taken as they are, since dividing their long edges "
      "fails: " +
          reason,
      place};
}

}  // namespace tetloft::internal
