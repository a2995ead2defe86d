// Stacks with extreme ratios: distances, gaps, scales, jitter, near contact, slivers.
#include <array>
#include <cmath>
#include <span>

#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {
namespace {

using Draft = SectionStack (*)(Prng&);

// Some other kind's draft, to be distorted.
SectionStack some_draft(Prng& prng) {
  constexpr std::array<Draft, 8> kDrafts{draft_checkerboard,
                                         draft_identical_sections,
                                         draft_branching_one_to_many,
                                         draft_branching_many_to_many,
                                         draft_holes,
                                         draft_isolated_contours,
                                         draft_crossing_bars,
                                         draft_oblique};
  return kDrafts[number(prng, 0, kDrafts.size() - 1)](prng);
}

template <class Function>
void for_each_point(SectionStack& stack, Function&& function) {
  for (Section& section : stack.sections) {
    for (Contour& contour : section.contours) {
      for (Point2& p : contour.vertices) function(p);
    }
  }
}

}  // namespace

SectionStack draft_far_apart(Prng& prng) {
  const std::size_t clusters = number(prng, 2, 3);
  std::vector<Point2> at;
  for (std::size_t k = 0; k < clusters; ++k) {
    const double distance = k == 0 ? 0 : log_uniform(prng, 10, 1e5);
    const double angle = prng.between(0, 2 * kPi);
    at.push_back({distance * std::cos(angle), distance * std::sin(angle)});
  }
  std::vector<Layer> layers(number(prng, 2, 3));
  for (Layer& layer : layers) {
    for (const Point2& centre : at) {
      if (prng.chance(0.25)) continue;
      if (prng.chance(0.3)) {
        layer.push_back(regular_polygon(centre, 1, number(prng, 3, 12), 0));
      } else {
        layer.push_back(blob(prng, displaced(prng, centre, 0.5), 0.6, 1.4, number(prng, 3, 12)));
      }
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_extreme_gaps(Prng& prng) {
  SectionStack stack = some_draft(prng);
  double z = prng.between(-1, 1);
  const bool even = prng.chance(0.5);
  const double gap = log_uniform(prng, 1e-6, 1e6);
  for (Section& section : stack.sections) {
    section.z = z;
    z += even ? gap : log_uniform(prng, 1e-6, 1e6);
  }
  return stack;
}

SectionStack draft_scale_offset(Prng& prng) {
  SectionStack stack = some_draft(prng);
  if (prng.chance(0.3)) {
    // Powers of two change no shape, but take squares and products out of the range of
    // doubles.
    const double scale = std::ldexp(1, static_cast<int>(number(prng, 0, 600)) - 300);
    for_each_point(stack, [&](Point2& p) { p = {p.x * scale, p.y * scale}; });
    for (Section& section : stack.sections) section.z *= scale;
    return stack;
  }
  const double scale = log_uniform(prng, 1e-6, 1e6);
  const Point2 offset = displaced(prng, {0, 0}, scale * log_uniform(prng, 1, 1e6));
  for_each_point(stack, [&](Point2& p) { p = {p.x * scale + offset.x, p.y * scale + offset.y}; });
  const double lift = scale * prng.between(-1e6, 1e6);
  for (Section& section : stack.sections) section.z = section.z * scale + lift;
  return stack;
}

SectionStack draft_near_coincident(Prng& prng) {
  SectionStack stack = prng.chance(0.5) ? draft_identical_sections(prng) : some_draft(prng);
  // Half the time the second section repeats the first, so that jitter is all that
  // tells them apart.
  if (prng.chance(0.5) && stack.sections.size() > 1) {
    stack.sections[SectionId(1)].contours = stack.sections[SectionId(0)].contours;
  }
  const double jitter = std::pow(10, -prng.between(3, 16));
  const double density = prng.chance(0.5) ? 1 : prng.between(0.1, 0.9);
  for_each_point(stack, [&](Point2& p) {
    if (!prng.chance(density)) return;
    p = {p.x * (1 + jitter * prng.between(-1, 1)), p.y * (1 + jitter * prng.between(-1, 1))};
  });
  return stack;
}

SectionStack draft_near_touching(Prng& prng) {
  const double distance = std::pow(10, -prng.between(1, 13));
  const std::size_t per_side = number(prng, 1, 4);
  std::vector<Layer> layers(number(prng, 2, 3));
  for (Layer& layer : layers) {
    const double shift = prng.chance(0.5) ? 0 : distance * prng.between(-2, 2);
    switch (number(prng, 0, 3)) {
      case 0: {  // side by side
        // Facing sides with different vertices are split to a spacing of about the square
        // root of their distance: only wide gaps stay small stacks.
        const std::size_t opposite = distance > 1e-4 ? number(prng, 1, 4) : per_side;
        layer = {rectangle({-4 + shift, -2}, {shift, 2}, per_side),
                 rectangle({shift + distance, -2}, {4 + shift, 2}, opposite)};
        break;
      }
      case 1:  // a thin wall
        layer = {rectangle({-4, -4 + shift}, {4, 4 + shift}, per_side),
                 rectangle({distance - 4, distance - 4 + shift},
                           {4 - distance, 4 - distance + shift}, per_side)};
        break;
      case 2:  // corner to side
        layer = {rectangle({-4, -4}, {shift, 4}, per_side),
                 {{{shift + distance, 0.1}, {3, -1}, {3, 2}}}};
        break;
      default:  // corner to corner
        layer = {rectangle({-3 + shift, -3}, {shift, 0}, per_side),
                 rectangle({shift + distance, distance}, {4, 4}, per_side)};
        break;
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_slivers(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 3));
  for (Layer& layer : layers) {
    const double thin = log_uniform(prng, 1e-4, 0.3);
    switch (number(prng, 0, 3)) {
      case 0: {  // an annulus
        const std::size_t n = number(prng, 3, 24);
        layer = {regular_polygon({0, 0}, 4, n, 0), regular_polygon({0, 0}, 4 - thin, n, 0)};
        break;
      }
      case 1:  // a bar
        layer = {rectangle({-4, -thin}, {4, thin}, number(prng, 1, 5))};
        rotate(layer, prng.between(0, 3));
        break;
      case 2:  // two rooms joined by a corridor
        layer = {{{{-4, -1},
                   {-1, -1},
                   {-1, -thin},
                   {1, -thin},
                   {1, -1},
                   {4, -1},
                   {4, 1},
                   {1, 1},
                   {1, thin},
                   {-1, thin},
                   {-1, 1},
                   {-4, 1}}}};
        break;
      default: {  // needles
        const std::size_t needles = number(prng, 1, 3);
        for (std::size_t i = 0; i < needles; ++i) {
          const double y = static_cast<double>(i);
          layer.push_back({{{-4, y}, {4, y + 0.3}, {-4, y + thin}}});
        }
      }
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

}  // namespace tetloft::testing
