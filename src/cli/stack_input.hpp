// The stack a command works on, and how its contours correspond: what reconstruct and check
// have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

/// --correspondence, --overlap, --labels, --snap.
[[nodiscard]] std::vector<Option> stack_options();

struct SnapReport {
  int bits = 0;
  double lattice = 0;
  std::size_t moved = 0;
  std::size_t removed = 0;  ///< of these: fell on their predecessor
  double largest_move = 0;
  std::vector<MovedVertex> first;  ///< a few, for people
};

struct StackInput {
  SectionStack stack;  ///< as it is worked on: snapped if asked for
  std::optional<SnapReport> snapped;
};

/// Checks the options' values without touching a file. `labels` stay empty.
[[nodiscard]] Result<CorrespondenceOptions> correspondence_options(const Arguments& arguments,
                                                                   Console& console);
/// --snap as given: 1 to 50 bits.
[[nodiscard]] Result<std::optional<int>> snap_bits(const Arguments& arguments);

/// Reads and snaps the stack; warnings go to the console.
[[nodiscard]] Result<StackInput> read_stack_input(const std::string& path, std::optional<int> snap,
                                                  Console& console);
/// Reads --labels; each must name a contour of `stack`.
[[nodiscard]] Result<std::vector<Label>> read_label_option(const Arguments& arguments,
                                                           const SectionStack& stack);

/// A member "snap".
void write_snap(JsonWriter& json, const SnapReport& report);
/// The same as lines of text.
[[nodiscard]] std::string describe_snap(const SnapReport& report);

}  // namespace tetloft::cli
