// Parts are found by runs of samples along rows, not by samples.
#include "between/layer_labels.hpp"

#include <algorithm>
#include <cstddef>

#include "between/inside_runs.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::between {

namespace {

using Runs = std::vector<LabelledRun>;

// Calls visit(run, run) for the runs of neighbouring rows of nx samples that touch, or would if one
// ended `aside` samples later on either side.
template <class Visit>
void visit_touching(const Runs& runs, std::uint32_t nx, std::uint32_t aside, const Visit& visit) {
  std::size_t low = 0;
  for (std::size_t high = 0; high < runs.size(); ++high) {
    const std::uint32_t first = runs[high].first;
    const std::uint32_t end = runs[high].end;
    const std::uint32_t row = first - first % nx;
    if (row == 0) continue;
    // Of the row below; those that end before this run do so before all that follow.
    while (low < high && (runs[low].end + nx + aside <= first || runs[low].end + nx <= row)) ++low;
    for (std::size_t k = low; k < high && runs[k].first + nx < end + aside; ++k) {
      if (runs[k].first + nx >= row + nx) break;
      visit(k, high);
    }
  }
}

// Labels the parts of the negative samples, or of the others; those across are neighbours if
// `aside` is 1.
LayerLabels label_parts(const motion::LatticeWindow& window, const std::vector<double>& value,
                        bool negative, std::uint32_t aside) {
  const auto nx = static_cast<std::uint32_t>(window.nx());
  LayerLabels labels;
  visit_sign_runs(window, value, negative, [&](std::uint32_t first, std::uint32_t end) {
    labels.runs.push_back({first, end, kNoNode});
  });
  UnionFind parts(labels.runs.size());
  // In each part runs that touch are one more than a tree has for each void that they enclose.
  visit_touching(labels.runs, nx, aside, [&](std::size_t low, std::size_t high) {
    if (!parts.unite(low, high)) ++labels.enclosed;
  });
  for (std::size_t r = 0; r < labels.runs.size(); ++r) {
    const std::size_t leader = parts.find(r);
    LabelledRun& run = labels.runs[r];
    if (leader == r) {
      run.node = static_cast<std::uint32_t>(labels.size.size());
      labels.size.push_back(0);
    } else {
      run.node = labels.runs[leader].node;
    }
    labels.size[run.node] += run.end - run.first;
  }
  return labels;
}

}  // namespace

std::uint32_t LayerLabels::node_at(std::uint32_t place) const {
  const auto after =
      std::upper_bound(runs.begin(), runs.end(), place,
                       [](std::uint32_t at, const LabelledRun& run) { return at < run.first; });
  if (after == runs.begin() || (after - 1)->end <= place) return kNoNode;
  return (after - 1)->node;
}

std::vector<std::uint32_t> LayerLabels::nodes(std::size_t places) const {
  std::vector<std::uint32_t> node(places, kNoNode);
  for (const LabelledRun& run : runs) {
    std::fill(node.begin() + run.first, node.begin() + run.end, run.node);
  }
  return node;
}

RunCursor::RunCursor(const std::vector<LabelledRun>& runs, const motion::LatticeWindow& window)
    : runs_(runs), nx_(window.nx()) {
  in_row_.reserve(window.ny() + 1);
  std::size_t run = 0;
  for (std::size_t row = 0; row <= window.ny(); ++row) {
    while (run < runs.size() && runs[run].first < row * nx_) ++run;
    in_row_.push_back(run);
  }
}

void RunCursor::move_to(std::size_t row, std::size_t place) {
  const std::span<const LabelledRun> runs = in_row(row);
  const auto begin = runs.begin();
  const auto end = runs.end();
  const auto run = std::partition_point(
      begin, end, [&](const LabelledRun& before) { return before.end <= place; });
  if (run != end && run->first <= place) {
    first_ = run->first;
    end_ = run->end;
    node_ = run->node;
    return;
  }
  first_ = run == begin ? row * nx_ : (run - 1)->end;
  end_ = run == end ? (row + 1) * nx_ : run->first;
  node_ = kNoNode;
}

std::vector<LabelledRun> runs_of(const motion::LatticeWindow& window,
                                 const std::vector<std::uint32_t>& node) {
  std::vector<LabelledRun> runs;
  const auto nx = static_cast<std::uint32_t>(window.nx());
  for (std::uint32_t row = 0; row < node.size(); row += nx) {
    for (std::uint32_t at = row; at < row + nx;) {
      const std::uint32_t first = at;
      do ++at;
      while (at < row + nx && node[at] == node[first]);
      if (node[first] != kNoNode) runs.push_back({first, at, node[first]});
    }
  }
  return runs;
}

LayerLabels label_solids(const motion::LatticeWindow& window, const std::vector<double>& value) {
  return label_parts(window, value, true, 0);
}

LayerLabels label_voids(const motion::LatticeWindow& window, const std::vector<double>& value) {
  LayerLabels labels = label_parts(window, value, false, 1);
  labels.enclosed = 0;
  if (!labels.size.empty()) labels.size[kExterior] = kUnbounded;
  return labels;
}

std::vector<std::vector<std::uint32_t>> samples_by_node(const LayerLabels& labels) {
  std::vector<std::vector<std::uint32_t>> samples(labels.size.size());
  for (std::size_t n = 0; n < samples.size(); ++n) {
    if (labels.size[n] != kUnbounded) samples[n].reserve(labels.size[n]);
  }
  for (const auto& [first, end, node] : labels.runs) {
    if (labels.size[node] == kUnbounded) continue;
    for (std::uint32_t at = first; at < end; ++at) samples[node].push_back(at);
  }
  return samples;
}

}  // namespace tetloft::internal::between
