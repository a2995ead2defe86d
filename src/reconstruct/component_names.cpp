#include "reconstruct/component_names.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace tetloft::internal {

namespace {

using ContourKey = std::pair<SectionId, ContourId>;

std::map<ContourKey, std::uint32_t> by_contour(const std::vector<Label>& labels) {
  std::map<ContourKey, std::uint32_t> found;
  for (const Label& label : labels) {
    found.emplace(ContourKey{label.section, label.contour}, label.label);
  }
  return found;
}

}  // namespace

IdVector<ComponentId, std::string> names_by_labels(const Model& model,
                                                   const std::vector<Label>& labels) {
  if (labels.empty() || model.component.empty() || model.contour.empty()) return {};
  const std::map<ContourKey, std::uint32_t> label_of = by_contour(labels);
  IdVector<ComponentId, std::optional<std::uint32_t>> least(model.component_count);
  for (const TetId t : model.tets.ids()) {
    std::optional<std::uint32_t>& label = least[model.component[t]];
    for (const VertexId v : model.tets[t]) {
      if (!model.section[v].valid() || !model.contour[v].valid()) continue;
      const auto found = label_of.find({model.section[v], model.contour[v]});
      if (found == label_of.end()) continue;
      label = std::min(label.value_or(found->second), found->second);
    }
  }
  IdVector<ComponentId, std::string> names;
  for (const auto& label : least) {
    names.push_back(label ? "label " + std::to_string(*label) : std::string());
  }
  return names;
}

}  // namespace tetloft::internal
