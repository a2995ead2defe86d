#include "between/layer_labels.hpp"

#include <array>
#include <cstddef>

namespace tetloft::internal::between {

namespace {

// Labels the parts of the samples for which in(place) holds, through these neighbours.
template <class In, std::size_t n>
LayerLabels label_parts(const motion::LatticeWindow& window, const In& in,
                        const std::array<std::array<std::int64_t, 2>, n>& neighbours) {
  const auto nx = static_cast<std::int64_t>(window.nx());
  const auto ny = static_cast<std::int64_t>(window.ny());
  LayerLabels labels;
  labels.node.assign(window.size(), kNoNode);
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t start = 0; start < labels.node.size(); ++start) {
    if (labels.node[start] != kNoNode || !in(start)) continue;
    const auto node = static_cast<std::uint32_t>(labels.size.size());
    labels.size.push_back(0);
    labels.node[start] = node;
    waiting.push_back(start);
    while (!waiting.empty()) {
      const auto at = static_cast<std::int64_t>(waiting.back());
      waiting.pop_back();
      ++labels.size.back();
      for (const auto& [di, dj] : neighbours) {
        const std::int64_t i = at % nx + di;
        const std::int64_t j = at / nx + dj;
        if (i < 0 || i >= nx || j < 0 || j >= ny) continue;
        const auto next = static_cast<std::uint32_t>(j * nx + i);
        if (labels.node[next] != kNoNode || !in(next)) continue;
        labels.node[next] = node;
        waiting.push_back(next);
      }
    }
  }
  return labels;
}

}  // namespace

LayerLabels label_solids(const motion::LatticeWindow& window, const std::vector<double>& value) {
  return label_parts(
      window, [&](std::uint32_t at) { return value[at] < 0; },
      std::array<std::array<std::int64_t, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}});
}

LayerLabels label_voids(const motion::LatticeWindow& window, const std::vector<double>& value) {
  LayerLabels labels = label_parts(
      window, [&](std::uint32_t at) { return !(value[at] < 0); },
      std::array<std::array<std::int64_t, 2>, 8>{
          {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}});
  if (!labels.size.empty()) labels.size[kExterior] = kUnbounded;
  return labels;
}

std::vector<std::vector<std::uint32_t>> samples_by_node(const LayerLabels& labels) {
  std::vector<std::vector<std::uint32_t>> samples(labels.size.size());
  for (std::size_t n = 0; n < samples.size(); ++n) {
    if (labels.size[n] != kUnbounded) samples[n].reserve(labels.size[n]);
  }
  for (std::uint32_t at = 0; at < labels.node.size(); ++at) {
    const std::uint32_t n = labels.node[at];
    if (n != kNoNode && labels.size[n] != kUnbounded) samples[n].push_back(at);
  }
  return samples;
}

}  // namespace tetloft::internal::between
