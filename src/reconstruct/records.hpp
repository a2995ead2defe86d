// A plan and the solid of a slab as bytes: with those of conforming sections
// (sections/section_record.hpp) all that passes between the phases, so that slabs can be built on
// other machines, kept, and glued later.
#pragma once

#include <string>
#include <string_view>

#include "reconstruct/plan.hpp"
#include "reconstruct/slab_solid.hpp"

namespace tetloft::internal {

[[nodiscard]] std::string to_record(const Plan& plan);

/// The plan written by to_record(). Refused (invalid_input; `name` stands for the file) where the
/// bytes are no such record, or its parts do not fit together.
[[nodiscard]] Result<Plan> plan_from_record(std::string_view bytes, const std::string& name);

[[nodiscard]] std::string to_record(const SlabSolid& solid);

/// The solid written by to_record(), the same in every bit. Refused as above; that its tets are
/// positive and embedded is the writer's.
[[nodiscard]] Result<SlabSolid> solid_from_record(std::string_view bytes, const std::string& name);

}  // namespace tetloft::internal
