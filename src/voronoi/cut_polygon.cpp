#include "voronoi/cut_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetloft::internal::voronoi {

CutPolygon::CutPolygon(const Point2& low, const Point2& high)
    : lines_{{{-1, 0, 0}, -low.x}, {{1, 0, 0}, high.x}, {{0, -1, 0}, -low.y}, {{0, 1, 0}, high.y}} {
  corners_ = {{{low.x, low.y}, 0, 2},
              {{high.x, low.y}, 0, 1},
              {{high.x, high.y}, 0, 3},
              {{low.x, high.y}, 0, 0}};
  for (Corner& c : corners_) c.spread = std::max(std::abs(c.point.x), std::abs(c.point.y));
}

// On the edge, or where its line and the last one meet, whichever has the smaller error.
CutPolygon::Corner CutPolygon::crossing(std::size_t kept, std::size_t cut_off,
                                        std::uint32_t edge) const {
  const Corner& a = corners_[kept];
  const Corner& b = corners_[cut_off];
  const double below = std::min(height_[kept], 0.0), above = std::max(height_[cut_off], 0.0);
  const double share = above > below ? below / (below - above) : 0.5;
  Corner made;
  made.point = {a.point.x + share * (b.point.x - a.point.x),
                a.point.y + share * (b.point.y - a.point.y)};
  made.spread = std::max(a.spread, b.spread);

  const HalfSpace& f = lines_[edge];
  const HalfSpace& g = lines_.back();
  const double determinant = f.normal.x * g.normal.y - f.normal.y * g.normal.x;
  const Point2 met{(f.offset * g.normal.y - g.offset * f.normal.y) / determinant,
                   (g.offset * f.normal.x - f.offset * g.normal.x) / determinant};
  const double spread = (std::max(std::abs(f.offset), std::abs(g.offset)) +
                         std::max(std::abs(met.x), std::abs(met.y))) /
                        std::abs(determinant);
  if (spread < made.spread) {  // false for no number
    made.point = met;
    made.spread = spread;
  }
  return made;
}

void CutPolygon::cut(const HalfSpace& half_space) {
  lines_.push_back(half_space);
  const std::size_t n = corners_.size();
  if (n == 0) return;
  height_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point2& p = corners_[i].point;
    height_[i] = half_space.normal.x * p.x + half_space.normal.y * p.y - half_space.offset;
  }
  const auto at = [&](auto place) { return static_cast<std::size_t>(place - height_.begin()); };
  const std::size_t highest = at(std::max_element(height_.begin(), height_.end()));
  const std::size_t lowest = at(std::min_element(height_.begin(), height_.end()));
  if (height_[highest] <= 0) return;
  if (height_[lowest] > 0) {
    corners_.clear();
    return;
  }
  // The run that is cut off, around the highest corner.
  std::size_t first = highest, last = highest;
  while (height_[(first + n - 1) % n] > 0) first = (first + n - 1) % n;
  while (height_[(last + 1) % n] > 0) last = (last + 1) % n;
  const std::size_t before = (first + n - 1) % n, after = (last + 1) % n;
  std::vector<Corner> kept{crossing(before, first, corners_[before].edge),
                           crossing(after, last, corners_[last].edge)};
  kept[0].edge = static_cast<std::uint32_t>(lines_.size() - 1);
  kept[1].edge = corners_[last].edge;
  for (std::size_t i = after; i != first; i = (i + 1) % n) kept.push_back(corners_[i]);
  corners_ = std::move(kept);
}

bool CutPolygon::reaches_box() const {
  return std::any_of(corners_.begin(), corners_.end(),
                     [](const Corner& c) { return c.edge < kSides; });
}

double CutPolygon::area() const {
  double twice = 0;
  for (std::size_t i = 2; i < corners_.size(); ++i) {
    const Point2 &o = corners_[0].point, &a = corners_[i - 1].point, &b = corners_[i].point;
    twice += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return std::max(0.0, 0.5 * twice);
}

}  // namespace tetloft::internal::voronoi
