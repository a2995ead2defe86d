#include "support/stacks/height_fields.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using Node = std::size_t;                   // a lattice point
using LatticeEdge = std::pair<Node, Node>;  // the lower number first

Point2 place_of(const HeightField& field, Node n) {
  return {static_cast<double>(n % field.columns), static_cast<double>(n / field.columns)};
}

LatticeEdge edge_of(Node a, Node b) { return {std::min(a, b), std::max(a, b)}; }

// Where a level crosses an edge: computed from its lower end, so that both triangles agree.
Point2 crossing(const HeightField& field, const LatticeEdge& edge, double level) {
  const Point2 p = place_of(field, edge.first);
  const Point2 q = place_of(field, edge.second);
  const double from = field.height[edge.first];
  const double t = (level - from) / (field.height[edge.second] - from);
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

template <class Take>
void for_each_triangle(const HeightField& field, Take&& take) {
  for (std::size_t j = 0; j + 1 < field.rows; ++j) {
    for (std::size_t i = 0; i + 1 < field.columns; ++i) {
      const Node a = j * field.columns + i;
      const Node b = a + 1;
      const Node c = a + field.columns;
      const Node d = c + 1;
      // Counter-clockwise; diagonals by turns, as of no grid in particular.
      if ((i + j) % 2 == 0) {
        take(std::array<Node, 3>{a, b, d});
        take(std::array<Node, 3>{a, d, c});
      } else {
        take(std::array<Node, 3>{a, b, c});
        take(std::array<Node, 3>{b, d, c});
      }
    }
  }
}

struct Line {
  std::vector<Point2> points;
  bool open = false;
};

// Edges that a level crosses, and which follow each other across a triangle.
using Followers = std::map<LatticeEdge, std::vector<LatticeEdge>>;

Followers followers_of(const HeightField& field, double level) {
  Followers followers;
  for_each_triangle(field, [&](const std::array<Node, 3>& nodes) {
    std::vector<LatticeEdge> crossed;
    for (std::size_t k = 0; k < 3; ++k) {
      const Node a = nodes[k];
      const Node b = nodes[(k + 1) % 3];
      if ((field.height[a] < level) != (field.height[b] < level)) crossed.push_back(edge_of(a, b));
    }
    if (crossed.size() != 2) return;
    followers[crossed[0]].push_back(crossed[1]);
    followers[crossed[1]].push_back(crossed[0]);
  });
  return followers;
}

std::vector<Line> lines_at(const HeightField& field, double level) {
  Followers left = followers_of(field, level);
  const auto walk = [&](LatticeEdge from) {
    std::vector<Point2> points;
    for (LatticeEdge at = from;;) {
      points.push_back(crossing(field, at, level));
      std::vector<LatticeEdge>& next = left[at];
      if (next.empty()) break;
      const LatticeEdge to = next.back();
      next.pop_back();
      std::erase(left[to], at);
      at = to;
    }
    return points;
  };
  std::vector<Line> lines;
  for (const auto& [edge, next] : followers_of(field, level)) {
    if (next.size() == 1 && left[edge].size() == 1) lines.push_back({walk(edge), true});
  }
  for (const auto& [edge, next] : followers_of(field, level)) {
    if (left[edge].size() != 2) continue;
    lines.push_back({walk(edge), false});
    lines.back().points.pop_back();
  }
  return lines;
}

}  // namespace

HeightField random_field(Prng& prng) {
  HeightField field;
  field.columns = number(prng, 3, 10);
  field.rows = number(prng, 3, 10);
  const double slope_x = prng.between(-1, 1);
  const double slope_y = prng.between(-1, 1);
  struct Hill {
    Point2 at;
    double height, width;
  };
  std::vector<Hill> hills(number(prng, 0, 5));
  for (Hill& hill : hills) {
    hill = {{prng.between(0, 10), prng.between(0, 10)}, prng.between(-8, 8), prng.between(1, 9)};
  }
  for (std::size_t j = 0; j < field.rows; ++j) {
    for (std::size_t i = 0; i < field.columns; ++i) {
      const auto x = static_cast<double>(i);
      const auto y = static_cast<double>(j);
      double height = slope_x * x + slope_y * y + prng.between(-0.5, 0.5);
      for (const Hill& hill : hills) {
        const double dx = x - hill.at.x;
        const double dy = y - hill.at.y;
        height += hill.height / (1 + (dx * dx + dy * dy) / hill.width);
      }
      field.height.push_back(height);
    }
  }
  return field;
}

LevelLines level_lines(Prng& prng, const HeightField& field) {
  const auto [low, high] = std::minmax_element(field.height.begin(), field.height.end());
  std::vector<double> levels(number(prng, 2, 5));
  for (double& level : levels) {
    do {
      level = prng.between(*low, *high);
    } while (std::find(field.height.begin(), field.height.end(), level) != field.height.end());
  }
  std::sort(levels.begin(), levels.end());
  LevelLines result;
  for (const double level : levels) {
    const SectionId s = result.stack.sections.push_back({level, {}});
    std::vector<Line> lines = lines_at(field, level);
    prng.shuffle(lines);
    for (Line& line : lines) {
      if (prng.chance(0.5)) std::reverse(line.points.begin(), line.points.end());
      const ContourId c = result.stack.sections[s].contours.push_back({std::move(line.points)});
      if (line.open) result.open.push_back({s, c});
    }
  }
  return result;
}

double area_above(const HeightField& field, double level) {
  double sum = 0;
  for_each_triangle(field, [&](const std::array<Node, 3>& nodes) {
    std::vector<Point2> part;
    for (std::size_t k = 0; k < 3; ++k) {
      const Node a = nodes[k];
      const Node b = nodes[(k + 1) % 3];
      if (field.height[a] >= level) part.push_back(place_of(field, a));
      if ((field.height[a] < level) != (field.height[b] < level)) {
        part.push_back(crossing(field, edge_of(a, b), level));
      }
    }
    for (std::size_t k = 1; k + 1 < part.size(); ++k) {
      sum += ((part[k].x - part[0].x) * (part[k + 1].y - part[0].y) -
              (part[k].y - part[0].y) * (part[k + 1].x - part[0].x)) /
             2;
    }
  });
  return sum;
}

SectionStack draft_height_fields(Prng& prng) {
  const HeightField field = random_field(prng);
  const LevelLines lines = level_lines(prng, field);
  FrameOptions options;
  options.corners = {Point2{0, 0}, Point2{field.width(), field.height_of_frame()}};
  Result<ClosedOnFrame> closed = close_on_frame(lines.stack, lines.open, options);
  return closed ? std::move(closed->stack) : SectionStack();
}

}  // namespace tetloft::testing
