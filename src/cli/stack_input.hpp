// The stack a command works on, and how its contours correspond: what reconstruct and check
// have in common.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/mending_options.hpp"
#include "cli/read_options.hpp"
#include "pieces/section_store.hpp"

namespace tetloft::cli {

/// Those of read_options.hpp, and of mending_options.hpp, --snap, --refine.
[[nodiscard]] std::vector<Option> preparation_options();
/// The same, after --correspondence, --overlap, --voids, --labels.
[[nodiscard]] std::vector<Option> stack_options();

struct SnapReport {
  int bits = 0;
  double lattice = 0;
  std::size_t moved = 0;
  std::size_t removed = 0;  ///< of these: fell on their predecessor
  double largest_move = 0;
  std::vector<MovedVertex> first;  ///< a few, for people
};

/// What is done to a stack before it is worked on: mended, then snapped, then refined.
struct Preparation {
  ReadOptions read;
  Mending mending;
  std::optional<int> snap;       ///< bits
  std::optional<double> refine;  ///< the longest edge left
};

struct StackInput {
  std::variant<SectionStack, ValidStack> given;  ///< as it is worked on; valid if a reader says so
  /// In place of `given`: the sections one after the other.
  std::optional<OpenedSections> opened;
  Labels labels;     ///< that the file gives its contours
  std::string name;  ///< of the structure that was read
  std::string unit;  ///< of length, where the file names one
  std::optional<PlanesReport> planes;
  std::optional<RepairReport> repaired;
  std::optional<SnapReport> snapped;
  std::optional<std::size_t> inserted;  ///< vertices, by refining

  [[nodiscard]] std::size_t section_count() const {
    return opened ? opened->count : stack().sections.size();
  }
  /// Of what was read as a whole.
  [[nodiscard]] const SectionStack& stack() const {
    const auto* valid = std::get_if<ValidStack>(&given);
    return valid != nullptr ? valid->stack() : std::get<SectionStack>(given);
  }
};

/// take() of the stack, as pieces::stage_plan() and its like are given it.
template <class Take>
auto with_given(const StackInput& input, const Take& take) {
  if (input.opened) return take(internal::pieces::GivenSections{*input.opened->sections});
  return std::visit(take, input.given);
}

/// Checks the options' values without touching a file. Labels and decisions stay empty.
[[nodiscard]] Result<CorrespondenceOptions> correspondence_options(const Arguments& arguments,
                                                                   Console& console);
/// All of these as given.
[[nodiscard]] Result<Preparation> preparation(const Arguments& arguments);

/// Reads and prepares the stack; "-" is standard input. Warnings go to the console.
[[nodiscard]] Result<StackInput> read_stack_input(const std::string& path,
                                                  const Preparation& preparation, Console& console);
/// The same for what takes sections one after the other: StackInput::opened, where the file can be
/// read so and nothing that is asked for needs all of them.
[[nodiscard]] Result<StackInput> open_stack_input(const Arguments& arguments,
                                                  const std::string& path,
                                                  const Preparation& preparation, Console& console);
/// --model-format.
[[nodiscard]] Option model_format_option();
[[nodiscard]] Result<std::string> chosen_model_format(const Arguments& arguments);
/// Reads a model; "-" is standard input; an index (.pvtu) is the solid of the pieces that it lists.
/// Warnings go to the console.
[[nodiscard]] Result<Model> read_model_input(const std::string& path, const std::string& format,
                                             Console& console);
/// Whether that would be an index.
[[nodiscard]] bool is_index(const std::string& path, const std::string& format);
/// Whether the pieces of an index lie in other coordinates than the stack.
[[nodiscard]] Result<bool> lies_elsewhere(const std::string& index, const SectionStack& stack);
/// Puts a model whose file does not tell how the planes of its stack are turned back into the
/// coordinates of the stack, where that loses nothing; else warns that they lie differently.
void put_into_frame(Model& model, const SectionStack& stack, Console& console);

/// Members "planes", "repair", "snap" and "refine", where that was done.
void write_preparation(JsonWriter& json, const StackInput& input);
/// The same as lines of text.
[[nodiscard]] std::string describe_preparation(const StackInput& input);

}  // namespace tetloft::cli
