#include "core/option_rules.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "core/enums.hpp"

namespace tetloft::internal {

namespace {

Error refused(std::string why) { return {ErrorCode::usage, std::move(why), {}}; }

Result<void> check_void_options(const VoidOptions& options) {
  if (!is_enumerator(options.rule, VoidRule::free)) {
    return refused("there is no such rule of voids: overlap, near or free");
  }
  if (!is_void_reach(options.reach)) {
    return refused("the reach of voids must be finite and not negative");
  }
  if (options.rule == VoidRule::free && !(options.labels.empty() && options.decisions.empty())) {
    return refused("voids are free: labels and decisions about them would do nothing");
  }
  return {};
}

}  // namespace

bool is_overlap_ratio(double value) { return value >= 0 && value < 1; }

bool is_void_reach(double value) { return value >= 0 && std::isfinite(value); }

bool is_work_limit(double value) { return value > 0; }

bool is_length(double value) { return value > 0 && std::isfinite(value); }

Result<void> check_work_limit(double value) {
  if (!is_work_limit(value)) return refused("the work limit must be positive");
  return {};
}

Result<void> check_between(std::size_t count) {
  if (count > kMostBetween) {
    return refused("no more than " + std::to_string(kMostBetween) +
                   " sections can be put between two");
  }
  return {};
}

Result<void> check_length(double value, const char* what) {
  if (!is_length(value)) return refused(std::string(what) + " must be positive and finite");
  return {};
}

Result<void> check_correspondence_options(const CorrespondenceOptions& options) {
  if (!is_enumerator(options.criterion, Criterion::moved)) {
    return refused("there is no such criterion of correspondence: overlap, reverse or moved");
  }
  if (!is_overlap_ratio(threshold_of(options))) {
    return refused("the overlap threshold must be in [0, 1)");
  }
  return check_void_options(options.voids);
}

}  // namespace tetloft::internal
