#include "between/cheapest_paths.hpp"

#include <algorithm>
#include <queue>
#include <utility>

#include "core/union_find.hpp"

namespace tetloft::internal::between {

SampleSteps straight_steps(const motion::LatticeWindow& window) {
  const auto nx = static_cast<std::int64_t>(window.nx());
  return {1, -1, nx, -nx};
}

SampleSteps steps_with_diagonals(const motion::LatticeWindow& window) {
  const auto nx = static_cast<std::int64_t>(window.nx());
  return {1, -1, nx, -nx, nx + 1, nx - 1, -nx + 1, -nx - 1};
}

PathSearch::PathSearch(std::size_t places, SampleSteps steps, SamplePassage may_pass)
    : steps_(std::move(steps)),
      may_pass_(std::move(may_pass)),
      distance_(places, kNever),
      from_(places, 0),
      front_(places, 0),
      settled_(places, 0) {}

void PathSearch::clear() {
  for (const std::uint32_t place : touched_) {
    distance_[place] = kNever;
    settled_[place] = 0;
  }
  touched_.clear();
  waiting_.clear();
}

void PathSearch::start(const std::vector<std::uint32_t>& source, std::uint32_t front) {
  for (const std::uint32_t place : source) {
    distance_[place] = 0;
    from_[place] = place;
    front_[place] = front;
    settled_[place] = 1;
    touched_.push_back(place);
  }
}

template <class Meet>
void PathSearch::step_on(std::uint32_t place, const SampleCost& cost, const Meet& meet) {
  for (const std::int64_t step : steps_) {
    const auto next = static_cast<std::uint32_t>(std::int64_t{place} + step);
    // Most places of large sources have none but others of theirs around them.
    const bool settled = next < settled_.size() && settled_[next] != 0;
    if (settled && front_[next] == front_[place]) continue;
    if (may_pass_ && !may_pass_(place, next)) continue;
    if (settled) {
      meet(next);
      continue;
    }
    const double on = cost(next);
    if (on == kNever || !(distance_[place] + on < distance_[next])) continue;
    if (distance_[next] == kNever) touched_.push_back(next);
    distance_[next] = distance_[place] + on;
    from_[next] = place;
    front_[next] = front_[place];
    waiting_.push_back({distance_[next], next});
    std::push_heap(waiting_.begin(), waiting_.end(), std::greater<>());
  }
}

std::optional<std::uint32_t> PathSearch::settle_next() {
  while (!waiting_.empty()) {
    const std::uint32_t place = waiting_.front().place;
    std::pop_heap(waiting_.begin(), waiting_.end(), std::greater<>());
    waiting_.pop_back();
    if (settled_[place] != 0) continue;
    settled_[place] = 1;
    return place;
  }
  return std::nullopt;
}

void PathSearch::append_way_back(std::uint32_t place, SamplePath& path) const {
  for (path.push_back(place); from_[place] != place;) path.push_back(place = from_[place]);
}

std::vector<SamplePath> PathSearch::join(const std::vector<std::vector<std::uint32_t>>& sources,
                                         const SampleCost& cost) {
  clear();
  for (std::uint32_t s = 0; s < sources.size(); ++s) start(sources[s], s);
  std::vector<SamplePath> paths;
  UnionFind joined(sources.size());
  std::priority_queue<Meeting, std::vector<Meeting>, std::greater<>> meetings;
  const auto go_on = [&](std::uint32_t place) {
    step_on(place, cost, [&](std::uint32_t other) {
      meetings.push({distance_[place] + distance_[other], place, other});
    });
  };
  // Meetings found later cost at least as much as the nearest place that is not settled.
  const auto take_meetings = [&](double limit) {
    for (; !meetings.empty() && meetings.top().cost <= limit; meetings.pop()) {
      const Meeting& meeting = meetings.top();
      if (!joined.unite(front_[meeting.from], front_[meeting.to])) continue;
      SamplePath& path = paths.emplace_back();
      append_way_back(meeting.from, path);
      std::reverse(path.begin(), path.end());
      append_way_back(meeting.to, path);
    }
  };
  for (const std::vector<std::uint32_t>& source : sources) {
    for (const std::uint32_t place : source) go_on(place);
  }
  while (paths.size() + 1 < sources.size()) {
    const std::optional<std::uint32_t> place = settle_next();
    take_meetings(place ? distance_[*place] : kNever);
    if (!place) break;
    go_on(*place);
  }
  return paths;
}

std::optional<SamplePath> PathSearch::reach(const std::vector<std::uint32_t>& sources,
                                            const std::function<bool(std::uint32_t)>& target,
                                            const SampleCost& cost) {
  clear();
  start(sources, 0);
  const auto one_front = [](std::uint32_t) {};
  for (const std::uint32_t place : sources) step_on(place, cost, one_front);
  while (const std::optional<std::uint32_t> place = settle_next()) {
    if (!target(*place)) {
      step_on(*place, cost, one_front);
      continue;
    }
    SamplePath path;
    append_way_back(*place, path);
    return path;
  }
  return std::nullopt;
}

}  // namespace tetloft::internal::between
