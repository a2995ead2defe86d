#include "core/correspondence_options.hpp"

#include "core/enums.hpp"

namespace tetloft {

namespace {

Error refused(const char* why) { return {ErrorCode::usage, why, {}}; }

}  // namespace

bool is_overlap_ratio(double value) { return value >= 0 && value < 1; }

Result<void> check_correspondence_options(const CorrespondenceOptions& options) {
  if (!is_enumerator(options.criterion, Criterion::reverse)) {
    return refused("there is no such criterion of correspondence: overlap or reverse");
  }
  if (!is_overlap_ratio(options.tau)) return refused("the overlap threshold must be in [0, 1)");
  if (!options.drift) return {};
  if (!is_overlap_ratio(*options.drift)) return refused("the drift threshold must be in [0, 1)");
  if (options.criterion != Criterion::overlap) {
    return refused("drift belongs to the overlap criterion");
  }
  return {};
}

}  // namespace tetloft
