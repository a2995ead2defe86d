// Cheapest paths over samples (Dijkstra, Numerische Mathematik 1, 1959), no farther than it takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

/// A step costs this, and the square of how far outside it is; kNever where no path may go. What a
/// path makes solid gets kPathValue.
inline constexpr double kStepCost = 0.1;
inline constexpr double kNever = std::numeric_limits<double>::infinity();
inline constexpr double kPathValue = -0.5;

/// What it costs to step on the sample at this place; infinite where no path may go.
using SampleCost = std::function<double(std::uint32_t)>;
/// May paths step from one place to another?
using SamplePassage = std::function<bool(std::uint32_t, std::uint32_t)>;
/// Places.
using SamplePath = std::vector<std::uint32_t>;

/// By how much places of samples differ that are one step apart.
using SampleSteps = std::vector<std::int64_t>;
[[nodiscard]] SampleSteps straight_steps(const motion::LatticeWindow& window);
[[nodiscard]] SampleSteps steps_with_diagonals(const motion::LatticeWindow& window);

class PathSearch {
 public:
  /// Of places 0 … places − 1. What is stepped on from a source has a cost, and those of cost not
  /// infinite lead to places only.
  PathSearch(std::size_t places, SampleSteps steps, SamplePassage may_pass = {});

  /// Paths that join the sources, each a set of places, to as few sets as can be, by the least tree
  /// (Kruskal, Proc. AMS 7, 1956) of the paths where fronts from two sources meet. Each runs
  /// from one source to another, with a place of either at its ends.
  [[nodiscard]] std::vector<SamplePath> join(const std::vector<std::vector<std::uint32_t>>& sources,
                                             const SampleCost& cost);

  /// The path to the nearest target from the sources, with a place of either at its ends; none if
  /// there is no way.
  [[nodiscard]] std::optional<SamplePath> reach(const std::vector<std::uint32_t>& sources,
                                                const std::function<bool(std::uint32_t)>& target,
                                                const SampleCost& cost);

 private:
  struct Waiting {
    double distance;
    std::uint32_t place;
    friend bool operator>(const Waiting& a, const Waiting& b) {
      return a.distance != b.distance ? a.distance > b.distance : a.place > b.place;
    }
  };
  /// Where two fronts meet.
  struct Meeting {
    double cost;
    std::uint32_t from, to;
    friend bool operator>(const Meeting& a, const Meeting& b) {
      if (a.cost != b.cost) return a.cost > b.cost;
      return a.from != b.from ? a.from > b.from : a.to > b.to;
    }
  };

  void clear();
  void start(const std::vector<std::uint32_t>& source, std::uint32_t front);
  /// Steps on from a settled place; calls meet(place) for settled ones beside it of another front.
  template <class Meet>
  void step_on(std::uint32_t place, const SampleCost& cost, const Meet& meet);
  /// The nearest place not settled yet, and settles it; none if all are.
  [[nodiscard]] std::optional<std::uint32_t> settle_next();
  /// Appends the places from here back to the source.
  void append_way_back(std::uint32_t place, SamplePath& path) const;

  SampleSteps steps_;
  SamplePassage may_pass_;        // or everywhere
  std::vector<double> distance_;  // by place
  std::vector<std::uint32_t> from_, front_;
  std::vector<std::uint8_t> settled_;
  std::vector<std::uint32_t> touched_;
  std::vector<Waiting> waiting_;  // a heap
};

}  // namespace tetloft::internal::between
