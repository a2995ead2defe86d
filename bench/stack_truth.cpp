#include "stack_truth.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace tetloft::bench {

namespace {

// The first number behind "key": in the text, if any: enough for the flat truth files.
std::optional<double> find_number(const std::string& text, const std::string& key) {
  const std::size_t at = text.find('"' + key + "\":");
  if (at == std::string::npos) return std::nullopt;
  char* end = nullptr;
  const char* begin = text.c_str() + at + key.size() + 3;
  const double value = std::strtod(begin, &end);
  if (end == begin) return std::nullopt;
  return value;
}

}  // namespace

StackTruth read_stack_truth(std::filesystem::path path) {
  path.replace_extension(".json");
  std::ifstream in(path);
  std::stringstream buffer;
  buffer << in.rdbuf();
  const std::string text = buffer.str();
  StackTruth truth;
  for (const char* key : {"shells", "components_26", "components"}) {
    if (!truth.components) truth.components = find_number(text, key);
  }
  for (const char* key : {"total_genus", "handles_26", "genus"}) {
    if (!truth.genus) truth.genus = find_number(text, key);
  }
  truth.cavities = find_number(text, "cavities");
  return truth;
}

}  // namespace tetloft::bench
