#include "report/subject.hpp"

#include <algorithm>

#include "core/sort_distinct.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::report {

namespace {

// Of a sound model all vertices of a section lie in its plane; one that is not has more planes.
std::vector<double> planes_of(const Model& model, const SectionStack* stack) {
  std::vector<double> planes;
  if (stack != nullptr) {
    for (const Section& section : stack->sections) planes.push_back(section.z);
    return planes;
  }
  for (std::size_t v = 0; v < model.section.size(); ++v) {
    if (model.section[VertexId(v)].valid()) planes.push_back(model.points[VertexId(v)].z);
  }
  sort_distinct(planes);
  return planes;
}

Description description_of(const Model& model, const SectionStack* stack) {
  Description about = model.about;
  if (stack == nullptr) return about;
  if (about.name.empty()) about.name = stack->about.name;
  if (about.unit.empty()) about.unit = stack->about.unit;
  if (about.orientation.empty()) about.orientation = stack->about.orientation;
  return about;
}

SectionStack bare_stack(const std::vector<double>& planes) {
  SectionStack stack;
  for (const double z : planes) stack.sections.push_back({z, {}});
  return stack;
}

// view.boundary holds faces in the order of half-faces.
std::vector<std::uint32_t> tets_behind(const checking::ModelView& view) {
  std::vector<std::uint32_t> behind;
  behind.reserve(view.boundary.size());
  for (std::size_t h = 0; h < view.opposite.size() && behind.size() < view.boundary.size(); ++h) {
    if (view.opposite[h].valid()) continue;
    const TriangleVertices face = face_of(view.tets[h / 4], static_cast<int>(h % 4));
    if (face == view.boundary[behind.size()]) behind.push_back(static_cast<std::uint32_t>(h / 4));
  }
  return behind;
}

// Those that the model tells, where it does for every tet; else what hangs together by faces.
void find_components(Subject& subject) {
  const Model& model = subject.model;
  const checking::ModelView& view = subject.view;
  const auto is_told = [&](const TetId t) {
    return model.component[t].valid() && model.component[t].index() < model.component_count;
  };
  const bool told = model.component.size() == model.tets.size() &&
                    model.component_count <= model.tets.size() &&
                    std::all_of(view.id.begin(), view.id.end(), is_told);
  if (told) {
    for (const TetId t : view.id) subject.component.push_back(model.component[t].value());
    Model named;
    named.about = subject.about;
    named.component_count = model.component_count;
    named.component_names = model.component_names;
    for (std::size_t c = 0; c < model.component_count; ++c) {
      subject.names.push_back(component_name(named, ComponentId(c)));
    }
    return;
  }
  subject.component = view.component;
  for (std::size_t c = 0; c < view.component_count; ++c) {
    subject.names.push_back("part " + std::to_string(c + 1));
  }
}

void find_box(Subject& subject) {
  Box3 box;
  for (std::size_t v = 0; v < subject.view.points.size(); ++v) {
    if (subject.view.used[v] != 0) box.include(subject.view.points[v]);
  }
  subject.low = box.low;
  subject.high = box.high;
}

}  // namespace

Result<Subject> subject_of(const Model& model, const SectionStack* stack) {
  if (Result<void> formed = check_well_formed(model); !formed) return formed.error();
  Subject subject{model, stack};
  subject.about = description_of(model, stack);
  subject.planes = planes_of(model, stack);
  subject.view = checking::look_at(model, stack != nullptr ? *stack : bare_stack(subject.planes));
  if (subject.view.tets.empty()) {
    return Error{ErrorCode::invalid_input, "the model has no tets to report on", {}};
  }
  subject.surface = surface_components(subject.view.boundary);
  subject.behind = tets_behind(subject.view);
  find_components(subject);
  find_box(subject);
  subject.is_rigid = volume_factor(model.frame) == 1;
  return subject;
}

}  // namespace tetloft::internal::report
