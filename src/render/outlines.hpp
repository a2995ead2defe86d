// The contours of a subject: those of a stack, or the outlines of the model in its sections.
#pragma once

#include <tetloft/model.hpp>
#include <tetloft/section_stack.hpp>

#include "render/subject.hpp"

namespace tetloft::internal::render {

/// Adds sections and contours to a subject that has its points, tets and slabs. `given`: null for
/// the model's own outlines, none where it does not tell the sections of its points.
void add_contours(const Model& model, const SectionStack* given, double stretch, Subject& subject);

}  // namespace tetloft::internal::render
