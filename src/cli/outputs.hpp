// Output files, looked at before any work is done.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "io/pending_file.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

/// Usage error where `path` (the value of `option`) has none of the extensions, if there are any,
/// or is one of the files `taken`; io error where its folder does not take files.
[[nodiscard]] Result<void> check_output(std::string_view option, const std::string& path,
                                        const std::vector<std::string_view>& extensions,
                                        const std::vector<std::string>& taken);

/// How outputs are written.
inline const Option kAsciiOption{"--ascii", "", "write numbers as text that reads back exactly"};
inline const Option kCompressOption{"--compress", "",
                                    "write numbers compressed (zlib), where the format can"};
/// Usage error for both.
[[nodiscard]] Result<Encoding> encoding_of(const Arguments& arguments);

/// Where a model goes: one of the first two, or both.
struct ModelOutputs {
  std::optional<std::string> solid;
  std::optional<std::string> surface;
  std::optional<std::string> repaired;  ///< the stack (repaired_output.hpp)
  Encoding encoding = Encoding::binary;
  std::string format = {};  ///< by name; empty: as the extensions say
};

/// --output, --surface, --ascii and --compress, checked; one of the first two is required, none may
/// be an input.
[[nodiscard]] Result<ModelOutputs> model_outputs(const Arguments& arguments);

/// Files that are complete and have not appeared yet.
using StagedFiles = std::vector<internal::io::PendingFile>;

/// Takes the files, and tells the warnings of their writer.
[[nodiscard]] Result<void> take_staged(Result<internal::io::Staged> staged, StagedFiles& files,
                                       Console& console);

/// Where a model's tets come from: those of a reconstruction are positive, by proof.
enum class Tets : std::uint8_t { proven, any };

/// The surface and the solid, up to the last step.
[[nodiscard]] Result<StagedFiles> stage_model(const Model& model, const ModelOutputs& outputs,
                                              Console& console, Tets tets = Tets::any);
/// Where they will appear; of outputs with what a format has beside the one that was asked for.
[[nodiscard]] std::vector<std::string> paths_of(const ModelOutputs& outputs);
[[nodiscard]] std::vector<std::string> paths_of(const StagedFiles& files);
/// "written: a.vtu, b.ply", a line.
[[nodiscard]] std::string written_line(const std::vector<std::string>& paths);

/// The last step of a command that writes files: its result (none where empty) reaches the reader,
/// then all files appear. Where the result or a file fails, none does.
[[nodiscard]] Result<void> deliver_with(StagedFiles& files, const std::string& result,
                                        Console& console);

}  // namespace tetloft::cli
