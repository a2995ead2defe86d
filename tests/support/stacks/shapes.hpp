// The shapes that random stacks are made of, and how they are arranged.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/sections.hpp>

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;

using Layer = std::vector<Contour>;  ///< the contours of one section

inline constexpr double kPi = 3.141592653589793;

/// n vertices on a circle.
[[nodiscard]] Contour regular_polygon(Point2 centre, double radius, std::size_t n, double phase);

/// A star-shaped polygon of n ≥ 3 vertices with radii in [low, high) at angles that
/// stray from even spacing by up to a fifth of it: it contains the circle of radius
/// low · cos(1.4 π / n).
[[nodiscard]] Contour blob(Prng& prng, Point2 centre, double low, double high, std::size_t n);

[[nodiscard]] Contour rectangle(Point2 low, Point2 high);
/// With collinear vertices, `per_side` edges on each side.
[[nodiscard]] Contour rectangle(Point2 low, Point2 high, std::size_t per_side);

/// A star of `arms` thin arms from radius `inner` to `outer`.
[[nodiscard]] Contour spiky(Point2 centre, double inner, double outer, std::size_t arms,
                            double phase);

/// A bar along x with `teeth` teeth of the given length pointing in +y.
[[nodiscard]] Contour comb(Point2 corner, double tooth_width, double tooth_length,
                           double bar_height, std::size_t teeth);

/// An annulus without the sector of `mouth` radians around `facing`; n edges per arc.
[[nodiscard]] Contour horseshoe(Point2 centre, double inner, double outer, double facing,
                                double mouth, std::size_t n);

struct Disc {
  Point2 centre;
  double radius = 0;
};

/// Up to `count` discs with radii in [low, high) in the square [−size, size]², pairwise at
/// least `clearance` apart; fewer where they do not fit.
[[nodiscard]] std::vector<Disc> pack_discs(Prng& prng, std::size_t count, double size, double low,
                                           double high, double clearance);

/// A blob that fills most of the disc and does not leave it.
[[nodiscard]] Contour blob_in(Prng& prng, const Disc& disc, std::size_t n);

[[nodiscard]] Point2 displaced(Prng& prng, Point2 p, double by);
[[nodiscard]] double log_uniform(Prng& prng, double low, double high);
/// Uniform in low … high, both included.
[[nodiscard]] std::size_t number(Prng& prng, std::size_t low, std::size_t high);

void rotate(Layer& layer, double angle);
void append(Layer& to, const Layer& from);

/// n heights: even or uneven gaps around 1, from a random start.
[[nodiscard]] std::vector<double> heights(Prng& prng, std::size_t n);

/// Section i holds layers[i] at z[i].
[[nodiscard]] SectionStack stack_of(std::vector<Layer> layers, const std::vector<double>& z);

}  // namespace tetloft::testing
