// Names of components after the labels of their contours.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>

namespace tetloft::internal {

/// "label 7" of each component with a contour that has label 7: of several labels the least, since
/// different ones are in different components. None where there are no labels. Labels are of
/// contours of the partition.
[[nodiscard]] IdVector<ComponentId, std::string> names_by_labels(const ContourPartition& partition,
                                                                 std::size_t components,
                                                                 const std::vector<Label>& labels);

}  // namespace tetloft::internal
