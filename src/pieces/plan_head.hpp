// What a plan says of the whole stack: the first record of its file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tetloft/pieces.hpp>
#include <tetloft/reconstruct.hpp>

#include "reconstruct/window.hpp"

namespace tetloft::internal::pieces {

inline constexpr std::uint32_t kPlanVersion = 2;

struct PlanHead {
  StackFacts facts;
  /// As they were given; what is decided by them, labels and decisions, is in the plan.
  ReconstructOptions options;
  PlanSource source;
  std::size_t contours = 0;
  std::size_t vertices = 0;
  std::size_t cavities = 0;
  double lowest = 0, highest = 0;  ///< z, in the unit given
  Frame frame;
  Description about;
  IdVector<ComponentId, std::string> component_names;
};

[[nodiscard]] std::string to_record(const PlanHead& head);
/// Whether a file that begins so is a plan.
[[nodiscard]] bool begins_as_plan(std::string_view bytes);
/// What was written. Refused (invalid_input; `name` stands for the file) as records are, and where
/// options are none.
[[nodiscard]] Result<PlanHead> plan_head_from_record(std::string_view bytes,
                                                     const std::string& name);

}  // namespace tetloft::internal::pieces
