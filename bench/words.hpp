// What the command lines of the programs here have in common: numbers read whole, and words that
// nothing has refused with a list of those there are.
#pragma once

#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "core/spelling.hpp"

namespace tetloft::bench {

using namespace internal;

/// The whole of `text` as a number.
template <class Number>
[[nodiscard]] bool parse_number(std::string_view text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto [stopped, failed] = std::from_chars(text.data(), end, number);
  return failed == std::errc() && stopped == end;
}

/// Says what is wrong and how the program is called; the exit code of that.
inline int usage_failure(const std::string& message, const char* usage) {
  std::fprintf(stderr, "error: %s\n%s", message.c_str(), usage);
  return 2;
}

/// Why `word` stands for none of `names`: "--only nosuch: there is a, b or c".
[[nodiscard]] inline std::string no_such(const std::string& option, const std::string& word,
                                         const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  return option + ' ' + word + did_you_mean(word, views) + ": there is " + list_of(views);
}

/// Whether one of `names` has `part` in it.
[[nodiscard]] inline bool any_has(const std::vector<std::string>& names, const std::string& part) {
  for (const std::string& name : names) {
    if (name.find(part) != std::string::npos) return true;
  }
  return false;
}

}  // namespace tetloft::bench
