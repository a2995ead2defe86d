#include "delaunay2/start.hpp"

#include <algorithm>

#include <tetloft/predicates.hpp>

#include "delaunay2/spatial_order.hpp"
#include "predicates/plane_filter.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

/// Brings three points that are not collinear to the front of the order, counter-clockwise;
/// returns false if there are none. The first point stays first.
bool bring_triangle_to_front(std::span<const Point2> points, std::vector<std::uint32_t>& order) {
  const auto at = [&](std::size_t i) -> const Point2& { return points[order[i]]; };
  std::size_t second = 1;
  while (second < order.size() && at(second) == at(0)) ++second;
  std::size_t third = second + 1;
  Sign turn = Sign::zero;
  for (; third < order.size(); ++third) {
    turn = orient2d(at(0), at(second), at(third));
    if (turn != Sign::zero) break;
  }
  if (third >= order.size()) return false;
  // Rotating instead of swapping keeps the spatial order, and of duplicates the lowest first.
  const auto begin = order.begin();
  const auto offset = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
  std::rotate(offset(1), offset(second), offset(second + 1));
  std::rotate(offset(2), offset(third), offset(third + 1));
  if (turn == Sign::negative) std::swap(order[1], order[2]);
  return true;
}

}  // namespace

Start triangulate(std::span<const Point2> points, WatchedWork& work) {
  Start start;
  std::vector<std::uint32_t> order = insertion_order(points);
  if (!bring_triangle_to_front(points, order)) return start;
  // Reading the points out of order is done here, many at a time, not between insertions.
  std::vector<Point2> ordered(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) ordered[i] = points[order[i]];
  start.plane.emplace(ordered[0], ordered[1], ordered[2], points.size(),
                      predicates::PlaneFilter(points));
  start.input_of.push_back({});
  start.input_of.reserve(points.size() + 1);
  start.site_of.resize(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const SiteId v = i < 3 ? SiteId(i + 1) : start.plane->insert_nearby(ordered[i]);
    if (v.index() == start.input_of.size()) start.input_of.push_back(PlaneVertexId(order[i]));
    start.site_of[PlaneVertexId(order[i])] = v;
    if ((i + 1) % kPointsOfStep == 0) work.step_done_go_on();
  }
  return start;
}

}  // namespace tetloft::internal::delaunay2_detail
