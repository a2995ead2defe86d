#include "reconstruct/component_names.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace tetloft::internal {

IdVector<ComponentId, std::string> names_by_labels(const ContourPartition& partition,
                                                   std::size_t components,
                                                   const std::vector<Label>& labels) {
  if (labels.empty()) return {};
  IdVector<ComponentId, std::optional<std::uint32_t>> least(components);
  for (const Label& label : labels) {
    std::optional<std::uint32_t>& known = least[partition[label.section][label.contour]];
    known = std::min(known.value_or(label.label), label.label);
  }
  IdVector<ComponentId, std::string> names;
  for (const auto& label : least) {
    names.push_back(label ? "label " + std::to_string(*label) : std::string());
  }
  return names;
}

}  // namespace tetloft::internal
