// Parts are found by runs of samples along rows, not by samples.
#include "between/layer_labels.hpp"

#include <algorithm>
#include <cstddef>

#include "core/union_find.hpp"

namespace tetloft::internal::between {

namespace {

// Samples of one part side by side in a row.
struct Run {
  std::uint32_t first, end;  // places
};

// The runs of the samples for which in(value) holds, row by row; by row the number of its first.
struct Runs {
  std::vector<Run> all;
  std::vector<std::size_t> row;

  template <class In>
  Runs(const motion::LatticeWindow& window, const std::vector<double>& value, const In& in) {
    const auto nx = static_cast<std::uint32_t>(window.nx());
    const auto size = static_cast<std::uint32_t>(window.size());
    for (std::uint32_t begin = 0; begin < size; begin += nx) {
      row.push_back(all.size());
      const std::uint32_t end = begin + nx;
      for (std::uint32_t at = begin; at < end;) {
        while (at < end && !in(value[at])) ++at;
        if (at == end) break;
        const std::uint32_t first = at;
        while (at < end && in(value[at])) ++at;
        all.push_back({first, at});
      }
    }
    row.push_back(all.size());
  }
};

// Calls visit(run, run) for the runs of neighbouring rows that touch, or do so if each ends `aside`
// samples later on either side.
template <class Visit>
void visit_touching(const Runs& runs, std::size_t nx, std::uint32_t aside, const Visit& visit) {
  for (std::size_t j = 0; j + 2 < runs.row.size(); ++j) {
    std::size_t low = runs.row[j];
    std::size_t high = runs.row[j + 1];
    while (low < runs.row[j + 1] && high < runs.row[j + 2]) {
      const Run& below = runs.all[low];
      const Run& above = runs.all[high];
      const auto up = static_cast<std::uint32_t>(nx);
      if (below.first + up < above.end + aside && above.first < below.end + up + aside) {
        visit(low, high);
      }
      (below.end + up < above.end ? low : high) += 1;
    }
  }
}

// Labels the parts of the samples for which in(value) holds; those across are neighbours if
// `aside` is 1.
template <class In>
LayerLabels label_parts(const motion::LatticeWindow& window, const std::vector<double>& value,
                        std::uint32_t aside, const In& in) {
  const Runs runs(window, value, in);
  UnionFind parts(runs.all.size());
  LayerLabels labels;
  // In each part runs that touch are one more than a tree has for each void that they enclose.
  visit_touching(runs, window.nx(), aside, [&](std::size_t low, std::size_t high) {
    if (!parts.unite(low, high)) ++labels.enclosed;
  });
  labels.node.assign(window.size(), kNoNode);
  std::vector<std::uint32_t> node_of(runs.all.size());
  for (std::size_t r = 0; r < runs.all.size(); ++r) {
    const std::size_t leader = parts.find(r);
    if (leader == r) {
      node_of[r] = static_cast<std::uint32_t>(labels.size.size());
      labels.size.push_back(0);
    }
    const std::uint32_t node = node_of[r] = node_of[leader];
    const auto [first, end] = runs.all[r];
    std::fill(labels.node.begin() + first, labels.node.begin() + end, node);
    labels.size[node] += end - first;
  }
  return labels;
}

}  // namespace

LayerLabels label_solids(const motion::LatticeWindow& window, const std::vector<double>& value) {
  return label_parts(window, value, 0, [](double v) { return v < 0; });
}

LayerLabels label_voids(const motion::LatticeWindow& window, const std::vector<double>& value) {
  LayerLabels labels = label_parts(window, value, 1, [](double v) { return !(v < 0); });
  labels.enclosed = 0;
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
