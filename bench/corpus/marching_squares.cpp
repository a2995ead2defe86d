#include "corpus/marching_squares.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace tetloft::bench {

namespace {

// A grid edge that a contour crosses: from sample `in` to its neighbour `out`.
using Crossing = std::pair<std::size_t, std::size_t>;

}  // namespace

// Each cell gives contour edges with inside to the left; following them closes the contours.
MaskedSection marching_squares(const float* value, std::size_t nx, std::size_t ny,
                               Contouring contouring) {
  std::map<Crossing, Crossing> next;
  for (std::size_t y = 0; y + 1 < ny; ++y) {
    for (std::size_t x = 0; x + 1 < nx; ++x) {
      // Corners counter-clockwise.
      const std::array<std::size_t, 4> corner{y * nx + x, y * nx + x + 1, (y + 1) * nx + x + 1,
                                              (y + 1) * nx + x};
      const auto inside = [&](std::size_t k) { return value[corner[k % 4]] < 0; };
      // A run of inside corners from k to m is bounded by the way from the grid edge after m to
      // the one before k.
      for (std::size_t k = 0; k < 4; ++k) {
        if (!inside(k) || inside(k + 3)) continue;
        std::size_t m = k;
        while (inside(m + 1)) ++m;
        next[{corner[m % 4], corner[(m + 1) % 4]}] = {corner[k], corner[(k + 3) % 4]};
      }
    }
  }
  const auto point = [&](const Crossing& c) {
    const auto x = [&](std::size_t k) { return static_cast<double>(k % nx); };
    const auto y = [&](std::size_t k) { return static_cast<double>(k / nx); };
    double t = 0.5;
    if (contouring == Contouring::smooth) {
      const double a = -static_cast<double>(value[c.first]);
      const double b = static_cast<double>(value[c.second]);
      // Not in the samples themselves, where contours could touch.
      t = std::clamp(a / (a + b), 0x1p-6, 1 - 0x1p-6);
    }
    return Point2{x(c.first) + t * (x(c.second) - x(c.first)),
                  y(c.first) + t * (y(c.second) - y(c.first))};
  };
  MaskedSection result;
  while (!next.empty()) {
    Contour contour;
    const Crossing start = next.begin()->first;
    Crossing at = start;
    do {
      contour.vertices.push_back(point(at));
      const auto found = next.find(at);
      at = found->second;
      next.erase(found);
    } while (at != start);
    result.section.contours.push_back(std::move(contour));
    result.sample.push_back(start.first);
  }
  return result;
}

}  // namespace tetloft::bench
