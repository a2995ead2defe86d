// Names of labels in the extensions of a NIfTI header: the label tables of Caret, which
// segmentation programs write, too.
#pragma once

#include <string_view>
#include <vector>

#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// `extensions` is what stands between header and data: four bytes, of which the first tells
/// whether there are extensions, then each with its size and code. What is no such table is passed
/// over.
[[nodiscard]] std::vector<VolumeSegment> labels_in_extensions(std::string_view extensions,
                                                              bool big_endian);

}  // namespace tetloft::internal::io
