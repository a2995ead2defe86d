// Output files, looked at before any work is done.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::cli {

/// Usage error where `path` (the value of `option`) has none of the extensions, or is one of
/// the files `taken`; io error where its folder does not take files.
[[nodiscard]] Result<void> check_output(std::string_view option, const std::string& path,
                                        const std::vector<std::string_view>& extensions,
                                        const std::vector<std::string>& taken);

}  // namespace tetloft::cli
