#include "support/stacks/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetloft::testing {
namespace {

Point2 polar(Point2 centre, double radius, double angle) {
  return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
}

}  // namespace

Contour regular_polygon(Point2 centre, double radius, std::size_t n, double phase) {
  Contour contour;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = phase + 2 * kPi * static_cast<double>(i) / static_cast<double>(n);
    contour.vertices.push_back(polar(centre, radius, angle));
  }
  return contour;
}

Contour blob(Prng& prng, Point2 centre, double low, double high, std::size_t n) {
  Contour contour;
  const double step = 2 * kPi / static_cast<double>(n);
  const double phase = prng.between(0, 2 * kPi);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = phase + step * (static_cast<double>(i) + prng.between(-0.2, 0.2));
    contour.vertices.push_back(polar(centre, prng.between(low, high), angle));
  }
  return contour;
}

Contour rectangle(Point2 low, Point2 high) {
  return {{low, {high.x, low.y}, high, {low.x, high.y}}};
}

Contour rectangle(Point2 low, Point2 high, std::size_t per_side) {
  const Contour corners = rectangle(low, high);
  Contour contour;
  for (std::size_t side = 0; side < 4; ++side) {
    const Point2 from = corners.vertices[side];
    const Point2 to = corners.vertices[(side + 1) % 4];
    for (std::size_t i = 0; i < per_side; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(per_side);
      contour.vertices.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
  }
  return contour;
}

Contour spiky(Point2 centre, double inner, double outer, std::size_t arms, double phase) {
  Contour contour;
  const double step = kPi / static_cast<double>(arms);
  for (std::size_t i = 0; i < 2 * arms; ++i) {
    const double radius = i % 2 == 0 ? outer : inner;
    contour.vertices.push_back(polar(centre, radius, phase + step * static_cast<double>(i)));
  }
  return contour;
}

Contour comb(Point2 corner, double tooth_width, double tooth_length, double bar_height,
             std::size_t teeth) {
  Contour contour;
  const double right = corner.x + tooth_width * static_cast<double>(2 * teeth - 1);
  contour.vertices = {corner, {right, corner.y}};
  for (std::size_t i = 2 * teeth; i-- > 0;) {
    // From right to left: up along a tooth's right side, down along its left.
    const double x = corner.x + tooth_width * static_cast<double>(i);
    const double bar = corner.y + bar_height;
    const double tip = bar + tooth_length;
    if (i % 2 == 1) {
      if (i != 2 * teeth - 1) contour.vertices.push_back({x, bar});
      contour.vertices.push_back({x, tip});
    } else {
      contour.vertices.push_back({x, tip});
      if (i != 0) contour.vertices.push_back({x, bar});
    }
  }
  return contour;
}

Contour horseshoe(Point2 centre, double inner, double outer, double facing, double mouth,
                  std::size_t n) {
  Contour contour;
  const double from = facing + mouth / 2;
  const double sweep = 2 * kPi - mouth;
  for (std::size_t i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    contour.vertices.push_back(polar(centre, outer, from + sweep * t));
  }
  for (std::size_t i = 0; i <= n; ++i) {
    const double t = static_cast<double>(n - i) / static_cast<double>(n);
    contour.vertices.push_back(polar(centre, inner, from + sweep * t));
  }
  return contour;
}

std::vector<Disc> pack_discs(Prng& prng, std::size_t count, double size, double low, double high,
                             double clearance) {
  std::vector<Disc> discs;
  for (std::size_t trial = 0; trial < 30 * count && discs.size() < count; ++trial) {
    const double radius = prng.between(low, high);
    const double reach = size - radius;
    if (reach <= 0) continue;
    const Disc disc{{prng.between(-reach, reach), prng.between(-reach, reach)}, radius};
    const bool clear = std::all_of(discs.begin(), discs.end(), [&](const Disc& other) {
      const double distance =
          std::hypot(disc.centre.x - other.centre.x, disc.centre.y - other.centre.y);
      return distance > disc.radius + other.radius + clearance;
    });
    if (clear) discs.push_back(disc);
  }
  return discs;
}

Contour blob_in(Prng& prng, const Disc& disc, std::size_t n) {
  return blob(prng, disc.centre, 0.7 * disc.radius, disc.radius, n);
}

Point2 displaced(Prng& prng, Point2 p, double by) {
  return {p.x + prng.between(-by, by), p.y + prng.between(-by, by)};
}

double log_uniform(Prng& prng, double low, double high) {
  return std::exp(prng.between(std::log(low), std::log(high)));
}

std::size_t number(Prng& prng, std::size_t low, std::size_t high) {
  return low + static_cast<std::size_t>(prng.below(high - low + 1));
}

void rotate(Layer& layer, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (Contour& contour : layer) {
    for (Point2& p : contour.vertices) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  }
}

void append(Layer& to, const Layer& from) { to.insert(to.end(), from.begin(), from.end()); }

std::vector<double> heights(Prng& prng, std::size_t n) {
  const bool even = prng.chance(0.5);
  // Whole gaps keep lattice stacks cospherical.
  const double gap = even ? static_cast<double>(number(prng, 1, 4)) / 2 : 1;
  double z = static_cast<double>(number(prng, 0, 20)) - 10;
  std::vector<double> result;
  for (std::size_t i = 0; i < n; ++i) {
    result.push_back(z);
    z += even ? gap : log_uniform(prng, 0.2, 5);
  }
  return result;
}

SectionStack stack_of(std::vector<Layer> layers, const std::vector<double>& z) {
  SectionStack stack;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    stack.sections.push_back({z[i], IdVector<ContourId, Contour>(std::move(layers[i]))});
  }
  return stack;
}

}  // namespace tetloft::testing
