// Stacks: what they hold, contour by contour.
#include "c/sections.hpp"

#include <tetloft/nesting.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"

namespace tetloft::internal::c {

namespace {

const Contour& contour_of(const SectionStack& stack, std::size_t section, std::size_t contour) {
  const Section& found = section_of(stack, section);
  require_index(contour, found.contours.size(), "contour");
  return found.contours.raw()[contour];
}

}  // namespace

const Section& section_of(const SectionStack& stack, std::size_t section) {
  require_index(section, stack.sections.size(), "section");
  return stack.sections.raw()[section];
}

const Section& valid_section_of(const SectionStack& stack, std::size_t section) {
  const Section& found = section_of(stack, section);
  if (found.contours.empty()) return found;
  SectionStack alone;
  alone.sections.push_back(found);
  const Result<void> valid = validate(alone, {.threads = 1});
  if (!valid) {
    Error error = valid.error();
    if (error.where.section) error.where.section = section;
    throw Failed(error);
  }
  return found;
}

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_stack_counts(const tetloft_stack* stack, size_t* sections, size_t* contours,
                                    size_t* vertices) {
  clear(sections, contours, vertices);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    put(sections, value->sections.size());
    put(contours, value->contour_count());
    put(vertices, value->vertex_count());
  });
}

tetloft_status tetloft_stack_section(const tetloft_stack* stack, size_t section, double* z,
                                     size_t* contours) {
  clear(z);
  clear(contours);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    const tetloft::Section& found = section_of(*value, section);
    put(z, found.z);
    put(contours, found.contours.size());
  });
}

tetloft_status tetloft_stack_contour(const tetloft_stack* stack, size_t section, size_t contour,
                                     const double** xy, size_t* vertices) {
  clear(xy);
  clear(vertices);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    put_array(contour_of(*value, section, contour).vertices, xy, vertices);
  });
}

tetloft_status tetloft_stack_twice_area(const tetloft_stack* stack, size_t section, size_t contour,
                                        double* twice_area) {
  clear(twice_area);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(twice_area, "twice_area");
    *twice_area = tetloft::twice_area(contour_of(*value, section, contour));
  });
}

tetloft_status tetloft_stack_nesting(const tetloft_stack* stack, size_t section, uint32_t* parent,
                                     uint32_t* depth, uint32_t* region, size_t capacity,
                                     size_t* contours, size_t* regions) {
  clear(contours);
  clear(regions);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    const size_t count = section_of(*value, section).contours.size();
    const tetloft::Nesting nesting = tetloft::nest(valid_section_of(*value, section));
    put(contours, count);
    put(regions, nesting.outer.size());
    if (parent == nullptr && depth == nullptr && region == nullptr) return;
    require_room(capacity, count, "of contours");
    if (parent != nullptr) std::copy_n(numbers_of(nesting.parent.raw()), count, parent);
    if (depth != nullptr) std::copy_n(nesting.depth.begin(), count, depth);
    if (region != nullptr) std::copy_n(numbers_of(nesting.region.raw()), count, region);
  });
}
