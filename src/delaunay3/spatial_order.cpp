// Hilbert indices by Skilling's transform ("Programming the Hilbert curve", AIP
// Conference Proceedings 707, 2004); rounds by independent draws.
#include "delaunay3/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/prng.hpp"

namespace tetloft::delaunay3_detail {

namespace {

// A sort key is the round (4 bits) above the Hilbert index (60 bits): 20 bits for each of
// three axes, 30 for each of two.
constexpr int kHilbertBits = 60;
constexpr std::uint64_t kLastRound = 15;
// A point leaves the last round for the one before with probability 1 / kRoundRatio, and
// so on; 8^15 exceeds any number of points, so round 0 needs no special case.
constexpr std::uint64_t kRoundRatio = 8;
constexpr std::uint64_t kSeed = 0x7E71'0F73'D000'0003ULL;

std::uint64_t draw_round(Prng& prng) {
  std::uint64_t draw = prng.next();
  std::uint64_t round = kLastRound;
  for (; round > 0 && draw % kRoundRatio == 0; --round) draw /= kRoundRatio;
  return round;
}

// Turns the coordinates of a cell into the transposed Hilbert index: bit b of the index's
// digit i is bit b of cell[i], highest bits first.
template <std::size_t Axes>
void transpose_hilbert(std::array<std::uint32_t, Axes>& cell, int bits) {
  const std::uint32_t top = std::uint32_t{1} << (bits - 1);
  for (std::uint32_t q = top; q > 1; q >>= 1) {
    const std::uint32_t below = q - 1;
    for (std::size_t i = 0; i < Axes; ++i) {
      if ((cell[i] & q) != 0) {
        cell[0] ^= below;
      } else {
        const std::uint32_t swapped = (cell[0] ^ cell[i]) & below;
        cell[0] ^= swapped;
        cell[i] ^= swapped;
      }
    }
  }
  for (std::size_t i = 1; i < Axes; ++i) cell[i] ^= cell[i - 1];
  std::uint32_t parity = 0;
  for (std::uint32_t q = top; q > 1; q >>= 1) {
    if ((cell[Axes - 1] & q) != 0) parity ^= q - 1;
  }
  for (std::uint32_t& coordinate : cell) coordinate ^= parity;
}

template <std::size_t Axes>
std::uint64_t interleave(const std::array<std::uint32_t, Axes>& cell, int bits) {
  std::uint64_t index = 0;
  for (int b = bits - 1; b >= 0; --b) {
    for (const std::uint32_t coordinate : cell) index = (index << 1) | ((coordinate >> b) & 1U);
  }
  return index;
}

// Maps coordinates to cells of a grid over the bounding cube (a square if Axes is 2).
class Grid {
 public:
  Grid(std::span<const Point3> points, std::size_t axes, int bits)
      : cells_(static_cast<double>((std::uint64_t{1} << bits) - 1)) {
    std::array<double, 3> high{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::array<double, 3> p = halved(points[i]);
      for (std::size_t k = 0; k < axes; ++k) {
        low_[k] = i == 0 ? p[k] : std::min(low_[k], p[k]);
        high[k] = i == 0 ? p[k] : std::max(high[k], p[k]);
      }
    }
    for (std::size_t k = 0; k < axes; ++k) extent_ = std::max(extent_, high[k] - low_[k]);
  }

  [[nodiscard]] std::uint32_t cell(const Point3& point, std::size_t axis) const {
    // Every point in one cell also where halving denormal coordinates left no extent.
    if (extent_ == 0) return 0;
    return static_cast<std::uint32_t>((halved(point)[axis] - low_[axis]) / extent_ * cells_);
  }

 private:
  // Halved, so that no difference of two coordinates overflows.
  static std::array<double, 3> halved(const Point3& p) { return {p.x / 2, p.y / 2, p.z / 2}; }

  double cells_;
  std::array<double, 3> low_{};
  double extent_ = 0;
};

// Whether at most two values of z occur. Then z is left out of the order: the Delaunay
// triangulation of two parallel planes does not depend on their distance, and visiting
// one plane after the other would fan all of it around few vertices of the other.
bool on_two_planes(std::span<const Point3> points) {
  const double low = points.front().z;
  const double high = points.back().z;
  const auto above = std::partition_point(points.begin(), points.end(),
                                          [&](const Point3& p) { return p.z == low; });
  return above == points.end() || above->z == high;
}

}  // namespace

std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, int bits) {
  std::array<std::uint32_t, 2> cell{x, y};
  transpose_hilbert(cell, bits);
  return interleave(cell, bits);
}

std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits) {
  std::array<std::uint32_t, 3> cell{x, y, z};
  transpose_hilbert(cell, bits);
  return interleave(cell, bits);
}

std::vector<std::uint32_t> insertion_order(std::span<const Point3> points) {
  if (points.empty()) return {};
  struct Keyed {
    std::uint64_t key;
    std::uint32_t place;
  };
  std::vector<Keyed> keyed(points.size());
  const bool flat = on_two_planes(points);
  const int bits = flat ? kHilbertBits / 2 : kHilbertBits / 3;
  const Grid grid(points, flat ? 2 : 3, bits);
  Prng prng(kSeed);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t x = grid.cell(points[i], 0);
    const std::uint32_t y = grid.cell(points[i], 1);
    const std::uint64_t index =
        flat ? hilbert_index(x, y, bits) : hilbert_index(x, y, grid.cell(points[i], 2), bits);
    keyed[i] = {(draw_round(prng) << kHilbertBits) | index, static_cast<std::uint32_t>(i)};
  }
  // Points of one cell follow canonical order.
  std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) {
    return a.key != b.key ? a.key < b.key : a.place < b.place;
  });
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].place;
  return order;
}

}  // namespace tetloft::delaunay3_detail
