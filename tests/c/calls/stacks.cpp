#include <array>

#include "c/calls/calls.hpp"
#include "c/calls/samples.hpp"

namespace tetloft::c_test {

namespace {

using A = Arguments;

std::vector<char> bytes(std::string_view text) { return {text.begin(), text.end()}; }

std::vector<std::size_t> sizes(A& a, std::vector<std::size_t> usual) {
  for (std::size_t& size : usual) {
    size = static_cast<std::size_t>(a.integer(static_cast<std::int64_t>(size)));
  }
  return usual;
}

tetloft_status create_stack(A& a) {
  const auto z = a.array(std::vector<double>{a.real(0), a.real(1)});
  const auto contours = a.array(sizes(a, {1, 1}));
  const auto vertices = a.array(sizes(a, {3, 4}));
  const auto xy = a.array(a.reals({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1}), 2);
  // Two arrays have one size: where only one is wrong it must be found out by the other.
  const std::size_t sections = contours.size == 2 ? z.size : contours.size;
  return tetloft_stack_create(z.data, contours.data, sections, vertices.data, vertices.size,
                              xy.data, xy.size, a.handle_output<tetloft_stack>());
}

tetloft_status create_labels(A& a) {
  const auto id = [&a](std::uint32_t usual) {
    return static_cast<std::uint32_t>(a.integer(usual));
  };
  const std::vector<tetloft_label> one_label{{id(0), id(0), id(1)}};
  const std::vector<tetloft_decision> one_decision{
      {id(0), id(0), id(0), static_cast<std::int32_t>(a.integer(1))}};
  const auto labels = a.array(one_label);
  const auto decisions = a.array(one_decision);
  const auto holes = a.array(one_label);
  const auto voids = a.array(one_decision);
  return tetloft_labels_create(labels.data, labels.size, decisions.data, decisions.size, holes.data,
                               holes.size, voids.data, voids.size,
                               a.handle_output<tetloft_labels>());
}

tetloft_status nesting(A& a) {
  auto* const stack = a.handle<tetloft_stack>();
  const auto section = static_cast<std::size_t>(a.integer(0));
  const auto parent = a.output_array<std::uint32_t>(1, Expected::ok);
  auto* const contours = a.optional_output<std::size_t>();
  return tetloft_stack_nesting(stack, section, parent.data, nullptr, nullptr, parent.size, contours,
                               a.optional_output<std::size_t>());
}

tetloft_status repair_by(A& a) {
  auto* const stack = a.handle<tetloft_stack>();
  tetloft_repair_options options;
  tetloft_repair_options_defaults(&options);
  options.fill = static_cast<std::int32_t>(a.integer(TETLOFT_FILL_UNION));
  options.distance = a.real(-1);
  options.keyholes = a.real(0.01);
  options.execution = execution(a);
  const auto* const given = a.options(options);
  auto* const made = a.handle_output<tetloft_stack>();
  auto* const report = a.result<tetloft_repair_report>(TETLOFT_REPAIR_REPORT_VERSION);
  return tetloft_stack_repair_by(stack, given, made, report,
                                 a.optional_handle_output<tetloft_warnings>());
}

template <class Found>
tetloft_status find_array(A& a, Found found) {
  auto* const links = a.handle<tetloft_links>();
  auto* const array = a.output<const tetloft_link*>();
  return found(links, array, a.output<std::size_t>());
}

const tetloft_stack_options* stack_options(A& a) {
  tetloft_stack_options options;
  tetloft_stack_options_defaults(&options);
  options.unchecked = static_cast<std::int32_t>(a.integer(0));
  options.close_on_frame = static_cast<std::int32_t>(a.integer(0));
  options.execution = execution(a);
  return a.options(options);
}

constexpr auto kCalls = std::to_array<Call>({
    {"tetloft_stack_create", create_stack},
    {"tetloft_stack_read",
     [](A& a) {
       const char* const path = a.file("sample.cnt");
       const auto* const options = read_options(a);
       auto* const stack = a.handle_output<tetloft_stack>();
       return tetloft_stack_read(path, options, stack,
                                 a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_stack_parse",
     [](A& a) {
       const auto data = a.array(bytes(kMendedText));
       const char* const name = a.text("mended.cnt");
       const auto* const options = read_options(a);
       auto* const stack = a.handle_output<tetloft_stack>();
       return tetloft_stack_parse(data.data, data.size, name, options, stack,
                                  a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_stack_options_defaults",
     [](A& a) { return tetloft_stack_options_defaults(a.output<tetloft_stack_options>()); }},
    {"tetloft_stack_read_by",
     [](A& a) {
       const char* const path = a.file("sample.cnt");
       const auto* const options = stack_options(a);
       auto* const stack = a.handle_output<tetloft_stack>();
       auto* const labels = a.optional_handle_output<tetloft_labels>();
       return tetloft_stack_read_by(path, options, stack, labels,
                                    a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_stack_parse_by",
     [](A& a) {
       const auto data = a.array(bytes(kMendedText));
       const char* const name = a.text("mended.cnt");
       const auto* const options = stack_options(a);
       auto* const stack = a.handle_output<tetloft_stack>();
       auto* const labels = a.optional_handle_output<tetloft_labels>();
       return tetloft_stack_parse_by(data.data, data.size, name, options, stack, labels,
                                     a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_stack_write",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const char* const path = a.file("written.cnt");
       const auto* const options = write_options(a, "cnt", Expected::ok);
       return tetloft_stack_write(stack, path, options,
                                  a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_stack_format",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto* const options = write_options(a, "cnt", Expected::usage);
       auto* const made = a.handle_output<tetloft_bytes>();
       return tetloft_stack_format(stack, options, made,
                                   a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_stack_free", [](A& a) { return tetloft_stack_free(a.own_handle<tetloft_stack>()); }},
    {"tetloft_stack_description",
     [](A& a) { return description<tetloft_stack>(a, tetloft_stack_description); }},
    {"tetloft_stack_counts",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       auto* const sections = a.optional_output<std::size_t>();
       auto* const contours = a.optional_output<std::size_t>();
       return tetloft_stack_counts(stack, sections, contours, a.optional_output<std::size_t>());
     }},
    {"tetloft_stack_section",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto section = static_cast<std::size_t>(a.integer(1));
       auto* const z = a.optional_output<double>();
       return tetloft_stack_section(stack, section, z, a.optional_output<std::size_t>());
     }},
    {"tetloft_stack_contour",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto section = static_cast<std::size_t>(a.integer(0));
       const auto contour = static_cast<std::size_t>(a.integer(0));
       auto* const xy = a.output<const double*>();
       return tetloft_stack_contour(stack, section, contour, xy, a.output<std::size_t>());
     }},
    {"tetloft_stack_twice_area",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto section = static_cast<std::size_t>(a.integer(0));
       const auto contour = static_cast<std::size_t>(a.integer(0));
       return tetloft_stack_twice_area(stack, section, contour, a.output<double>());
     }},
    {"tetloft_stack_nesting", nesting},
    {"tetloft_stack_validate",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       return tetloft_stack_validate(stack, execution(a));
     }},
    {"tetloft_stack_repair",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const double distance = a.real(-1);
       const auto* const how = execution(a);
       auto* const made = a.handle_output<tetloft_stack>();
       return tetloft_stack_repair(stack, distance, how, made,
                                   a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_repair_options_defaults",
     [](A& a) { return tetloft_repair_options_defaults(a.output<tetloft_repair_options>()); }},
    {"tetloft_stack_repair_by", repair_by},
    {"tetloft_stack_arrange_planes",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto rule = static_cast<std::int32_t>(a.integer(TETLOFT_PLANES_MERGE));
       const double tolerance = a.real(0.001);
       auto* const made = a.handle_output<tetloft_stack>();
       return tetloft_stack_arrange_planes(stack, rule, tolerance, made,
                                           a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_stack_snap",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const int bits = static_cast<int>(a.integer(20));
       const auto* const how = execution(a);
       return tetloft_stack_snap(stack, bits, how, a.handle_output<tetloft_stack>());
     }},
    {"tetloft_stack_refine",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const double length = a.real(1);
       const auto* const how = execution(a);
       return tetloft_stack_refine(stack, length, how, a.handle_output<tetloft_stack>());
     }},
    {"tetloft_stack_triangulate",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto section = static_cast<std::size_t>(a.integer(0));
       const auto* const how = execution(a);
       return tetloft_stack_triangulate(stack, section, how,
                                        a.handle_output<tetloft_triangulation>());
     }},
    {"tetloft_labels_create", create_labels},
    {"tetloft_labels_read",
     [](A& a) {
       const char* const path = a.file("sample.labels");
       return tetloft_labels_read(path, a.handle_output<tetloft_labels>());
     }},
    {"tetloft_labels_parse",
     [](A& a) {
       const auto data = a.array(bytes(kLabelText));
       const char* const name = a.text("stack.labels");
       return tetloft_labels_parse(data.data, data.size, name, a.handle_output<tetloft_labels>());
     }},
    {"tetloft_labels_write",
     [](A& a) {
       auto* const labels = a.handle<tetloft_labels>();
       return tetloft_labels_write(labels, a.file("written.labels"));
     }},
    {"tetloft_labels_format",
     [](A& a) {
       auto* const labels = a.handle<tetloft_labels>();
       return tetloft_labels_format(labels, a.handle_output<tetloft_bytes>());
     }},
    {"tetloft_labels_free",
     [](A& a) { return tetloft_labels_free(a.own_handle<tetloft_labels>()); }},
    {"tetloft_links_find",
     [](A& a) {
       auto* const stack = a.handle<tetloft_stack>();
       const auto* const options = correspondence(a);
       const auto* const how = execution(a);
       auto* const links = a.handle_output<tetloft_links>();
       return tetloft_links_find(stack, options, how, links,
                                 a.optional_handle_output<tetloft_warnings>());
     }},
    {"tetloft_links_regions", [](A& a) { return find_array(a, tetloft_links_regions); }},
    {"tetloft_links_voids", [](A& a) { return find_array(a, tetloft_links_voids); }},
    {"tetloft_links_counts",
     [](A& a) {
       auto* const links = a.handle<tetloft_links>();
       auto* const components = a.optional_output<std::size_t>();
       return tetloft_links_counts(links, components, a.optional_output<std::size_t>());
     }},
    {"tetloft_links_partition",
     [](A& a) {
       auto* const links = a.handle<tetloft_links>();
       const auto section = static_cast<std::size_t>(a.integer(0));
       auto* const component = a.output<const std::uint32_t*>();
       return tetloft_links_partition(links, section, component, a.output<std::size_t>());
     }},
    {"tetloft_links_free", [](A& a) { return tetloft_links_free(a.own_handle<tetloft_links>()); }},
});

}  // namespace

std::span<const Call> calls_of_stacks() { return kCalls; }

}  // namespace tetloft::c_test
