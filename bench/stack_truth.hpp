// The flat .json files beside .cnt stacks that tell what they were cut from.
#pragma once

#include <filesystem>
#include <optional>

namespace tetloft::bench {

struct StackTruth {
  std::optional<double> components, genus, cavities;
};

/// The truth of the stack at `path`, from the file of the same name with extension .json; empty
/// where there is none.
[[nodiscard]] StackTruth read_stack_truth(std::filesystem::path path);

}  // namespace tetloft::bench
