#include "comparison/options.hpp"

#include <charconv>
#include <string_view>

namespace tetloft::bench {

namespace {

template <class Number>
bool parse_number(std::string_view text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && at == end;
}

}  // namespace

std::optional<CompareOptions> parse_options(int argc, char** argv) {
  CompareOptions options;
  for (int i = 1; i < argc; i += 2) {
    if (i + 1 == argc) return std::nullopt;
    const std::string_view option = argv[i], value = argv[i + 1];
    bool good = true;
    if (option == "--solids") {
      good = parse_number(value, options.solids);
    } else if (option == "--size") {
      good = parse_number(value, options.size) && options.size >= 32;
    } else if (option == "--seed") {
      good = parse_number(value, options.seed);
    } else if (option == "--largest") {
      good = parse_number(value, options.largest);
    } else if (option == "--samples") {
      good = parse_number(value, options.samples);
    } else if (option == "--only") {
      options.only = value;
    } else if (option == "--stacks") {
      options.folders.emplace_back(value);
      good = std::filesystem::is_directory(options.folders.back());
    } else if (option == "--json") {
      options.json = value;
    } else if (option == "--markdown") {
      options.markdown = value;
    } else {
      good = false;
    }
    if (!good) return std::nullopt;
  }
  return options;
}

}  // namespace tetloft::bench
