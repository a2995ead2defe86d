// Components of a model: their names, and each as a model of its own.
#include <string>
#include <vector>

#include <tetloft/model.hpp>

#include "core/entry.hpp"
#include "model/fields.hpp"
#include "model/well_formed.hpp"

namespace tetloft {

using namespace internal;

namespace {

// Old ids by new ones.
struct ComponentParts {
  std::vector<TetId> tets;
  std::vector<VertexId> points;
};

ComponentParts parts_of(const Model& model, ComponentId component) {
  ComponentParts parts;
  IdVector<VertexId, std::uint8_t> used(model.points.size());
  for (const TetId t : model.tets.ids()) {
    if (model.component[t] != component) continue;
    parts.tets.push_back(t);
    for (const VertexId v : model.tets[t]) used[v] = 1;
  }
  for (const VertexId v : used.ids()) {
    if (used[v] != 0) parts.points.push_back(v);
  }
  return parts;
}

}  // namespace

std::string component_name(const Model& model, ComponentId component) {
  const auto& names = model.component_names;
  if (component.index() < names.size() && !names[component].empty()) return names[component];
  const std::string& of_all = model.about.name;
  if (model.component_count == 1 && !of_all.empty()) return of_all;
  return (of_all.empty() ? "component" : of_all) + ' ' + std::to_string(component.index() + 1);
}

Model component_of(const Model& model, ComponentId component) {
  require_fit(check_well_formed(model).ok(), "component_of: the model is not well formed");
  require_fit(component.index() < model.component_count && !model.component.empty(),
              "component_of: the model has no such component");
  const ComponentParts parts = parts_of(model, component);
  Model part;
  IdVector<VertexId, VertexId> renamed(model.points.size());
  for (const VertexId v : parts.points) {
    renamed[v] = VertexId(part.points.size());
    part.points.push_back(model.points[v]);
  }
  for (const TetId t : parts.tets) {
    TetVertices tet = model.tets[t];
    for (VertexId& v : tet) v = renamed[v];
    part.tets.push_back(tet);
  }
  for_each_field([&](const auto& field) {
    const auto& from = model.*field.values;
    if (from.empty()) return;
    auto& to = part.*field.values;
    if constexpr (std::remove_cvref_t<decltype(field)>::kOfPoints) {
      for (const VertexId v : parts.points) to.push_back(from[v]);
    } else {
      for (const TetId t : parts.tets) to.push_back(from[t]);
    }
  });
  for (ComponentId& c : part.component) c = ComponentId(0);
  part.component_count = 1;
  part.frame = model.frame;
  part.about = model.about;
  part.about.name = component_name(model, component);
  return part;
}

bool components_touch(const Model& model) {
  if (model.component.empty()) return false;
  IdVector<VertexId, ComponentId> of_point(model.points.size());
  for (const TetId t : model.tets.ids()) {
    for (const VertexId v : model.tets[t]) {
      ComponentId& component = of_point[v];
      if (component.valid() && component != model.component[t]) return true;
      component = model.component[t];
    }
  }
  return false;
}

}  // namespace tetloft
