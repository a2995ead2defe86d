// From the highest region down: the border of a union is the symmetric difference of the borders.
#include "io/drawing/bands.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

struct Edge {
  Point2 a, b;  // a before b in canonical order
  friend bool operator==(const Edge&, const Edge&) = default;
};
bool operator<(const Edge& e, const Edge& f) {
  return std::tuple(e.a.x, e.a.y, e.b.x, e.b.y) < std::tuple(f.a.x, f.a.y, f.b.x, f.b.y);
}
using Edges = std::vector<Edge>;  // sorted, each once

Edges parity_of(const std::vector<const DrawnLine*>& rings) {
  Edges all;
  for (const DrawnLine* ring : rings) {
    const std::vector<Point3>& points = ring->points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point3& p = points[i];
      const Point3& q = points[i + 1 == points.size() ? 0 : i + 1];
      Edge edge{{p.x, p.y}, {q.x, q.y}};
      if (edge.a == edge.b) continue;
      if (std::tuple(edge.b.x, edge.b.y) < std::tuple(edge.a.x, edge.a.y))
        std::swap(edge.a, edge.b);
      all.push_back(edge);
    }
  }
  std::sort(all.begin(), all.end());
  Edges odd;
  for (const Edge& edge : all) {
    if (!odd.empty() && odd.back() == edge) {
      odd.pop_back();
    } else {
      odd.push_back(edge);
    }
  }
  return odd;
}

// Edges of which an even number meets at each point, as closed lines: each goes on by the first
// edge that is left.
class LoopTracer {
 public:
  explicit LoopTracer(const Edges& edges) : edges_(edges), used_(edges.size(), false) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      at_.push_back({edges[e].a, e});
      at_.push_back({edges[e].b, e});
    }
    std::sort(at_.begin(), at_.end(), [](const End& s, const End& t) {
      return std::tuple(s.at.x, s.at.y, s.edge) < std::tuple(t.at.x, t.at.y, t.edge);
    });
    passed_.resize(at_.size(), 0);
  }

  std::vector<std::vector<Point2>> trace() {
    std::vector<std::vector<Point2>> loops;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!used_[e]) loops.push_back(loop_from(e));
    }
    return loops;
  }

 private:
  struct End {
    Point2 at;
    std::size_t edge;
  };

  std::vector<Point2> loop_from(std::size_t e) {
    std::vector<Point2> loop{edges_[e].a};
    used_[e] = true;
    for (Point2 here = edges_[e].b; !(here == loop.front());) {
      loop.push_back(here);
      const std::size_t next = next_at(here);
      used_[next] = true;
      here = edges_[next].a == here ? edges_[next].b : edges_[next].a;
    }
    return loop;
  }

  std::size_t next_at(const Point2& p) {
    const auto end = std::lower_bound(at_.begin(), at_.end(), p, [](const End& s, const Point2& q) {
      return std::tuple(s.at.x, s.at.y) < std::tuple(q.x, q.y);
    });
    const auto first = static_cast<std::size_t>(end - at_.begin());
    std::size_t& passed = passed_[first];
    while (used_[at_[first + passed].edge]) ++passed;
    return at_[first + passed].edge;
  }

  const Edges& edges_;
  std::vector<bool> used_;
  std::vector<End> at_;
  std::vector<std::size_t> passed_;  // by the first end at a point: how many there are used up
};

// Whether what the lowest band begins at is far below the next.
bool is_far_below(const std::map<double, std::vector<const DrawnLine*>>& bands) {
  if (bands.size() < 3) return false;
  double widest = 0;
  auto below = std::next(bands.begin());
  const double first = below->first - bands.begin()->first;
  for (auto band = std::next(below); band != bands.end(); below = band++) {
    widest = std::max(widest, band->first - below->first);
  }
  return first > widest;
}

}  // namespace

Result<void> unite_bands(std::vector<DrawnLine>& lines, std::vector<Warning>& warnings) {
  std::map<double, std::vector<const DrawnLine*>> bands;
  std::vector<DrawnLine> result;
  std::size_t budget = 64;
  for (DrawnLine& line : lines) {
    if (line.kind != LineKind::closed || line.left_out || line.points.size() < 3) {
      result.push_back(std::move(line));
      line.points = {};
      continue;
    }
    bands[line.points.front().z].push_back(&line);
    budget += kBandMultiple * line.points.size();
  }
  const bool drops = is_far_below(bands);
  if (drops) {
    std::string message = "the lowest band begins at ";
    append_number(message, bands.begin()->first);
    message += ", farther below the next (";
    append_number(message, std::next(bands.begin())->first);
    message += ") than any others are apart: no level line, left out";
    warnings.push_back({std::move(message), {}});
  }
  Edges above;
  for (auto band = bands.rbegin(); band != bands.rend(); ++band) {
    if (drops && std::next(band) == bands.rend()) break;
    const Edges here = parity_of(band->second);
    Edges both;
    std::set_symmetric_difference(above.begin(), above.end(), here.begin(), here.end(),
                                  std::back_inserter(both));
    above = std::move(both);
    if (above.size() > budget) {
      return Error{ErrorCode::invalid_input,
                   "the bands have hardly a border in common: their unions would have more than " +
                       std::to_string(kBandMultiple) + " times as many points as they have",
                   {}};
    }
    budget -= above.size();
    for (const std::vector<Point2>& loop : LoopTracer(above).trace()) {
      DrawnLine line;
      line.line = band->second.front()->line;
      line.points.reserve(loop.size());
      for (const Point2& p : loop) line.points.push_back({p.x, p.y, band->first});
      result.push_back(std::move(line));
    }
  }
  lines = std::move(result);
  return {};
}

}  // namespace tetloft::internal::io
