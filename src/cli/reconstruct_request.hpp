// What reconstruct is asked for.
#pragma once

#include <string>

#include <tetloft/tetloft.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/outputs.hpp"
#include "cli/stack_input.hpp"

namespace tetloft::cli {

struct ReconstructRequest {
  std::string input;
  ModelOutputs outputs;
  ReconstructOptions options;
  Preparation preparation;
  bool verify = false;
};

/// The options that say how a stack is made into a solid: usage and value of each. Without those of
/// stack_options().
[[nodiscard]] std::vector<Option> solid_options();

/// Everything but the outputs that can be said about the command line before a file is read.
[[nodiscard]] Result<ReconstructRequest> solid_request_of(const Arguments& arguments,
                                                          Console& console);
/// The same with outputs.
[[nodiscard]] Result<ReconstructRequest> reconstruct_request_of(const Arguments& arguments,
                                                                Console& console);

/// An internal error where a guarantee fails: reconstruct promises them.
[[nodiscard]] Result<void> verify(const Model& model, const SectionStack& stack,
                                  const ReconstructOptions& made_with);

}  // namespace tetloft::cli
