// What making a model took, in sum over what it was made of; and what it is.
#pragma once

#include <tetloft/report.hpp>

#include "reconstruct/phases.hpp"

namespace tetloft::internal {

/// Of the parts of a stack or window, refinements and divisions, and the triangles that slabs
/// share; of a window those of its first section, not of its last. To be asked while there are
/// parts.
[[nodiscard]] ReconstructReport report_of_parts(const BuiltStack& built);

/// Adds what report_of_parts() tells.
void add_up(const ReconstructReport& part, ReconstructReport& sum);

/// What is told of the model of a whole stack.
void describe(const Model& model, unsigned threads, ReconstructReport& report);

}  // namespace tetloft::internal
