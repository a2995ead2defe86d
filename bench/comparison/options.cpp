#include "comparison/options.hpp"

#include <string_view>

#include "words.hpp"

namespace tetloft::bench {

std::string parse_options(int argc, char** argv, CompareOptions& options) {
  for (int i = 1; i < argc; i += 2) {
    const std::string_view option = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
    bool good = i + 1 < argc;
    if (option == "--solids") {
      good = good && parse_number(value, options.solids);
    } else if (option == "--size") {
      good = good && parse_number(value, options.size) && options.size >= 32;
    } else if (option == "--seed") {
      good = good && parse_number(value, options.seed);
    } else if (option == "--largest") {
      good = good && parse_number(value, options.largest);
    } else if (option == "--samples") {
      good = good && parse_number(value, options.samples);
    } else if (option == "--between") {
      good = good && parse_number(value, options.between.emplace_back());
    } else if (option == "--only") {
      options.only = value;
    } else if (option == "--stacks") {
      options.folders.emplace_back(value);
      good = good && std::filesystem::is_directory(options.folders.back());
    } else if (option == "--json") {
      options.json = value;
    } else if (option == "--markdown") {
      options.markdown = value;
    } else {
      return "unknown option " + std::string(option);
    }
    if (!good) return std::string(option) + " has no value that it can take";
  }
  return {};
}

}  // namespace tetloft::bench
