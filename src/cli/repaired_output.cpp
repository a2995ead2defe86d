// See repaired_output.hpp.
#include "cli/repaired_output.hpp"

#include <utility>

#include "cli/file_formats.hpp"
#include "cli/signals.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

Option repaired_option() {
  return {"--repaired", "FILE",
          "also write the stack as it is worked on, mended, snapped, refined: " +
              described_outputs(Contents::stack) + "; check takes it in place of the input"};
}

Result<std::optional<std::string>> repaired_output(const Arguments& arguments,
                                                   const std::vector<std::string>& taken) {
  std::optional<std::string> path = arguments.text("--repaired");
  if (!path) return path;
  const Result<void> checked =
      check_output("--repaired", *path, output_extensions(Contents::stack), taken);
  if (!checked) return checked.error();
  return path;
}

Result<void> stage_repaired(const std::optional<std::string>& path, const SectionStack& stack,
                            StagedFiles& files, Console& console) {
  if (!path) return {};
  return take_staged(io::stage_stack(*path, stack, {}, temporary_watcher()), files, console);
}

}  // namespace tetloft::cli
