// Files of voxels that stand beside the header that names them.
//
// A header names files of its own folder, or of folders in it: it may come from anywhere, and must
// not lead elsewhere. Of a path from elsewhere (absolute, or through "..") the file of that name in
// the header's folder is taken, where a header and its data are when they were moved together.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

/// The path of the file that the header `header`, in `folder`, calls `named`. Error invalid_input
/// where the header was not read from a file, or there is none such.
[[nodiscard]] Result<std::string> data_file(const std::string& folder, const std::string& header,
                                            const std::string& named);

/// Of a NIfTI header "NAME.hdr" or "NAME.hdr.gz": "NAME.img", or "NAME.img.gz".
[[nodiscard]] Result<std::string> image_of_pair(const std::string& folder,
                                                const std::string& header);

/// Whether this is a pattern for names: one conversion "%d", "%03d", … ("%i" and "%u" alike).
[[nodiscard]] bool is_pattern(const std::string& name);
/// The name for a number. Requires is_pattern(pattern).
[[nodiscard]] std::string numbered(const std::string& pattern, std::int64_t number);

}  // namespace tetloft::internal::io
