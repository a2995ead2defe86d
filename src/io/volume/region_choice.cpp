// Choosing a region: names first, then values, then what there is only one of.
#include "io/volume/region_choice.hpp"

#include <optional>
#include <utility>

#include "core/spelling.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kMostListed = 20;

Error choice_error(const std::string& name, const std::string& message,
                   ErrorCode code = ErrorCode::usage) {
  Error error{code, message, {}};
  error.where.file = name;
  return error;
}

std::string value_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string enumerated(const std::vector<std::string>& texts) {
  std::string all;
  for (std::size_t i = 0; i < texts.size() && i < kMostListed; ++i) {
    all += (i == 0 ? "" : ", ") + texts[i];
  }
  if (texts.size() > kMostListed) {
    all += " and " + std::to_string(texts.size() - kMostListed) + " more";
  }
  return all;
}

// "1 'ribs' (8487 voxels), …", without 0.
std::string listed_labels(const VolumeHeader& header, std::size_t layer,
                          const ValueCounts& counts) {
  std::vector<std::string> texts;
  for (const auto& [value, voxels] : counts.values) {
    if (value == 0) continue;
    std::string text = value_text(value);
    const std::string segment = segment_name(header, layer, value);
    if (!segment.empty()) text += ' ' + in_quotes(segment);
    texts.push_back(text + " (" + std::to_string(voxels) + (voxels == 1 ? " voxel)" : " voxels)"));
  }
  return enumerated(texts);
}

std::string listed_segments(const VolumeHeader& header) {
  std::vector<std::string> texts;
  for (const VolumeSegment& segment : header.segments) {
    std::string text = value_text(segment.value) + ' ' + in_quotes(segment.name);
    if (header.layers > 1) text += " in volume " + std::to_string(segment.layer + 1);
    texts.push_back(std::move(text));
  }
  return enumerated(texts);
}

std::string range_of(const ValueCounts& counts) {
  return "from " + value_text(counts.least) + " to " + value_text(counts.largest);
}

ChosenRegion region_of(const VolumeSegment& segment) {
  return {segment.layer, {segment.value, {}}, segment.name};
}

// The only segment that `matches`, if it is one.
template <class Matches>
std::optional<ChosenRegion> only_segment(const VolumeHeader& header, Matches&& matches) {
  std::optional<ChosenRegion> found;
  for (const VolumeSegment& segment : header.segments) {
    if (!matches(segment)) continue;
    if (found) return std::nullopt;
    found = region_of(segment);
  }
  return found;
}

std::optional<ChosenRegion> named_segment(const VolumeHeader& header, const std::string& wanted) {
  auto found = only_segment(header, [&](const VolumeSegment& s) { return s.name == wanted; });
  if (found) return found;
  const std::string lower = lower_case(wanted);
  found = only_segment(header, [&](const VolumeSegment& s) { return lower_case(s.name) == lower; });
  if (found) return found;
  const ParsedNumber number = parse_number(wanted);
  if (!number.ok()) return std::nullopt;
  return only_segment(header, [&](const VolumeSegment& s) { return s.value == number.value; });
}

// "N" or "N:V".
struct VolumeAndLabel {
  std::size_t layer = 0;
  std::optional<double> label;
};
std::optional<VolumeAndLabel> volume_and_label(const VolumeHeader& header,
                                               const std::string& wanted) {
  const std::size_t colon = wanted.find(':');
  const auto number = parse_integer(std::string_view(wanted).substr(0, colon));
  if (!number || *number < 1 || static_cast<std::uint64_t>(*number) > header.layers) {
    return std::nullopt;
  }
  VolumeAndLabel chosen{static_cast<std::size_t>(*number - 1), {}};
  if (colon == std::string::npos) return chosen;
  const ParsedNumber label = parse_number(std::string_view(wanted).substr(colon + 1));
  if (!label.ok()) return std::nullopt;
  chosen.label = label.value;
  return chosen;
}

std::string volumes_to_choose_from(const VolumeHeader& header) {
  return "the file holds " + std::to_string(header.layers) +
         " volumes: choose one with --label N, from 1 to " + std::to_string(header.layers) +
         ", of a label volume also --label N:VALUE, of an image with --iso VALUE";
}

Result<ChosenRegion> by_iso(const VolumeHeader& header, const std::string& name,
                            const ReadOptions& options) {
  const RegionRule rule{0, options.iso};
  if (header.layers == 1) {
    if (options.structure.empty()) return ChosenRegion{0, rule, {}};
    return choice_error(name, "a label and an iso-value exclude each other");
  }
  const auto chosen = volume_and_label(header, options.structure);
  if (!chosen || chosen->label) return choice_error(name, volumes_to_choose_from(header));
  return ChosenRegion{chosen->layer, rule, {}};
}

// The only label of a layer.
Result<ChosenRegion> only_label(Volume& volume, std::size_t layer, const std::string& name,
                                WatchedWork& work) {
  const VolumeHeader& header = volume.header();
  const Result<ValueCounts> counts = count_values(volume, layer, work);
  if (!counts) return counts.error();
  const std::string prefix = header.layers > 1 ? std::to_string(layer + 1) + ':' : "";
  const std::string of_volume =
      header.layers > 1 ? "volume " + std::to_string(layer + 1) : "the volume";
  if (!counts->are_labels()) {
    return choice_error(name, of_volume + " is an image, with values " + range_of(*counts) +
                                  ": choose the region of values from VALUE on with --iso VALUE");
  }
  std::optional<double> only;
  for (const auto& [value, voxels] : counts->values) {
    if (value == 0) continue;
    if (only) {
      return choice_error(
          name, of_volume + " has several labels: " + listed_labels(header, layer, *counts) +
                    "; choose one with --label " + prefix + "N" +
                    (header.segments.empty() ? "" : "|NAME") +
                    ", or --label all; of an image, --iso VALUE");
    }
    only = value;
  }
  if (!only) {
    return choice_error(name, "all voxels of " + of_volume + " are 0", ErrorCode::invalid_input);
  }
  return ChosenRegion{layer, {*only, {}}, segment_name(header, layer, *only)};
}

Result<ChosenRegion> by_structure(Volume& volume, const std::string& name,
                                  const std::string& wanted, WatchedWork& work) {
  const VolumeHeader& header = volume.header();
  if (auto segment = named_segment(header, wanted)) return *std::move(segment);
  if (header.layers > 1 || wanted.find(':') != std::string::npos) {
    const auto chosen = volume_and_label(header, wanted);
    if (!chosen) {
      const std::string segments = listed_segments(header);
      return choice_error(name, "there is no single structure " + in_quotes(wanted) + "; " +
                                    (segments.empty() ? "" : "there is " + segments + "; ") +
                                    volumes_to_choose_from(header));
    }
    if (!chosen->label) return only_label(volume, chosen->layer, name, work);
    return ChosenRegion{
        chosen->layer, {*chosen->label, {}}, segment_name(header, chosen->layer, *chosen->label)};
  }
  const ParsedNumber value = parse_number(wanted);
  if (value.ok()) return ChosenRegion{0, {value.value, {}}, segment_name(header, 0, value.value)};
  if (header.segments.empty()) {
    return choice_error(name, "the labels of this file have no names, of which " +
                                  in_quotes(wanted) + " could be one: choose by value");
  }
  std::vector<std::string_view> names;
  for (const VolumeSegment& segment : header.segments) names.push_back(segment.name);
  return choice_error(name, "there is no single segment " + in_quotes(wanted) +
                                did_you_mean(wanted, names) + "; there is " +
                                listed_segments(header));
}

}  // namespace

std::string segment_name(const VolumeHeader& header, std::size_t layer, double value) {
  for (const VolumeSegment& segment : header.segments) {
    if (segment.layer == layer && segment.value == value) return segment.name;
  }
  return {};
}

std::size_t layers_to_count(const VolumeHeader& header, const ReadOptions& options) {
  if (options.iso) return 0;
  if (options.structure.empty()) return header.layers == 1 && header.segments.size() != 1 ? 1 : 0;
  if (header.layers == 1 || named_segment(header, options.structure)) return 0;
  const auto chosen = volume_and_label(header, options.structure);
  return chosen && !chosen->label ? 1 : 0;
}

Result<ChosenRegion> choose_region(Volume& volume, const std::string& name,
                                   const ReadOptions& options, WatchedWork& work) {
  const VolumeHeader& header = volume.header();
  if (options.iso) return by_iso(header, name, options);
  if (!options.structure.empty()) return by_structure(volume, name, options.structure, work);
  if (header.segments.size() == 1) return region_of(header.segments.front());
  if (header.layers == 1) return only_label(volume, 0, name, work);
  if (header.segments.empty()) return choice_error(name, volumes_to_choose_from(header));
  return choice_error(name, "the file has several segments: " + listed_segments(header) +
                                "; choose one with --label N|NAME, or --label all");
}

Error empty_region(Volume& volume, const std::string& name, const ReadOptions& options,
                   const ChosenRegion& region) {
  const Execution execution = untold(options.execution);
  WatchedWork work(execution, 0);
  const Result<ValueCounts> counts = count_values(volume, region.layer, work);
  if (!counts) return counts.error();
  if (region.rule.iso) {
    return choice_error(name,
                        "no voxel has a value of at least " + value_text(*region.rule.iso) +
                            "; they are " + range_of(*counts),
                        ErrorCode::invalid_input);
  }
  if (!region.name.empty()) {
    return choice_error(name, "the segment " + in_quotes(region.name) + " has no voxels",
                        ErrorCode::invalid_input);
  }
  const std::string labels = listed_labels(volume.header(), region.layer, *counts);
  return choice_error(
      name, "no voxel has the value " + value_text(region.rule.label) + "; " +
                (labels.empty() ? "values are " + range_of(*counts) : "there is " + labels));
}

std::vector<std::string> structure_names(const VolumeHeader& header,
                                         const std::vector<ValueCounts>& counts) {
  std::vector<std::string> names;
  for (std::size_t layer = 0; layer < counts.size(); ++layer) {
    if (!counts[layer].are_labels()) return {};
    for (const auto& counted : counts[layer].values) {
      const double value = counted.first;
      if (value == 0) continue;
      const auto is_this = [&, wanted = value](const std::optional<ChosenRegion>& region) {
        return region && region->layer == layer && region->rule.label == wanted;
      };
      const std::string segment = segment_name(header, layer, value);
      const std::string number = value_text(value);
      const auto by_number = named_segment(header, number);
      if (!segment.empty() && is_this(named_segment(header, segment))) {
        names.push_back(segment);
      } else if (is_this(by_number) || (header.layers == 1 && !by_number)) {
        names.push_back(number);
      } else {
        names.push_back(std::to_string(layer + 1) + ':' + number);
      }
    }
  }
  return names;
}

}  // namespace tetloft::internal::io
