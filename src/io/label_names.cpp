#include "io/label_names.hpp"

#include <cstddef>
#include <set>
#include <string_view>

#include "io/cursor.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kLongestLabel = 60;

// Programs do not tell the case apart, and give it back in capitals: so these stand there at once.
std::string label_of(std::string_view name, std::int64_t tag) {
  std::string label;
  for (const char c : name) {
    if (label.size() == kLongestLabel) break;
    const char capital = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (is_letter(c) || is_digit(c)) label += capital;
    if (!is_letter(c) && !is_digit(c) && !label.empty() && label.back() != '_') label += '_';
  }
  while (!label.empty() && label.back() == '_') label.pop_back();
  if (label.empty()) return "COMPONENT_" + std::to_string(tag);
  return is_letter(label.front()) ? label : "C_" + label.substr(0, kLongestLabel - 2);
}

}  // namespace

std::vector<std::string> label_names(const std::vector<ComponentGroup>& groups,
                                     std::vector<std::string> taken) {
  std::set<std::string> used(taken.begin(), taken.end());
  std::vector<std::string> labels;
  for (const ComponentGroup& group : groups) {
    const std::string label = label_of(group.name, group.tag());
    std::string free = label;
    for (int i = 2; !used.insert(free).second; ++i) {
      const std::string number = '_' + std::to_string(i);
      free = label.substr(0, kLongestLabel - number.size()) + number;
    }
    labels.push_back(free);
  }
  return labels;
}

}  // namespace tetloft::internal::io
