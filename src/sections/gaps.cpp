// Planes suspiciously near to each other. Nothing is decided by it: it only warns.
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/repair.hpp>

namespace tetloft {

namespace {

// How each of the warnings ends.
constexpr std::string_view kPerhapsOneSlice =
    ": perhaps one slice written as two planes; if so, put its contours into one section";

// People write a slice twice with heights that differ by rounding, or by a small offset that
// keeps the heights distinct; slices of a scan differ by far less than this factor.
constexpr double kFactor = 1000;
constexpr std::size_t kLongestRun = 2;

std::string shortest(double value) {
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr;
  return {text, end};
}

// The smaller of the gaps on either side of gaps [from, to), infinite where there is none.
double beside(const std::vector<double>& gaps, std::size_t from, std::size_t to) {
  double least = std::numeric_limits<double>::infinity();
  if (from > 0) least = std::min(least, gaps[from - 1]);
  if (to < gaps.size()) least = std::min(least, gaps[to]);
  return least;
}

}  // namespace

bool is_of_gap(const Warning& warning) { return warning.message.ends_with(kPerhapsOneSlice); }

std::vector<Warning> suspicious_gaps(const SectionStack& stack) {
  std::vector<double> gaps;
  for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
    gaps.push_back(stack.sections[SectionId(s + 1)].z - stack.sections[SectionId(s)].z);
  }
  // Heights that do not increase are for validate() to name.
  if (std::any_of(gaps.begin(), gaps.end(), [](double gap) { return !(gap > 0); })) return {};
  std::vector<Warning> warnings;
  const auto tell = [&](std::size_t s, double around) {
    if (stack.sections[SectionId(s)].contours.empty()) return;
    if (stack.sections[SectionId(s + 1)].contours.empty()) return;
    Warning warning{"the sections " + std::to_string(s) + " and " + std::to_string(s + 1) +
                        " are " + shortest(gaps[s]) + " apart, where the gaps around are " +
                        shortest(around) + std::string(kPerhapsOneSlice),
                    {}};
    warning.where.section = s + 1;
    warnings.push_back(std::move(warning));
  };
  for (std::size_t from = 0; from < gaps.size();) {
    std::size_t taken = 0;
    for (std::size_t run = kLongestRun; run > 0 && taken == 0; --run) {
      const std::size_t to = from + run;
      if (to > gaps.size() || run == gaps.size()) continue;
      const double around = beside(gaps, from, to);
      const auto first = gaps.begin() + static_cast<std::ptrdiff_t>(from);
      const double largest = *std::max_element(first, first + static_cast<std::ptrdiff_t>(run));
      if (!(largest * kFactor <= around)) continue;
      for (std::size_t s = from; s < to; ++s) tell(s, around);
      taken = run;
    }
    from += std::max<std::size_t>(taken, 1);
  }
  return warnings;
}

}  // namespace tetloft
