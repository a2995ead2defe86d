// Stacks: made, read, written.
#include <tetloft/formats.hpp>
#include <tetloft/section_stack.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

// The sum of counts, which must be `told`. Read one by one: a sum that does not fit is none.
void require_sum(const std::size_t* counts, std::size_t n, std::size_t told, const char* name,
                 const char* of) {
  require_array(counts, n, sizeof(std::size_t), name);
  std::size_t left = told;
  for (std::size_t i = 0; i < n; ++i) {
    if (counts[i] > left) {
      fail_usage(std::string(name) + " are more than the " + std::to_string(told) + ' ' + of);
    }
    left -= counts[i];
  }
  if (left != 0) {
    fail_usage(std::string(name) + " are fewer than the " + std::to_string(told) + ' ' + of);
  }
}

tetloft_stack_options default_stack_options() {
  tetloft_stack_options options{};
  options.version = TETLOFT_STACK_OPTIONS_VERSION;
  return options;
}

ReadOptions stack_options_of(const tetloft_stack_options* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_STACK_OPTIONS_VERSION, "stack options");
  ReadOptions result;
  result.validity = options->unchecked != 0 ? Validity::unchecked : Validity::required;
  if (options->format != nullptr) result.format = options->format;
  if (options->structure != nullptr) result.structure = options->structure;
  if (options->property != nullptr) result.property = options->property;
  if (options->has_iso != 0) result.iso = options->iso;
  if (options->lattice != 0) result.contours = VolumeContours::lattice;
  if (options->axis != 0) result.axis = options->axis - 1;
  if (options->plane_tolerance != 0) result.plane_tolerance = options->plane_tolerance;
  result.close_on_frame = options->close_on_frame != 0;
  result.execution = execution_of(options->execution);
  return result;
}

// All of what is wanted, or nothing.
void hand_out_read(ReadStack read, tetloft_stack** stack, tetloft_labels** labels,
                   tetloft_warnings** warnings) {
  NewHandle<tetloft_stack> made(std::move(read.stack));
  if (labels == nullptr) {
    hand_out_warnings(warnings, read.warnings);
  } else {
    hand_out(labels, std::move(read.labels), warnings, read.warnings);
  }
  made.give(stack);
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_stack_create(const double* z, const size_t* contour_counts,
                                    size_t section_count, const size_t* vertex_counts,
                                    size_t contour_count, const double* xy, size_t vertex_count,
                                    tetloft_stack** stack) {
  clear(stack);
  return answer([&] {
    require_output(stack, "stack");
    require_array(z, section_count, sizeof(double), "z");
    require_countable(section_count);
    require_countable(contour_count);
    require_sum(contour_counts, section_count, contour_count, "contour_counts", "contours");
    require_sum(vertex_counts, contour_count, vertex_count, "vertex_counts", "vertices");
    const std::vector<tetloft::Point2> points = plane_points(xy, vertex_count);
    tetloft::SectionStack made;
    made.sections.resize(section_count);
    const size_t* vertices = vertex_counts;
    auto next = points.begin();
    for (size_t s = 0; s < section_count; ++s) {
      tetloft::Section& section = made.sections.raw()[s];
      section.z = z[s];
      section.contours.resize(contour_counts[s]);
      for (tetloft::Contour& contour : section.contours) {
        const auto end = next + static_cast<std::ptrdiff_t>(*vertices++);
        contour.vertices.assign(next, end);
        next = end;
      }
    }
    hand_out(stack, std::move(made));
  });
}

tetloft_status tetloft_stack_read(const char* path, const tetloft_read_options* options,
                                  tetloft_stack** stack, tetloft_warnings** warnings) {
  clear(stack);
  clear(warnings);
  return answer([&] {
    require_output(stack, "stack");
    tetloft::ReadStack read =
        value_of(tetloft::read_stack(text_of(path, "path"), read_options_of(options)));
    hand_out(stack, std::move(read.stack), warnings, read.warnings);
  });
}

tetloft_status tetloft_stack_parse(const void* data, size_t size, const char* name,
                                   const tetloft_read_options* options, tetloft_stack** stack,
                                   tetloft_warnings** warnings) {
  clear(stack);
  clear(warnings);
  return answer([&] {
    require_output(stack, "stack");
    tetloft::ReadStack read = value_of(tetloft::parse_stack(
        bytes_of(data, size), text_of(name, "name"), read_options_of(options)));
    hand_out(stack, std::move(read.stack), warnings, read.warnings);
  });
}

tetloft_status tetloft_stack_options_defaults(tetloft_stack_options* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_stack_options();
  });
}

tetloft_status tetloft_stack_read_by(const char* path, const tetloft_stack_options* options,
                                     tetloft_stack** stack, tetloft_labels** labels,
                                     tetloft_warnings** warnings) {
  clear(stack);
  clear(labels);
  clear(warnings);
  return answer([&] {
    require_output(stack, "stack");
    hand_out_read(value_of(tetloft::read_stack(text_of(path, "path"), stack_options_of(options))),
                  stack, labels, warnings);
  });
}

tetloft_status tetloft_stack_parse_by(const void* data, size_t size, const char* name,
                                      const tetloft_stack_options* options, tetloft_stack** stack,
                                      tetloft_labels** labels, tetloft_warnings** warnings) {
  clear(stack);
  clear(labels);
  clear(warnings);
  return answer([&] {
    require_output(stack, "stack");
    hand_out_read(value_of(tetloft::parse_stack(bytes_of(data, size), text_of(name, "name"),
                                                stack_options_of(options))),
                  stack, labels, warnings);
  });
}

tetloft_status tetloft_stack_write(const tetloft_stack* stack, const char* path,
                                   const tetloft_write_options* options,
                                   tetloft_warnings** warnings) {
  clear(warnings);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    hand_out_warnings(warnings, value_of(tetloft::write_stack(text_of(path, "path"), *value,
                                                              write_options_of(options))));
  });
}

tetloft_status tetloft_stack_format(const tetloft_stack* stack,
                                    const tetloft_write_options* options, tetloft_bytes** bytes,
                                    tetloft_warnings** warnings) {
  clear(bytes);
  clear(warnings);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(bytes, "bytes");
    tetloft::Formatted made = value_of(tetloft::format_stack(*value, write_options_of(options)));
    hand_out(bytes, std::move(made.bytes), warnings, made.warnings);
  });
}

tetloft_status tetloft_stack_free(tetloft_stack* stack) { return free_handle(stack); }
