// Stacks on lattices, and identical sections: everything cocircular and cospherical.
#include <algorithm>
#include <cmath>

#include "support/stacks/bitmap.hpp"
#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {
namespace {

// Bitmaps of a stack: each drawn anew, or the one below with some pixels flipped.
std::vector<Bitmap> bitmaps(Prng& prng) {
  const int width = static_cast<int>(number(prng, 3, 9));
  const int height = static_cast<int>(number(prng, 3, 9));
  const double density = prng.between(0.35, 0.65);
  const int smoothing = static_cast<int>(number(prng, 0, 2));
  const double flips = prng.chance(0.3) ? 1 : prng.between(0.02, 0.2);
  std::vector<Bitmap> result;
  const std::size_t n = number(prng, 2, 4);
  for (std::size_t i = 0; i < n; ++i) {
    const bool fresh = i == 0 || flips == 1;
    result.push_back(fresh ? random_bitmap(prng, width, height, density, smoothing)
                           : flipped(prng, result.back(), flips));
  }
  return result;
}

}  // namespace

SectionStack draft_lattice_marching_squares(Prng& prng) {
  const bool join = prng.chance(0.5);
  std::vector<Layer> layers;
  for (const Bitmap& bitmap : bitmaps(prng)) layers.push_back(marching_squares(bitmap, join));
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_lattice_staircase(Prng& prng) {
  const bool merge = prng.chance(0.5);
  std::vector<Layer> layers;
  for (const Bitmap& bitmap : bitmaps(prng)) {
    layers.push_back(staircase(without_diagonals(bitmap), merge));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_small_grid(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 3));
  for (Layer& layer : layers) {
    const std::size_t contours = number(prng, 1, 3);
    for (std::size_t c = 0; c < contours; ++c) {
      // Few grid points, taken by angle around one of the cell corners between them: simple
      // but for ties in angle, which validation finds.
      const Point2 centre{static_cast<double>(number(prng, 1, 7)) + 0.5,
                          static_cast<double>(number(prng, 1, 7)) + 0.5};
      const double reach = static_cast<double>(number(prng, 1, 4));
      Contour contour;
      const std::size_t n = number(prng, 3, 8);
      for (std::size_t i = 0; i < n; ++i) {
        const Point2 p = displaced(prng, centre, reach);
        contour.vertices.push_back(
            {std::clamp(std::round(p.x), 0.0, 8.0), std::clamp(std::round(p.y), 0.0, 8.0)});
      }
      std::sort(contour.vertices.begin(), contour.vertices.end(), [&](Point2 a, Point2 b) {
        const double of_a = std::atan2(a.y - centre.y, a.x - centre.x);
        const double of_b = std::atan2(b.y - centre.y, b.x - centre.x);
        return of_a != of_b ? of_a < of_b : canonical_less(a, b);
      });
      const auto last = std::unique(contour.vertices.begin(), contour.vertices.end());
      contour.vertices.erase(last, contour.vertices.end());
      layer.push_back(std::move(contour));
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_checkerboard(Prng& prng) {
  const std::size_t columns = number(prng, 1, 4);
  const std::size_t rows = number(prng, 1, 3);
  const double pitch = 2;
  const double side = prng.chance(0.5) ? 1 : prng.chance(0.5) ? 1.5 : 1.9375;
  const std::size_t per_side = number(prng, 1, 3);
  std::vector<Layer> layers(number(prng, 2, 4));
  for (Layer& layer : layers) {
    const double dx = static_cast<double>(number(prng, 0, 2));
    const double dy = static_cast<double>(number(prng, 0, 2));
    for (std::size_t i = 0; i < columns * rows; ++i) {
      const double x = dx + pitch * static_cast<double>(i % columns);
      const double y = dy + pitch * static_cast<double>(i / columns);
      layer.push_back(rectangle({x, y}, {x + side, y + side}, per_side));
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_identical_sections(Prng& prng) {
  Layer layer;
  double gap = 1;
  switch (number(prng, 0, 5)) {
    case 0: {
      const double side = static_cast<double>(number(prng, 1, 4));
      layer = {rectangle({0, 0}, {side, side}, number(prng, 1, 5))};
      gap = side;
      break;
    }
    case 1: layer = {regular_polygon({0, 0}, 1, number(prng, 3, 32), 0)}; break;
    case 2: {
      const std::size_t n = number(prng, 4, 16);
      layer = {regular_polygon({0, 0}, 2, n, 0), regular_polygon({0, 0}, 1, n, 0)};
      break;
    }
    case 3: {
      const std::size_t squares = number(prng, 2, 4);
      for (std::size_t i = 0; i < squares; ++i) {
        const double x = 2 * static_cast<double>(i);
        layer.push_back(rectangle({x, 0}, {x + 1, 1}, number(prng, 1, 2)));
      }
      break;
    }
    case 4: {
      const Bitmap bitmap = random_bitmap(prng, 5, 5, 0.6, 0);
      layer = staircase(without_diagonals(bitmap), prng.chance(0.5));
      break;
    }
    default: layer = {blob(prng, {0, 0}, 0.5, 2, number(prng, 3, 20))}; break;
  }
  std::vector<Layer> layers(number(prng, 2, 4), layer);
  std::vector<double> z;
  for (std::size_t i = 0; i < layers.size(); ++i) z.push_back(gap * static_cast<double>(i));
  return stack_of(layers, z);
}

SectionStack draft_complementary_sections(Prng& prng) {
  const int side = static_cast<int>(number(prng, 3, 7));
  const Bitmap bitmap = random_bitmap(prng, side, side, 0.5, static_cast<int>(number(prng, 0, 1)));
  Bitmap complement(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) complement.set(x, y, !bitmap.at(x, y));
  }
  // What joins pixels of the one parts those of the other: inner outlines are the same.
  const bool join = prng.chance(0.5);
  std::vector<Layer> layers(number(prng, 2, 3));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    layers[i] = i % 2 == 0 ? marching_squares(bitmap, join) : marching_squares(complement, !join);
  }
  return stack_of(layers, heights(prng, layers.size()));
}

}  // namespace tetloft::testing
