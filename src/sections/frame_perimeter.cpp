#include "sections/frame_perimeter.hpp"

#include <algorithm>
#include <utility>

namespace tetloft::internal::sections {

namespace {

// The corner at which a side begins.
Point2 corner(const Rectangle& frame, int side) {
  const bool right = side % 4 == 1 || side % 4 == 2;
  return {right ? frame.high.x : frame.low.x, side % 4 >= 2 ? frame.high.y : frame.low.y};
}

// The corners strictly between two positions, counter-clockwise.
std::vector<Point2> corners_between(const Rectangle& frame, const LineEnd& from, const LineEnd& to,
                                    const Point2& goal) {
  const bool around = to.at < from.at;
  const int last = to.at.side + (around ? 4 : 0);
  std::vector<Point2> corners;
  for (int side = from.at.side + 1; side <= last; ++side) {
    const Point2 p = corner(frame, side);
    if (!(p == goal)) corners.push_back(p);
  }
  return corners;
}

class Closer {
 public:
  Closer(const FramedSection& section, const Rectangle& frame, bool inside_before_corner)
      : section_(section), frame_(frame), shift_(inside_before_corner ? 1 : 0) {
    place_.resize(section.lines.size());
    for (std::size_t e = 0; e < section.ends.size(); ++e) {
      place_[section.ends[e].line][section.ends[e].last ? 1 : 0] = e;
    }
  }

  std::vector<FramedContour> close() {
    std::vector<FramedContour> contours;
    std::vector<bool> used(section_.lines.size(), false);
    for (std::size_t first = 0; first < section_.lines.size(); ++first) {
      if (used[first]) continue;
      FramedContour contour{{}, section_.lines[first].of};
      std::vector<Point2>& vertices = contour.contour.vertices;
      std::size_t start = place_[first][0];
      do {
        const std::size_t line = section_.ends[start].line;
        used[line] = true;
        append_line(vertices, start);
        const std::size_t end = place_[line][section_.ends[start].last ? 0 : 1];
        start = partner(end);
        append_corners(vertices, end, start);
      } while (start != place_[first][0]);
      contours.push_back(std::move(contour));
    }
    return contours;
  }

 private:
  [[nodiscard]] const Point2& point(std::size_t end) const {
    const LineEnd& e = section_.ends[end];
    const std::vector<Point2>& points = section_.lines[e.line].points;
    return e.last ? points.back() : points.front();
  }

  void append_line(std::vector<Point2>& vertices, std::size_t start) const {
    const LineEnd& e = section_.ends[start];
    const std::vector<Point2>& points = section_.lines[e.line].points;
    if (e.last) {
      vertices.insert(vertices.end(), points.rbegin(), points.rend());
    } else {
      vertices.insert(vertices.end(), points.begin(), points.end());
    }
  }

  // Whether the arc inside goes on from this end counter-clockwise.
  [[nodiscard]] bool leads(std::size_t end) const { return end % 2 == shift_; }

  // The other end of the arc inside.
  [[nodiscard]] std::size_t partner(std::size_t end) const {
    const std::size_t n = section_.ends.size();
    return leads(end) ? (end + 1) % n : (end + n - 1) % n;
  }

  void append_corners(std::vector<Point2>& vertices, std::size_t from, std::size_t to) const {
    const bool forward = leads(from);
    const std::size_t first = forward ? from : to;
    const std::size_t second = forward ? to : from;
    std::vector<Point2> corners =
        corners_between(frame_, section_.ends[first], section_.ends[second], point(second));
    if (!forward) std::reverse(corners.begin(), corners.end());
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }

  const FramedSection& section_;
  const Rectangle& frame_;
  std::size_t shift_;
  std::vector<std::array<std::size_t, 2>> place_;  // of each line's first and last point
};

bool on_one_side(const Rectangle& frame, const Point2& p, const Point2& q) {
  return (p.x == q.x && (p.x == frame.low.x || p.x == frame.high.x)) ||
         (p.y == q.y && (p.y == frame.low.y || p.y == frame.high.y));
}

}  // namespace

std::optional<FramePosition> position_on(const Rectangle& frame, const Point2& p) {
  const bool within =
      frame.low.x <= p.x && p.x <= frame.high.x && frame.low.y <= p.y && p.y <= frame.high.y;
  if (!within) return std::nullopt;
  if (p.y == frame.low.y && p.x != frame.high.x) return FramePosition{0, p.x};
  if (p.x == frame.high.x && p.y != frame.high.y) return FramePosition{1, p.y};
  if (p.y == frame.high.y && p.x != frame.low.x) return FramePosition{2, -p.x};
  if (p.x == frame.low.x) return FramePosition{3, -p.y};
  return std::nullopt;
}

void trim_along(const Rectangle& frame, std::vector<Point2>& line) {
  std::size_t first = 0;
  std::size_t end = line.size();
  while (first + 1 < end && on_one_side(frame, line[first], line[first + 1])) ++first;
  while (first + 1 < end && on_one_side(frame, line[end - 1], line[end - 2])) --end;
  if (first + 1 >= end) first = end = 0;
  line = {line.begin() + static_cast<std::ptrdiff_t>(first),
          line.begin() + static_cast<std::ptrdiff_t>(end)};
}

std::vector<FramedContour> closing(const FramedSection& section, const Rectangle& frame,
                                   bool inside_before_corner) {
  std::vector<FramedContour> contours = Closer(section, frame, inside_before_corner).close();
  contours.insert(contours.end(), section.closed.begin(), section.closed.end());
  std::stable_sort(contours.begin(), contours.end(),
                   [](const auto& a, const auto& b) { return a.of.index() < b.of.index(); });
  if (section.ends.empty() && inside_before_corner) {
    FramedContour whole;
    for (int side = 0; side < 4; ++side) whole.contour.vertices.push_back(corner(frame, side));
    contours.push_back(std::move(whole));
  }
  return contours;
}

}  // namespace tetloft::internal::sections
