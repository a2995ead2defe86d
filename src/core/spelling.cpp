// See spelling.hpp.
#include "core/spelling.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace tetloft::internal {

namespace {

// Without the hyphens that every option begins with: they are no evidence.
std::string_view stem(std::string_view word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

// A word longer than any of ours; it is like none, and its distance would take its time.
constexpr std::size_t kLongest = 64;

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates) {
  const std::string meant = lower_case(stem(word));
  if (meant.empty() || meant.size() > kLongest) return {};
  std::string_view best;
  std::optional<std::size_t> least;
  for (const std::string_view candidate : candidates) {
    const std::string name = lower_case(stem(candidate));
    const std::size_t allowed = std::max<std::size_t>(1, std::min(meant.size(), name.size()) / 3);
    // A beginning is as good as one slip, but one letter is the beginning of too much.
    const bool begins = meant.size() > 1 && name.rfind(meant, 0) == 0;
    const std::size_t distance = begins ? 1 : edit_distance(meant, name);
    if (distance > allowed || name.size() < 2 || (least && *least <= distance)) continue;
    best = candidate;
    least = distance;
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates) {
  const std::string_view found = closest(word, candidates);
  return found.empty() ? std::string() : " (did you mean " + std::string(found) + "?)";
}

std::string list_of(const std::vector<std::string_view>& words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? " or " : ", ";
    list += words[i];
  }
  return list;
}

}  // namespace tetloft::internal
