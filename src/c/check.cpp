// The guarantees, checked.
#include <tetloft/check.hpp>

#include <algorithm>
#include <limits>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

tetloft_check_options default_check_options() {
  const CheckOptions defaults;
  tetloft_check_options options{};
  options.version = TETLOFT_CHECK_OPTIONS_VERSION;
  options.split_ulps = defaults.split_ulps;
  options.places = defaults.places;
  options.recompute_motions = defaults.recompute_motions ? 1 : 0;
  options.strict = defaults.strict ? 1 : 0;
  return options;
}

CheckOptions check_options_of(const tetloft_check_options* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_CHECK_OPTIONS_VERSION, "check options");
  CheckOptions result;
  result.correspondence = correspondence_of(options->correspondence);
  result.split_ulps = options->split_ulps;
  constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max();
  result.places = static_cast<std::size_t>(std::min(options->places, kMost));
  result.recompute_motions = options->recompute_motions != 0;
  result.strict = options->strict != 0;
  result.execution = execution_of(options->execution);
  return result;
}

const GuaranteeVerdict& guarantee_of(const VerdictValue& verdict, int number) {
  for (const GuaranteeVerdict& guarantee : verdict.report.guarantees) {
    if (guarantee.number == number) return guarantee;
  }
  fail_usage("there is no guarantee " + std::to_string(number));
}

const CheckFailure& failure_of(const VerdictValue& verdict, int number, std::size_t failure) {
  const GuaranteeVerdict& guarantee = guarantee_of(verdict, number);
  require_index(failure, guarantee.failures.size(), "failure");
  return guarantee.failures[failure];
}

template <class T>
std::int64_t known_or(const std::optional<T>& value, std::int64_t unknown) {
  return value ? static_cast<std::int64_t>(*value) : unknown;
}

void fill_figures(const CheckReport& report, tetloft_figures& figures) {
  constexpr std::int64_t kNotKnown = std::numeric_limits<std::int64_t>::min();
  figures.components = report.components;
  figures.volume = report.volume;
  figures.overshoot = report.overshoot;
  figures.smallest_dihedral_degrees = report.smallest_dihedral_degrees;
  figures.largest_split_ulps = report.largest_split_ulps;
  figures.inner_vertices = report.inner_vertices;
  figures.dropped_links = report.dropped_links;
  figures.cavities = known_or(report.cavities, -1);
  figures.expected_cavities = known_or(report.expected_cavities, -1);
  figures.least_genus = known_or(report.least_genus, kNotKnown);
  figures.most_genus = known_or(report.most_genus, kNotKnown);
  figures.deviations = report.deviations;
  figures.forced_voids = report.forced_voids;
  figures.unrealisable_voids = report.unrealisable_voids;
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_check_options_defaults(tetloft_check_options* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_check_options();
  });
}

tetloft_status tetloft_check(const tetloft_model* model, const tetloft_stack* stack,
                             const tetloft_check_options* options, tetloft_verdict** verdict) {
  clear(verdict);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    const auto sections = value_of_handle(stack, "stack");
    require_output(verdict, "verdict");
    VerdictValue made;
    made.report = value_of(tetloft::check(value->model, *sections, check_options_of(options)));
    made.genus.assign(made.report.genus.begin(), made.report.genus.end());
    hand_out(verdict, std::move(made));
  });
}

tetloft_status tetloft_verdict_pass(const tetloft_verdict* verdict, int* pass) {
  clear(pass);
  return answer([&] {
    const auto value = value_of_handle(verdict, "verdict");
    require_output(pass, "pass");
    *pass = value->report.pass() ? 1 : 0;
  });
}

tetloft_status tetloft_verdict_guarantee(const tetloft_verdict* verdict, int number,
                                         const char** name, int* pass, const char** not_asked,
                                         size_t* failures) {
  clear(name, not_asked);
  clear(pass);
  clear(failures);
  return answer([&] {
    const auto value = value_of_handle(verdict, "verdict");
    const tetloft::GuaranteeVerdict& guarantee = guarantee_of(*value, number);
    put(name, guarantee.name.c_str());
    put(pass, guarantee.pass ? 1 : 0);
    put(not_asked, guarantee.not_asked.c_str());
    put(failures, guarantee.failures.size());
  });
}

tetloft_status tetloft_verdict_failure(const tetloft_verdict* verdict, int number, size_t failure,
                                       const char** what, size_t* count, size_t* places) {
  clear(what);
  clear(count, places);
  return answer([&] {
    const auto value = value_of_handle(verdict, "verdict");
    const tetloft::CheckFailure& found = failure_of(*value, number, failure);
    put(what, found.what.c_str());
    put(count, found.count);
    put(places, found.places.size());
  });
}

tetloft_status tetloft_verdict_place(const tetloft_verdict* verdict, int number, size_t failure,
                                     size_t place, const char** text) {
  clear(text);
  return answer([&] {
    const auto value = value_of_handle(verdict, "verdict");
    const tetloft::CheckFailure& found = failure_of(*value, number, failure);
    require_output(text, "text");
    require_index(place, found.places.size(), "place");
    *text = found.places[place].c_str();
  });
}

tetloft_status tetloft_verdict_figures(const tetloft_verdict* verdict, tetloft_figures* figures) {
  return answer([&] {
    require_result(figures, TETLOFT_FIGURES_VERSION, "figures");
    fill_figures(value_of_handle(verdict, "verdict")->report, *figures);
  });
}

tetloft_status tetloft_verdict_genus(const tetloft_verdict* verdict, const int64_t** genus,
                                     size_t* count) {
  clear(genus);
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(verdict, "verdict");
    put_array(value->genus, genus, count);
  });
}

tetloft_status tetloft_verdict_free(tetloft_verdict* verdict) { return free_handle(verdict); }
