#include "motion/nearest_region.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace tetloft::internal::motion {

namespace {

// What lies farther past an end than this is left out. With M for it and u = 2⁻⁵³: where a sample
// is left out by an edge e, the next one, f, has its foot M / 2 past the end at least (lines are
// placed to some u · 2¹² only), and is M long. So it is nearer, in squares by M² / 4 = 2⁻¹⁸. The
// nearest edge of all is never left out; and squares are measured with errors below 2⁻²²:
// coordinates relative to an end are at most 2¹³, the foot is off by some 16 u of that, and the
// square by 2 · 2¹³ times as much; where the square of an edge's length vanishes, the foot is off
// by the edge at most. Hence what e would measure is no less than what the nearest edge does.
constexpr double kPast = 0x1p-8;
// Lines are never steeper: the difference is far below what matters.
constexpr double kSteepest = 0x1p-60;

double not_zero(double x) { return std::abs(x) < kSteepest ? kSteepest : x; }

}  // namespace

// Points p with (p − vertex) · direction ≤ kPast; everywhere for a direction that is none.
NearestRegion::HalfPlane NearestRegion::half_plane(const Point2& vertex, const Point2& direction) {
  const double length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  if (!(length >= kPast)) {
    const Line all{std::numeric_limits<double>::infinity(), 0, false};
    return {all, all};
  }
  const double x = not_zero(direction.x / length);
  const double y = not_zero(direction.y / length);
  const double limit = kPast + (x * vertex.x + y * vertex.y);
  return {{limit / x, -y / x, x < 0}, {limit / y, -x / y, y < 0}};
}

NearestRegion::NearestRegion(const LatticeEdges::Edge& e, const LatticeWindow& window)
    : columns_(window.i1 - window.i0), rows_(window.j1 - window.j0) {
  const Point2 origin{static_cast<double>(window.i0), static_cast<double>(window.j0)};
  const auto minus = [](const Point2& p, const Point2& q) { return Point2{p.x - q.x, p.y - q.y}; };
  const Point2 along = minus(e.b, e.a);
  const std::array<std::array<HalfPlane, 2>, 2> ends{
      {{half_plane(minus(e.a, origin), {-along.x, -along.y}),
        half_plane(minus(e.a, origin), minus(e.past_a, e.a))},
       {half_plane(minus(e.b, origin), along),
        half_plane(minus(e.b, origin), minus(e.past_b, e.b))}}};
  for (std::size_t end = 0; end < 2; ++end) {
    ends_[end] = {ends[end][0].along_y, ends[end][1].along_y};
    std::array<Line, 2> lines{ends[end][0].along_x, ends[end][1].along_x};
    if (lines[1].upwards && !lines[0].upwards) std::swap(lines[0], lines[1]);
    sides_[end] = lines[1].upwards ? Sides::above : lines[0].upwards ? Sides::either : Sides::below;
    for (std::size_t k = 0; k < 2; ++k) {
      cuts_.at_0[2 * end + k] = lines[k].at_0 + 1;
      cuts_.slope[2 * end + k] = lines[k].slope;
    }
  }
}

IndexRange NearestRegion::rows() const {
  IndexRange all{0, rows_};
  const auto last = static_cast<double>(columns_ - 1);
  for (const auto& end : ends_) {
    IndexRange of_end;
    for (const Line& line : end) {
      // A line is highest and lowest in the first or last column.
      of_end = of_end.joined(line.behind(0, rows_).joined(line.behind(last, rows_)));
    }
    all = all.common(of_end);
  }
  return all;
}

}  // namespace tetloft::internal::motion
