// Stacks about what is not the solid: blocks with holes that end, drift, touch or hold islands.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "support/stacks/bitmap.hpp"
#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {
namespace {

// Covers [−5, 5]² at least.
Contour block(Prng& prng) {
  if (prng.chance(0.5)) return rectangle({-6, -6}, {6, 6}, number(prng, 1, 4));
  return regular_polygon({0, 0}, 8, number(prng, 8, 20), prng.between(0, 1));
}

// A rectangle with a notch of the given width and depth in its lower side.
Contour notched(double x, double width, double depth) {
  return {{{-6, -6},
           {x - width / 2, -6},
           {x - width / 2, -6 + depth},
           {x + width / 2, -6 + depth},
           {x + width / 2, -6},
           {6, -6},
           {6, 6},
           {-6, 6}}};
}

Contour moved(Contour contour, Point2 by) {
  for (Point2& p : contour.vertices) p = {p.x + by.x, p.y + by.y};
  return contour;
}

Contour box_at(int x, int y, int width, int height) {
  return rectangle({static_cast<double>(x), static_cast<double>(y)},
                   {static_cast<double>(x + width), static_cast<double>(y + height)});
}

// A square of pixels, set but for pores of a few pixels and notches of its sides.
Bitmap porous(Prng& prng, int size) {
  Bitmap bitmap(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) bitmap.set(x, y, true);
  }
  const std::size_t pores = number(prng, 1, 4);
  for (std::size_t k = 0; k < pores; ++k) {
    const int width = static_cast<int>(number(prng, 1, 2));
    const int height = static_cast<int>(number(prng, 1, 3));
    const bool notch = prng.chance(0.25);
    const auto at = [&](int extent) {
      return static_cast<int>(number(prng, 1, static_cast<std::size_t>(size - 1 - extent)));
    };
    const int x0 = at(width);
    const int y0 = notch ? 0 : at(height);
    for (int y = y0; y < y0 + height; ++y) {
      for (int x = x0; x < x0 + width; ++x) bitmap.set(x, y, false);
    }
  }
  return bitmap;
}

}  // namespace

SectionStack draft_pores(Prng& prng) {
  const std::vector<Disc> pores = pack_discs(prng, number(prng, 2, 6), 3.8, 0.3, 1.2, 0.2);
  const Contour outline = block(prng);
  std::vector<Layer> layers(number(prng, 2, 5));
  for (Layer& layer : layers) layer.push_back(outline);
  for (const Disc& pore : pores) {
    const std::size_t first = number(prng, 0, layers.size() - 1);
    const std::size_t end = std::min(layers.size(), first + number(prng, 1, 2));
    for (std::size_t i = first; i < end; ++i) {
      layers[i].push_back(blob_in(prng, pore, number(prng, 4, 12)));
    }
  }
  if (prng.chance(0.4)) {
    // A notch that ends above pores.
    layers[number(prng, 0, layers.size() - 1)].front() =
        notched(prng.between(-3, 3), prng.between(0.2, 1), prng.between(0.5, 1.2));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_hole_islands(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 3));
  const std::size_t n = number(prng, 4, 16);
  const double phase = prng.between(0, 1);
  const bool aside = prng.chance(0.5);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    layers[i].push_back(rectangle({-10, -10}, {10, 10}, number(prng, 1, 2)));
    // Beside each other from section to section, or over each other but for a little.
    const double x = aside ? (i % 2 == 0 ? -3.5 : 3.5) : prng.between(-1.5, 1.5);
    const double radius = aside ? prng.between(2, 3.4) : prng.between(2, 4);
    layers[i].push_back(regular_polygon({x, 0}, radius, n, phase));
    if (prng.chance(0.85)) {
      layers[i].push_back(
          regular_polygon({x, 0}, prng.between(0.2, 0.6) * radius, number(prng, 4, 10), 0));
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_channels(Prng& prng) {
  const std::size_t count = number(prng, 3, 5);
  const std::size_t tunnels = number(prng, 1, 2);
  std::vector<Layer> layers(count);
  const Contour outline = rectangle({-9, -6}, {9, 6}, number(prng, 1, 4));
  for (Layer& layer : layers) layer.push_back(outline);
  for (std::size_t tunnel = 0; tunnel < tunnels; ++tunnel) {
    const double radius = prng.between(0.4, 1);
    const double step = prng.between(0.3, 2.6) * radius * (prng.chance(0.5) ? 1 : -1);
    const double y = tunnels == 1 ? 0 : (tunnel == 0 ? -2.5 : 2.5);
    const std::size_t n = number(prng, 4, 14);
    const std::size_t first = number(prng, 0, 1);
    const std::size_t end = count - number(prng, 0, 1);
    const double middle = static_cast<double>(count - 1) / 2;
    for (std::size_t i = first; i < end; ++i) {
      const Point2 centre{step * (static_cast<double>(i) - middle), y};
      layers[i].push_back(regular_polygon(centre, radius, n, 0.2));
    }
  }
  return stack_of(layers, heights(prng, count));
}

SectionStack draft_open_pits(Prng& prng) {
  const std::vector<Disc> pits = pack_discs(prng, number(prng, 1, 4), 3.8, 0.4, 1.4, 0.3);
  Layer holed{block(prng)};
  for (const Disc& pit : pits) holed.push_back(blob_in(prng, pit, number(prng, 3, 12)));
  // What lies over it covers some of the pits, in whole or in part.
  const double side = prng.between(-4, 4);
  Layer partial{prng.chance(0.5) ? rectangle({-6, -6}, {side, 6}, number(prng, 1, 3))
                                 : blob(prng, {side, 0}, 1.5, 3, number(prng, 5, 14))};
  std::vector<Layer> layers;
  switch (number(prng, 0, 3)) {
    case 0: layers = {holed, partial}; break;
    case 1: layers = {partial, holed}; break;
    case 2: layers = {Layer{block(prng)}, holed, partial}; break;
    default: layers = {partial, holed, partial}; break;
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_touching_holes(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 3));
  int x = static_cast<int>(number(prng, 0, 4)) - 6;
  int y = static_cast<int>(number(prng, 0, 4)) - 4;
  int width = static_cast<int>(number(prng, 2, 3));
  int height = static_cast<int>(number(prng, 2, 3));
  for (Layer& layer : layers) {
    layer.push_back(rectangle({-12, -12}, {16, 12}, number(prng, 1, 3)));
    layer.push_back(box_at(x, y, width, height));
    // The next one shares an edge with it in projection, a piece of one, a vertex, or little area.
    switch (number(prng, 0, 3)) {
      case 0: x += width; break;
      case 1:
        x += width;
        y += 1;
        break;
      case 2:
        x += width;
        y += height;
        break;
      default: x += width - 1; break;
    }
    width = static_cast<int>(number(prng, 2, 3));
    height = static_cast<int>(number(prng, 2, 3));
    // A second hole, parted from it by a wall as wide as what the section between leaves.
    if (prng.chance(0.4)) layer.push_back(box_at(-9, -9, 2, static_cast<int>(number(prng, 1, 4))));
    if (prng.chance(0.4))
      layer.push_back(box_at(-7, -9 + static_cast<int>(number(prng, 0, 2)), 2, 2));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_rings(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 4));
  double radius = prng.between(3, 6);
  const std::size_t n = number(prng, 4, 24);
  const double phase = prng.between(0, 1);
  for (Layer& layer : layers) {
    const double wall = prng.between(0.05, 0.6);
    Layer ring{regular_polygon({0, 0}, radius, n, phase)};
    if (prng.chance(0.85)) ring.push_back(regular_polygon({0, 0}, radius - wall, n, phase));
    const Point2 by = displaced(prng, {0, 0}, 0.3);
    for (Contour& contour : ring) layer.push_back(moved(std::move(contour), by));
    radius += prng.between(-1.2, 1.2) * wall;
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_lattice_pores(Prng& prng) {
  const int size = static_cast<int>(number(prng, 5, 8));
  const bool stairs = prng.chance(0.5);
  const bool merge = prng.chance(0.5);
  const bool join = prng.chance(0.5);
  std::vector<Layer> layers(number(prng, 2, 4));
  for (Layer& layer : layers) {
    const Bitmap bitmap = porous(prng, size);
    layer = stairs ? staircase(without_diagonals(bitmap), merge) : marching_squares(bitmap, join);
  }
  return stack_of(layers, heights(prng, layers.size()));
}

}  // namespace tetloft::testing
