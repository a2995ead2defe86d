// Reading points of three values each.
#include "io/drawing/triples.hpp"

#include <algorithm>
#include <cstddef>

#include "io/numbers.hpp"

namespace tetloft::internal::io {

std::string_view without_padding(std::string_view value) {
  constexpr std::string_view kPadding("\0 \t\r\n", 5);
  const std::size_t first = value.find_first_not_of(kPadding);
  if (first == std::string_view::npos) return {};
  return value.substr(first, value.find_last_not_of(kPadding) - first + 1);
}

Triples triples_of(std::string_view text) {
  std::string_view rest = without_padding(text);
  while (!rest.empty() && rest.back() == '\\') {
    rest = without_padding(rest.substr(0, rest.size() - 1));
  }
  Triples triples;
  if (rest.empty()) return triples;
  const auto values = static_cast<std::size_t>(std::count(rest.begin(), rest.end(), '\\')) + 1;
  if (values % 3 != 0) {
    triples.wrong = std::to_string(values) + (values == 1 ? " value" : " values") +
                    ", which is no multiple of three";
    return triples;
  }
  triples.points.resize(values / 3);
  for (std::size_t i = 0; i < values; ++i) {
    const std::size_t end = std::min(rest.find('\\'), rest.size());
    const std::string_view token = without_padding(rest.substr(0, end));
    const ParsedNumber number = parse_number(token);
    if (!number.ok()) {
      triples.wrong = "value " + std::to_string(i) + ": " + complaint(token, number.status);
      if (token.find(',') != std::string_view::npos) triples.wrong += " (a decimal comma?)";
      return triples;
    }
    Point3& p = triples.points[i / 3];
    (i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z) = number.value;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return triples;
}

}  // namespace tetloft::internal::io
