#include "core/option_rules.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "core/enums.hpp"

namespace tetloft::internal {

namespace {

Error refused(std::string why) { return {ErrorCode::usage, std::move(why), {}}; }

}  // namespace

bool is_overlap_ratio(double value) { return value >= 0 && value < 1; }

bool is_work_limit(double value) { return value > 0; }

bool is_length(double value) { return value > 0 && std::isfinite(value); }

Result<void> check_work_limit(double value) {
  if (!is_work_limit(value)) return refused("the work limit must be positive");
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
  return {};
}

}  // namespace tetloft::internal
