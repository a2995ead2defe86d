#include "io/drawing/written_stack.hpp"

#include <string>

namespace tetloft::internal::io {

Result<std::vector<Warning>> check_written(const SectionStack& stack, const Target& target) {
  std::vector<Warning> warnings;
  if (const Result<void> valid = validate(stack, {.threads = 1}); !valid) return valid.error();
  std::size_t empty = 0;
  for (const Section& section : stack.sections) {
    if (section.contours.empty()) ++empty;
  }
  if (empty > 0) {
    Warning warning{std::to_string(empty) + (empty == 1 ? " section" : " sections") +
                        " without contours " + (empty == 1 ? "is" : "are") +
                        " not in the file, which has no place for any: what is read from it may be "
                        "joined across (.cnt keeps them)",
                    {}};
    warning.where.file = target.name;
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

std::vector<Warning> warnings_of_turned(const SectionStack& stack, const Target& target,
                                        std::string_view format) {
  if (stack.frame == Frame()) return {};
  Warning warning{
      "the planes lie in other directions in the file that they came from; written are their own "
      "coordinates, as " +
          std::string(format) + " has no others (.csl and .vtp have)",
      {}};
  warning.where.file = target.name;
  return {std::move(warning)};
}

std::vector<std::vector<ContourId>> rings_by_outer(const Nesting& nesting) {
  std::vector<std::vector<ContourId>> rings;
  IdVector<ContourId, std::size_t> place;
  for (const ContourId c : nesting.depth.ids()) {
    place.push_back(rings.size());
    if (nesting.depth[c] % 2 == 0) rings.push_back({c});
  }
  for (const ContourId c : nesting.depth.ids()) {
    if (nesting.depth[c] % 2 == 1) rings[place[nesting.parent[c]]].push_back(c);
  }
  return rings;
}

}  // namespace tetloft::internal::io
