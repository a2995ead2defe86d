// Telling what a volume holds.
#include <algorithm>
#include <map>

#include "core/watched_work.hpp"
#include "io/volume/region_choice.hpp"
#include "io/volume/stack_of_volume.hpp"
#include "io/volume/value_counts.hpp"

namespace tetloft::internal::io {

namespace {

// Values of all layers together, with the names of the only layer that has some.
std::vector<LabelSummary> merged_labels(const VolumeHeader& header,
                                        const std::vector<ValueCounts>& counts) {
  std::map<double, std::size_t> all;
  for (const ValueCounts& layer : counts) {
    for (const auto& [value, voxels] : layer.values) all[value] += voxels;
  }
  if (all.size() > kMostLabels) return {};
  std::vector<LabelSummary> labels;
  for (const auto& [value, voxels] : all) {
    labels.push_back({value, voxels, segment_name(header, 0, value)});
  }
  return labels;
}

// A line for each segment, and for other values of any layer.
std::vector<LabelSummary> labels_of_segments(const VolumeHeader& header,
                                             const std::vector<ValueCounts>& counts) {
  std::map<double, std::size_t> unnamed;
  std::vector<LabelSummary> labels;
  for (std::size_t layer = 0; layer < counts.size(); ++layer) {
    for (const auto& [value, voxels] : counts[layer].values) {
      if (segment_name(header, layer, value).empty()) unnamed[value] += voxels;
    }
  }
  for (const auto& [value, voxels] : unnamed) labels.push_back({value, voxels, {}});
  for (const VolumeSegment& s : header.segments) {
    const std::size_t voxels = counts[s.layer].of(s.value);
    if (voxels > 0) labels.push_back({s.value, voxels, s.name});
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const LabelSummary& a, const LabelSummary& b) { return a.value < b.value; });
  return labels;
}

}  // namespace

Result<FileSummary> summary_of_volume(Volume& volume, const ReadOptions& options) {
  const VolumeHeader& header = volume.header();
  WatchedWork work(options.execution, header.layers * header.size[2]);
  VolumeSummary summary;
  summary.size = header.sizes;
  summary.spacing = header.spacing;
  summary.matrix = header.matrix;
  summary.space = header.space;
  summary.type = header.type;
  summary.unit = header.unit;
  FileSummary file;
  file.unit = header.unit;
  file.warnings = header.warnings;
  std::vector<ValueCounts> counts;
  std::size_t not_numbers = 0;
  for (std::size_t layer = 0; layer < header.layers; ++layer) {
    Result<ValueCounts> counted = count_values(volume, layer, work);
    if (!counted) return counted.error();
    summary.least = layer == 0 ? counted->least : std::min(summary.least, counted->least);
    summary.largest = layer == 0 ? counted->largest : std::max(summary.largest, counted->largest);
    summary.intensities = summary.intensities || counted->too_many;
    not_numbers += counted->not_numbers;
    counts.push_back(*std::move(counted));
  }
  if (not_numbers > 0) {
    file.warnings.push_back({std::to_string(not_numbers) + " voxels are not a number", {}});
  }
  if (!summary.intensities) {
    const bool apart = header.layers > 1 && !header.segments.empty();
    summary.labels = apart ? labels_of_segments(header, counts) : merged_labels(header, counts);
    summary.intensities = summary.labels.empty();
  }
  if (!summary.intensities) summary.structures = structure_names(header, counts);
  file.volume = std::move(summary);
  return file;
}

}  // namespace tetloft::internal::io
