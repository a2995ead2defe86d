#include "delaunay2/spatial_order.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/prng.hpp"
#include "spatial/hilbert.hpp"
#include "spatial/sort_by_key.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

/// 6 bits of round above 2 × 29 bits of place fill one 64-bit key. A grid of 2^29 cells per
/// side tells apart points whose spacing varies by far more than hand-drawn contours do.
constexpr int kGridBits = 29;
constexpr std::uint64_t kLastRound = 63;

struct Grid {
  double origin_x = std::numeric_limits<double>::infinity();
  double origin_y = std::numeric_limits<double>::infinity();
  double extent = 0;  // half the side

  // Halved coordinates, because the extent of finite points may not be finite.
  explicit Grid(std::span<const Point2> points) {
    double top_x = -origin_x;
    double top_y = -origin_y;
    for (const Point2& p : points) {
      origin_x = std::min(origin_x, 0.5 * p.x);
      origin_y = std::min(origin_y, 0.5 * p.y);
      top_x = std::max(top_x, 0.5 * p.x);
      top_y = std::max(top_y, 0.5 * p.y);
    }
    extent = std::max(top_x - origin_x, top_y - origin_y);
  }

  [[nodiscard]] std::uint64_t place(const Point2& p) const {
    return hilbert_index<2>({cell(0.5 * p.x - origin_x), cell(0.5 * p.y - origin_y)}, kGridBits);
  }

  [[nodiscard]] std::uint32_t cell(double offset) const {
    constexpr std::uint32_t side = std::uint32_t{1} << kGridBits;
    if (!(extent > 0)) return 0;
    return std::min(static_cast<std::uint32_t>(offset / extent * side), side - 1);
  }
};

/// Drawn from the bits of the point, so that equal points draw the same.
std::uint64_t draw_round(const Point2& p) {
  // Adding 0.0 turns -0.0 into 0.0, which is the same coordinate.
  const auto x = std::bit_cast<std::uint64_t>(p.x + 0.0);
  const auto y = std::bit_cast<std::uint64_t>(p.y + 0.0);
  const auto zeros = std::countr_zero(Prng(Prng(x).next() + y).next());
  return kLastRound - static_cast<std::uint64_t>(zeros / 2);
}

}  // namespace

std::vector<std::uint32_t> insertion_order(std::span<const Point2> points) {
  const Grid grid(points);
  std::vector<Keyed> places(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    places[i] = {draw_round(points[i]) << (2 * kGridBits) | grid.place(points[i]), i};
  }
  sort_by_key(places);
  std::vector<std::uint32_t> order(points.size());
  std::transform(places.begin(), places.end(), order.begin(),
                 [](const Keyed& entry) { return entry.place; });
  return order;
}

}  // namespace tetloft::internal::delaunay2_detail
