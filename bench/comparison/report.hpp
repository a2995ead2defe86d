// The tables of a comparison, and all of it as JSON.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparison/metrics.hpp"
#include "comparison/options.hpp"

namespace tetloft::bench {

/// A stack, without its contours, and what each method made of it.
struct Row {
  Subject subject;
  std::size_t sections = 0, contours = 0, vertices = 0;
  std::vector<Run> runs;
};

/// Runs by group and method, in order of first appearance.
struct Table {
  std::string title;  ///< what the groups are
  struct Line {
    std::string group, method;
    Aggregate aggregate;
  };
  std::vector<Line> lines;
};

/// Of the corpus by spacing, contouring and kind, and of the folders; without empty ones.
[[nodiscard]] std::vector<Table> tables_of(const std::vector<Row>& rows);

[[nodiscard]] std::string markdown_of(const std::vector<Table>& tables);
[[nodiscard]] std::string json_of(const CompareOptions& options, const std::vector<Row>& rows,
                                  const std::vector<Table>& tables);

}  // namespace tetloft::bench
