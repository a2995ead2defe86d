// The table of cases.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "measure.hpp"

namespace tetloft::bench {

struct Case {
  std::string name;
  std::string what;
  /// Points in all, and who runs. Makes the input, which lives as long as the runners.
  struct Field {
    std::size_t points = 0;
    std::vector<Contestant> own;
    std::vector<Contestant> peers;
  };
  std::function<Field(const std::vector<Peer>& peers)> make;
  std::string distribution{};  ///< of plots; empty: on none
};

/// One or more sets of points, each triangulated by itself, times added.
template <class Point>
using Sets = std::shared_ptr<const std::vector<std::vector<Point>>>;

/// Runs it on all sets.
template <class Point>
[[nodiscard]] Runner over_all(Sets<Point> sets, std::function<Run(std::span<const Point>)> run) {
  return [sets = std::move(sets), run = std::move(run)] {
    Run sum;
    for (const std::vector<Point>& set : *sets) {
      const Run one = run(set);
      sum.seconds += one.seconds;
      sum.simplices += one.simplices;
      sum.steps.insert(sum.steps.end(), one.steps.begin(), one.steps.end());
    }
    return sum;
  };
}

/// "1M", "20k", "123".
[[nodiscard]] std::string size_name(std::size_t n);

/// Why the peer does not run; empty: it does.
[[nodiscard]] std::string left_out(const Peer& peer, std::size_t points);

/// All cases but those by distribution and the dynamic ones; each file of `stacks` is one more.
[[nodiscard]] std::vector<Case> all_cases(const std::vector<std::string>& stacks);

}  // namespace tetloft::bench
