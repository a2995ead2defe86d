// What was measured, as text, JSON and Markdown.
#pragma once

#include <string>
#include <vector>

#include "measure.hpp"
#include "predicates.hpp"

namespace tetloft::bench {

struct CaseReport {
  std::string name;
  std::string what;
  std::size_t points = 0;
  std::vector<Measurement> own;
  std::vector<Measurement> peers;
  std::string distribution{};  ///< of plots; empty: on none
};

struct Report {
  int rounds = 0;
  double limit = 0;
  std::vector<std::string> versions;
  std::vector<CaseReport> cases;
  std::vector<PredicateTime> predicates;
};

[[nodiscard]] std::string text_of(const CaseReport& report);
[[nodiscard]] std::string text_of(const std::vector<PredicateTime>& times);
[[nodiscard]] std::string json_of(const Report& report);
/// The cases by distribution in one table, a column for each contestant. A row for each contestant
/// of all others, steps and stages below, and a table of predicates.
[[nodiscard]] std::string markdown_of(const Report& report);

}  // namespace tetloft::bench
