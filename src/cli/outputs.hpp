// Output files, looked at before any work is done.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

/// Usage error where `path` (the value of `option`) has none of the extensions, or is one of
/// the files `taken`; io error where its folder does not take files.
[[nodiscard]] Result<void> check_output(std::string_view option, const std::string& path,
                                        const std::vector<std::string_view>& extensions,
                                        const std::vector<std::string>& taken);

/// Where a model goes.
struct ModelOutputs {
  std::string solid;
  std::optional<std::string> surface;
  Encoding encoding = Encoding::binary;
};

/// --output, --surface and --ascii, checked; none may be an input.
[[nodiscard]] Result<ModelOutputs> model_outputs(const Arguments& arguments);

/// Writes the surface, then the solid; where one fails, neither is there.
[[nodiscard]] Result<void> write_model(const Model& model, const ModelOutputs& outputs,
                                       Console& console);
/// "written: a.vtu, b.ply", a line.
[[nodiscard]] std::string describe(const ModelOutputs& outputs);

}  // namespace tetloft::cli
