// Small stacks of the kinds that have cost far more than their size: what is quadratic, or goes in
// rounds, shows there first.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

namespace {

// A few units in the last place aside, or not at all.
double ulps_aside(Prng& prng, double value) {
  const std::size_t steps = number(prng, 0, 3);
  const double towards = prng.chance(0.5) ? HUGE_VAL : -HUGE_VAL;
  for (std::size_t i = 0; i < steps; ++i) value = std::nextafter(value, towards);
  return value;
}

Contour moved(Contour contour, Point2 by) {
  for (Point2& p : contour.vertices) p = {p.x + by.x, p.y + by.y};
  return contour;
}

// A band that winds about the origin, `width` wide, its windings `gap` apart.
Contour spiral(double turns, double width, double gap, std::size_t per_turn, double phase) {
  const auto n = static_cast<std::size_t>(turns * static_cast<double>(per_turn));
  Contour contour;
  std::vector<Point2> back;
  for (std::size_t i = 0; i <= n; ++i) {
    const double turn = static_cast<double>(i) / static_cast<double>(per_turn);
    const double inner = 1 + (width + gap) * turn;
    const double angle = phase + 2 * kPi * turn;
    contour.vertices.push_back({inner * std::cos(angle), inner * std::sin(angle)});
    const double outer = inner + width;
    back.push_back({outer * std::cos(angle), outer * std::sin(angle)});
  }
  contour.vertices.insert(contour.vertices.end(), back.rbegin(), back.rend());
  return contour;
}

}  // namespace

SectionStack draft_islands(Prng& prng) {
  const std::size_t side = number(prng, 2, 8);
  const std::size_t corners = number(prng, 3, 5);
  const double radius = prng.between(0.2, 0.5);
  const double phase = prng.between(0, 6);
  // The same again, drifting, or all over one large contour.
  const Point2 drift = prng.chance(0.4) ? Point2{0, 0} : Point2{prng.between(0, 0.8), 0.1};
  const bool over_one = prng.chance(0.3);
  std::vector<Layer> layers(2);
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const auto at = static_cast<double>(l);
    if (l == 1 && over_one) {
      const auto end = static_cast<double>(side);
      layers[l].push_back(rectangle({-1, -1}, {end, end}));
      continue;
    }
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto x = static_cast<double>(i % side) + at * drift.x;
      const auto y = static_cast<double>(i / side) + at * drift.y;
      layers[l].push_back(regular_polygon({x, y}, radius, corners, phase));
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_nested_ngons(Prng& prng) {
  std::vector<Layer> layers(2);
  const std::size_t depth = number(prng, 4, 24);
  for (Layer& layer : layers) {
    const std::size_t corners = number(prng, 4, 7);
    // Inside each other however turned.
    const double ratio = 0.98 * std::cos(kPi / static_cast<double>(corners));
    double radius = prng.between(9, 10);
    for (std::size_t i = 0; i < depth; ++i) {
      layer.push_back(regular_polygon({0, 0}, radius, corners, prng.between(0, 6)));
      radius *= prng.chance(0.8) ? ratio : 0.9 * ratio;
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_concentric_ngons(Prng& prng) {
  std::vector<Layer> layers(2);
  const std::size_t corners = number(prng, 10, 80);
  for (Layer& layer : layers) {
    const Point2 centre = displaced(prng, {0, 0}, log_uniform(prng, 1e-15, 0.5));
    const std::size_t rings = number(prng, 1, 3);
    for (std::size_t i = 0; i < rings; ++i) {
      const double radius = 4 - static_cast<double>(i);
      layer.push_back(regular_polygon(centre, radius, corners, prng.between(0, 6)));
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_tight_spirals(Prng& prng) {
  std::vector<Layer> layers(2);
  const double gap = log_uniform(prng, 1e-3, 0.3);
  for (Layer& layer : layers) {
    const double turns = prng.between(1.2, 3);
    layer.push_back(spiral(turns, prng.between(0.2, 0.6), gap, number(prng, 8, 20),
                           prng.chance(0.5) ? 0 : prng.between(0, 6)));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_tiny_gaps(Prng& prng) {
  const std::size_t side = number(prng, 2, 4);
  std::vector<Layer> layers(2);
  for (Layer& layer : layers) {
    const double gap = std::exp2(-static_cast<double>(number(prng, 6, 50)));
    const Point2 shift{0.25 * static_cast<double>(number(prng, 0, 3)), 0};
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto x = static_cast<double>(i % side) + shift.x;
      const auto y = static_cast<double>(i / side) + shift.y;
      layer.push_back(rectangle({x + gap, y + gap}, {x + 1 - gap, y + 1 - gap}));
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_ulp_combs(Prng& prng) {
  const std::size_t teeth = number(prng, 2, 8);
  const Contour base = comb({0, 0}, prng.between(0.3, 0.6), prng.between(0.5, 4), 0.5, teeth);
  std::vector<Layer> layers(2);
  for (Layer& layer : layers) {
    Contour contour = base;
    for (Point2& p : contour.vertices) p = {ulps_aside(prng, p.x), ulps_aside(prng, p.y)};
    layer.push_back(contour);
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_ulp_lattices(Prng& prng) {
  const double pitch = prng.between(0.05, 3);
  const double origin = prng.between(-100, 100);
  const std::size_t side = number(prng, 2, 4);
  const std::size_t more = number(prng, 0, 1);
  std::vector<Layer> layers(number(prng, 2, 3));
  for (std::size_t l = 0; l < layers.size(); ++l) {
    // Counted from the origin, or step by step: the same numbers but for the last bits.
    std::vector<double> line{origin};
    for (std::size_t i = 1; i <= 2 * (side + 1); ++i) {
      line.push_back(l % 2 == 0 ? origin + static_cast<double>(i) * pitch : line.back() + pitch);
    }
    const std::size_t first = l % 2 == 0 ? 0 : more;
    for (std::size_t i = 0; i < side * side; ++i) {
      const std::size_t x = first + 2 * (i % side);
      const std::size_t y = 2 * (i / side);
      if (prng.chance(0.3)) continue;
      layers[l].push_back(rectangle({line[x], line[y]}, {line[x + 1], line[y + 1]}));
    }
    if (layers[l].empty()) layers[l].push_back(rectangle({line[0], line[0]}, {line[1], line[1]}));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_needles(Prng& prng) {
  std::vector<Layer> layers(2);
  for (Layer& layer : layers) {
    const std::size_t count = number(prng, 2, 6);
    const double thin = log_uniform(prng, 2e-2, 2e-1);
    for (std::size_t i = 0; i < count; ++i) {
      const double y = static_cast<double>(i) * 3 * thin;
      const double tip = y + prng.between(-1, 1) * thin;
      Contour needle{{{prng.between(-0.1, 0), y},
                      {prng.between(1, 2), tip},
                      {prng.between(-0.1, 0), y + thin}}};
      layer.push_back(moved(needle, {prng.between(-0.2, 0.2), 0}));
    }
    if (prng.chance(0.5)) rotate(layer, prng.between(0, 6));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

}  // namespace tetloft::testing
