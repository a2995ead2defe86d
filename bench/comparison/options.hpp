// The command line of tetloft_compare.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tetloft::bench {

struct CompareOptions {
  std::size_t solids = 10;  ///< of each kind
  std::size_t size = 96;    ///< samples along an axis
  std::uint64_t seed = 1;
  std::size_t largest = 60'000;      ///< vertices of stacks from folders
  std::size_t samples = 5'000;       ///< on each surface
  std::vector<std::size_t> between;  ///< further methods: all_methods()
  std::string only;                  ///< methods with this in their name; empty: all
  std::vector<std::filesystem::path> folders;
  std::string json, markdown;  ///< files to write; empty: none
};

/// What is wrong with the command line; empty if nothing is.
[[nodiscard]] std::string parse_options(int argc, char** argv, CompareOptions& options);

}  // namespace tetloft::bench
