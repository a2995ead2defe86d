// What reconstruct is asked for of many stacks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/reconstruct_request.hpp"

namespace tetloft::cli {

/// --list, --to and --log.
[[nodiscard]] std::vector<Option> batch_options();
/// Usage error where one of these is given for a single stack.
[[nodiscard]] Result<void> check_no_batch_options(const Arguments& arguments);

struct BatchRequest {
  std::string folder;  ///< without a slash at its end
  std::string log;
  std::string extension;
  std::string digest;          ///< of the options
  ReconstructRequest request;  ///< the outputs without paths
  bool solids = true;          ///< or boundaries
};

/// Everything that can be said about the command line before the stacks are listed; `options` are
/// all that the command takes.
[[nodiscard]] Result<BatchRequest> batch_request_of(const Arguments& arguments,
                                                    const std::vector<Option>& options,
                                                    Console& console);

/// A path by which files, there or not yet, are compared: absolute, its links followed.
[[nodiscard]] std::filesystem::path place_of(const std::string& path);

}  // namespace tetloft::cli
