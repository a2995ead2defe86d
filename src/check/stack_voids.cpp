#include "check/stack_voids.hpp"

#include "core/unit_of_length.hpp"
#include "sections/complement.hpp"
#include "sections/scaling.hpp"

namespace tetloft::internal::checking {

namespace {

SectionStack with_squares(SectionStack stack) {
  const double a = sections::far_outside(stack);
  for (Section& section : stack.sections) {
    section.contours.push_back({{{-a, -a}, {a, -a}, {a, a}, {-a, a}}});
  }
  return stack;
}

}  // namespace

StackVoids::StackVoids(const SectionStack& given)
    : stack_(sections::scaled(given, sections::unit_of(given).exponent())),
      complement_(with_squares(stack_)),
      regions_(number_regions(stack_)),
      voids_(number_regions(complement_)) {}

std::vector<Faces> StackVoids::faces() const {
  std::vector<Faces> faces;
  for (std::size_t s = 0; s + 1 < section_count(); ++s) {
    const sections::FaceOverlay overlay(stack_.sections[SectionId(s)], regions_.nesting[s],
                                        stack_.sections[SectionId(s + 1)], regions_.nesting[s + 1]);
    faces.push_back({overlay.faces(), overlay.meetings(), overlay.touching_voids()});
  }
  return faces;
}

ContourId StackVoids::hole(std::size_t of_void) const {
  const std::size_t s = voids_.section[of_void];
  return voids_.nesting[s].outer[RegionId(of_void - voids_.first[s])];
}

std::size_t StackVoids::region_around(std::size_t of_void) const {
  return regions_.of(voids_.section[of_void], hole(of_void).index());
}

std::optional<std::size_t> StackVoids::find_void(std::size_t s, ContourId name) const {
  if (!name.valid()) return voids_.first[s];
  // The square, which is no contour of the section, comes last.
  if (name.index() >= regions_.nesting[s].region.size()) return std::nullopt;
  if (!voids_.is_outer(s, name.index())) return std::nullopt;
  return voids_.of(s, name.index());
}

}  // namespace tetloft::internal::checking
