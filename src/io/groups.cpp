#include "io/groups.hpp"

#include <algorithm>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/text.hpp"

namespace tetloft::internal::io {

ComponentId component_at(const Model& model, TetId tet) {
  return model.component.empty() ? ComponentId(0) : model.component[tet];
}

std::string group_name(const Model& model, ComponentId component) {
  return component.valid() ? component_name(model, component) : "no component";
}

std::vector<ComponentGroup> component_groups(const Model& model) {
  // An invalid id is the largest.
  std::map<ComponentId, std::size_t> number;
  for (const TetId tet : model.tets.ids()) number.emplace(component_at(model, tet), 0);
  std::vector<ComponentGroup> groups;
  for (auto& [component, place] : number) {
    place = groups.size();
    groups.push_back({component, group_name(model, component), {}, {}});
  }
  const auto group = [&](TetId tet) -> ComponentGroup& {
    return groups[number.find(component_at(model, tet))->second];
  };
  for (const TetId tet : model.tets.ids()) group(tet).tets.push_back(tet);
  const Surface surface = boundary_surface(model);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    group(surface.tet[i]).triangles.push_back(surface.triangles[i]);
  }
  return groups;
}

void count_components(Model& model) {
  model.component_count = 0;
  for (const ComponentId component : model.component) {
    if (!component.valid()) continue;
    model.component_count = std::max(model.component_count, component.index() + 1);
  }
}

void turn_positive(Model& model, WarningList& warnings) {
  std::size_t turned = 0;
  std::size_t flat = 0;
  for (TetVertices& tet : model.tets) {
    const Sign sign = orient3d(model.points[tet[0]], model.points[tet[1]], model.points[tet[2]],
                               model.points[tet[3]]);
    if (sign == Sign::negative) std::swap(tet[2], tet[3]);
    turned += sign == Sign::negative ? 1U : 0U;
    flat += sign == Sign::zero ? 1U : 0U;
  }
  const auto tell = [&](std::size_t count, const char* one, const char* several) {
    if (count != 0) warnings.add(std::to_string(count) + (count == 1 ? one : several));
  };
  tell(turned, " tet is negative: it is turned over", " tets are negative: they are turned over");
  tell(flat, " tet has no volume", " tets have no volume");
}

Model GroupedSolid::take(IdVector<VertexId, Point3> points,
                         const std::map<std::int64_t, std::string>& names, WarningList& warnings) {
  Model model;
  model.points = std::move(points);
  model.tets = std::move(tets_);
  turn_positive(model, warnings);

  std::map<std::int64_t, ComponentId> component;
  for (const std::int64_t group : groups_) component.emplace(group, ComponentId());
  component.erase(kNoGroup);
  if (component.empty()) return model;
  for (auto& [group, id] : component) id = ComponentId(model.component_count++);
  model.component.reserve(groups_.size());
  for (const std::int64_t group : groups_) {
    const auto found = component.find(group);
    model.component.push_back(found == component.end() ? ComponentId() : found->second);
  }
  groups_ = {};
  IdVector<ComponentId, std::string> of_components(model.component_count);
  bool any = false;
  for (const auto& [group, id] : component) {
    const auto name = names.find(group);
    if (name == names.end()) continue;
    of_components[id] = valid_utf8(name->second);
    any = any || !of_components[id].empty();
  }
  if (any) model.component_names = std::move(of_components);
  return model;
}

}  // namespace tetloft::internal::io
