#include "between/cheapest_paths.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "core/union_find.hpp"

namespace tetloft::internal::between {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

PathSearch::PathSearch(const motion::LatticeWindow& window, Steps steps)
    : neighbour_count_(steps == Steps::straight ? 4 : 8),
      distance_(window.size(), kNever),
      from_(window.size(), 0),
      front_(window.size(), 0),
      settled_(window.size(), 0) {
  const auto nx = static_cast<std::int64_t>(window.nx());
  const std::int64_t all[8] = {1, -1, nx, -nx, nx + 1, nx - 1, -nx + 1, -nx - 1};
  std::copy(all, all + 8, neighbours_);
}

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

void PathSearch::step_on(std::uint32_t place, const SampleCost& cost) {
  for (std::size_t n = 0; n < neighbour_count_; ++n) {
    const auto next = static_cast<std::uint32_t>(std::int64_t{place} + neighbours_[n]);
    if (settled_[next] != 0) continue;
    const double distance = distance_[place] + cost(next);
    if (!(distance < distance_[next])) continue;
    if (distance_[next] == kNever) touched_.push_back(next);
    distance_[next] = distance;
    from_[next] = place;
    front_[next] = front_[place];
    waiting_.push_back({distance, next});
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
  for (; from_[place] != place; place = from_[place]) path.push_back(place);
}

std::vector<SamplePath> PathSearch::join(const std::vector<std::vector<std::uint32_t>>& sources,
                                         const SampleCost& cost) {
  clear();
  for (std::uint32_t s = 0; s < sources.size(); ++s) start(sources[s], s);
  for (const std::vector<std::uint32_t>& source : sources) {
    for (const std::uint32_t place : source) step_on(place, cost);
  }
  std::vector<SamplePath> paths;
  UnionFind joined(sources.size());
  std::priority_queue<Meeting, std::vector<Meeting>, std::greater<>> meetings;
  // Meetings found later cost at least as much as the nearest place that is not settled.
  const auto take_meetings = [&](double limit) {
    for (; !meetings.empty() && meetings.top().cost <= limit; meetings.pop()) {
      const Meeting& meeting = meetings.top();
      if (!joined.unite(front_[meeting.from], front_[meeting.to])) continue;
      append_way_back(meeting.from, paths.emplace_back());
      append_way_back(meeting.to, paths.back());
    }
  };
  while (paths.size() + 1 < sources.size()) {
    const std::optional<std::uint32_t> place = settle_next();
    take_meetings(place ? distance_[*place] : kNever);
    if (!place) break;
    for (std::size_t n = 0; n < neighbour_count_; ++n) {
      const auto other = static_cast<std::uint32_t>(std::int64_t{*place} + neighbours_[n]);
      if (settled_[other] != 0 && front_[other] != front_[*place]) {
        meetings.push({distance_[*place] + distance_[other], *place, other});
      }
    }
    step_on(*place, cost);
  }
  return paths;
}

std::optional<SamplePath> PathSearch::reach(const std::vector<std::uint32_t>& sources,
                                            const std::function<bool(std::uint32_t)>& target,
                                            const SampleCost& cost) {
  clear();
  start(sources, 0);
  for (const std::uint32_t place : sources) step_on(place, cost);
  while (const std::optional<std::uint32_t> place = settle_next()) {
    if (!target(*place)) {
      step_on(*place, cost);
      continue;
    }
    SamplePath path;
    append_way_back(from_[*place], path);
    return path;
  }
  return std::nullopt;
}

}  // namespace tetloft::internal::between
