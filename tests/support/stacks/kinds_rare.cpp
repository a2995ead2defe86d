// Stacks for the rules of the method that other kinds hardly ever reach.
#include <array>
#include <cmath>
#include <vector>

#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

// A tet can hold internal edges of two components only where the two cross with hardly any
// overlap, and only if each has regions in both planes.
SectionStack draft_interlocking(Prng& prng) {
  std::vector<Layer> layers(2);
  for (Layer& layer : layers) {
    const double half = prng.between(0.02, 0.1);
    const double radius = prng.between(0.5, 1.5);
    layer.push_back(rectangle({-5, -half}, {prng.between(5, 6), half}, number(prng, 2, 8)));
    layer.push_back(
        blob(prng, {prng.between(-0.2, 0.2), 5}, 0.7 * radius, radius, number(prng, 3, 8)));
  }
  for (Contour& contour : layers[1]) {
    for (Point2& p : contour.vertices) p = {p.y, p.x};
  }
  if (prng.chance(0.5)) {
    const double angle = prng.between(0, 6);
    for (Layer& layer : layers) rotate(layer, angle);
  }
  return stack_of(layers, heights(prng, layers.size()));
}

// Jittered, turned and mirrored variants of stacks found by search: two triangles over two,
// or over one polygon, such that the tets kept at a cross edge of the convex hull are not
// one run.
SectionStack draft_split_runs(Prng& prng) {
  static const std::array<std::array<Layer, 2>, 4> kFound{{
      {{{{{{2, 1}, {3, 1}, {4, 3}}}, {{{8, 3}, {6, 5}, {6, 3}, {4, 0}}}},
        {{{{5, 4}, {3, 8}, {7, 8}}}, {{{5, 1}, {6, 3}, {3, 1}}}}}},
      {{{{{{6, 1}, {7, 4}, {6, 5}, {8, 6}}}, {{{5, 5}, {6, 4}, {4, 3}}}},
        {{{{2, 7}, {3, 7}, {1, 4}}}, {{{2, 3}, {8, 6}, {8, 3}}}}}},
      {{{{{{-2, 1}, {-6, 1}, {-6, 0}, {2, -1}, {6, 0}}}},
        {{{{-5, -4}, {-5, -2}, {-4, -2}}}, {{{-2, 1}, {-1, 1}, {-1, 0}}}}}},
      {{{{{{0, -4}, {2, 0}, {2, -2}}}, {{{-4, 0}, {-2, 0}, {-2, 2}}}},
        {{{{-6, 0}, {-6, -6}, {0, -6}, {6, -6}, {6, 0}}}}}},
  }};
  const auto& found = kFound[number(prng, 0, kFound.size() - 1)];
  std::vector<Layer> layers(found.begin(), found.end());
  const bool mirrored = prng.chance(0.5);
  const bool turned = prng.chance(0.5);
  const double jitter = prng.chance(0.3) ? 0 : prng.between(0, 0.2);
  const double angle = prng.chance(0.5) ? 0 : prng.between(0, 6);
  for (Layer& layer : layers) {
    for (Contour& contour : layer) {
      for (Point2& p : contour.vertices) {
        p = displaced(prng, p, jitter);
        if (mirrored) p.x = -p.x;
        if (turned) p = {-p.y, p.x};
      }
    }
    if (angle != 0) rotate(layer, angle);
  }
  if (prng.chance(0.3)) std::swap(layers[0], layers[1]);
  return stack_of(layers, heights(prng, layers.size()));
}

// Constructed points can be rounded to hardly anywhere.
SectionStack draft_few_ulps(Prng& prng) {
  SectionStack stack = prng.chance(0.5)   ? draft_interlocking(prng)
                       : prng.chance(0.5) ? draft_branching_many_to_many(prng)
                                          : draft_isolated_contours(prng);
  // One ulp of 10^14 is 1/64, one of 10^15 an eighth; shapes are about ten wide.
  const double offset = std::pow(10, prng.between(13.5, 15));
  const double lift = prng.chance(0.3) ? std::pow(10, prng.between(13, 15)) : 0;
  for (Section& section : stack.sections) {
    section.z += lift;
    for (Contour& contour : section.contours) {
      for (Point2& p : contour.vertices) p = {p.x + offset, p.y + offset};
    }
  }
  return stack;
}

}  // namespace tetloft::testing
