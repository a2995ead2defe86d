// Stacks of shapes that overlap in awkward ways: stars, combs, horseshoes, bars, drift.
#include <algorithm>
#include <cmath>

#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

SectionStack draft_stars_combs(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 4));
  for (Layer& layer : layers) {
    switch (number(prng, 0, 3)) {
      case 0:
        layer = {spiky({0, 0}, prng.between(0.5, 2), 6, number(prng, 3, 9), prng.between(0, 6))};
        break;
      case 1: {
        const std::size_t teeth = number(prng, 2, 7);
        layer = {comb({0, 0}, 0.5, prng.between(1, 4), 1, teeth)};
        if (prng.chance(0.3)) {
          layer.push_back(comb({0.25, -6}, 0.5, 4, 1, teeth));
        }
        break;
      }
      case 2: layer = {blob(prng, {0, 0}, 0.5, 6, number(prng, 8, 30))}; break;
      default: {
        const std::size_t teeth = number(prng, 2, 7);
        for (std::size_t i = 0; i < teeth; ++i) {
          const double x = static_cast<double>(i);
          layer.push_back(rectangle({x, -2}, {x + 0.5, 3}, number(prng, 1, 3)));
        }
      }
    }
    if (prng.chance(0.3)) rotate(layer, prng.between(0, 6));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_u_over_blobs(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 4));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    Layer& layer = layers[i];
    const double facing = prng.chance(0.5) ? kPi / 2 : prng.between(0, 2 * kPi);
    const bool horseshoe_here = i % 2 == 0 || prng.chance(0.3);
    if (horseshoe_here) {
      layer.push_back(horseshoe({0, 0}, prng.between(2, 3), prng.between(3.5, 5), facing,
                                prng.between(0.3, 3), number(prng, 5, 20)));
    }
    if (!horseshoe_here || prng.chance(0.4)) {
      const double reach = horseshoe_here ? 1.2 : prng.between(0.8, 4);
      layer.push_back(blob(prng, {0, 0}, 0.7 * reach, reach, number(prng, 3, 14)));
    }
    if (prng.chance(0.3)) layer.push_back(blob(prng, {7, prng.between(-3, 3)}, 0.7, 1.5, 7));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_crossing_bars(Prng& prng) {
  const std::size_t per_side = number(prng, 1, 6);
  const double angle = prng.chance(0.6) ? kPi / 2 : prng.between(0.2, kPi - 0.2);
  std::vector<Layer> layers(number(prng, 2, 4));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::size_t bars = number(prng, 1, 3);
    const double length = prng.chance(0.5) ? 5 : prng.between(2, 6);
    for (std::size_t k = 0; k < bars; ++k) {
      const double y = 3 * (static_cast<double>(k) - 0.5 * static_cast<double>(bars - 1));
      const double half = prng.chance(0.7) ? 0.5 : prng.between(0.2, 1.4);
      layers[i].push_back(rectangle({-length, y - half}, {length, y + half}, per_side));
    }
    if (i % 2 == 1) {
      if (angle == kPi / 2) {  // by exchange of axes, exactly
        for (Contour& contour : layers[i]) {
          for (Point2& p : contour.vertices) p = {p.y, p.x};
        }
      } else {
        rotate(layers[i], angle);
      }
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_oblique(Prng& prng) {
  const std::size_t columns = number(prng, 1, 3);
  std::vector<Point2> at(columns);
  std::vector<Point2> drift(columns);
  for (std::size_t k = 0; k < columns; ++k) {
    at[k] = {4.5 * static_cast<double>(k), 0};
    drift[k] = displaced(prng, {0, 0}, 3);
  }
  const bool alike = prng.chance(0.4);  // all columns lean the same way
  std::vector<Layer> layers(number(prng, 2, 4));
  for (Layer& layer : layers) {
    for (std::size_t k = 0; k < columns; ++k) {
      const double radius = prng.between(1, 2);
      if (prng.chance(0.3)) {
        layer.push_back(regular_polygon(at[k], radius, number(prng, 3, 16), 0));
      } else {
        layer.push_back(blob(prng, at[k], 0.8 * radius, radius, number(prng, 3, 14)));
      }
      const Point2& by = drift[alike ? 0 : k];
      at[k] = {at[k].x + by.x, at[k].y + by.y};
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

namespace {

// Up to 12 vertices: a rectangle, thin or not, or a regular polygon.
Contour coarse_contour(Prng& prng) {
  if (prng.chance(0.4)) return regular_polygon({0, 0}, prng.between(1, 3), number(prng, 3, 12), 0);
  const double half = prng.between(1, 4);
  const double other = prng.chance(0.3) ? half : log_uniform(prng, 0.2, 3);
  return rectangle({-half, -other}, {half, other});
}

}  // namespace

SectionStack draft_coarse_lofts(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 4));
  for (Layer& layer : layers) {
    const bool fine = prng.chance(0.15);
    layer = {fine ? regular_polygon({0, 0}, prng.between(1, 4), number(prng, 24, 48), 0)
                  : coarse_contour(prng)};
    if (prng.chance(0.2)) layer.push_back(rectangle({-0.15, -0.15}, {0.15, 0.15}));
    if (prng.chance(0.2)) layer.push_back(rectangle({4.5, -2}, {5.5, prng.between(0, 2)}));
    if (prng.chance(0.7)) rotate(layer, prng.between(0, kPi));
    const Point2 by = displaced(prng, {0, 0}, prng.chance(0.5) ? 0 : 1.5);
    for (Contour& contour : layer) {
      for (Point2& p : contour.vertices) p = {p.x + by.x, p.y + by.y};
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_thin_parts(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 5));
  const double lean = prng.between(1.1, 2.5);  // in thicknesses, from section to section
  const std::size_t shape = number(prng, 0, 2);
  const std::size_t corners = number(prng, 12, 40);
  const double thick = prng.between(0.3, 0.8);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double moved = lean * thick * static_cast<double>(i);
    if (shape == 0) {
      layers[i] = {regular_polygon({moved, 0}, thick / 2, corners, 0)};
    } else if (shape == 1) {
      layers[i] = {rectangle({-6, moved}, {6, moved + thick}, prng.chance(0.5) ? 1 : 12)};
    } else {  // a cone
      const double inner = 2 + moved;
      layers[i] = {regular_polygon({0, 0}, inner + thick, corners, 0),
                   regular_polygon({0, 0}, inner, corners, 0)};
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_large_contours(Prng& prng) {
  // Two circles about different centres: D has as many tets as the product of their vertices.
  const std::size_t most = prng.chance(0.02) ? 1000 : 600;
  std::vector<Layer> layers(2);
  for (Layer& layer : layers) {
    const std::size_t n = number(prng, most / 3, most);
    const Point2 centre = displaced(prng, {0, 0}, 0.2);
    if (prng.chance(0.5)) {
      layer.push_back(regular_polygon(centre, 1, n, 0));
    } else {
      // Not so jagged that conforming splits every edge a hundred times.
      const double stray = std::min(0.1, 6 / static_cast<double>(n));
      layer.push_back(blob(prng, centre, 1 - stray, 1 + stray, n));
    }
    if (prng.chance(0.3)) layer.push_back(regular_polygon(centre, 0.5, n, 0));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

}  // namespace tetloft::testing
