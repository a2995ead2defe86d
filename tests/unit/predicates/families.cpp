#include "unit/predicates/families.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <sstream>
#include <utility>

namespace tetloft::test {

namespace {

int integer(Prng& prng, int low, int high) {
  return low + static_cast<int>(prng.below(static_cast<std::uint64_t>(high - low + 1)));
}

/// Moves a coordinate by a few ulps, or not at all.
void jitter(Prng& prng, double& v) {
  for (int steps = integer(prng, -6, 3); steps > 0; --steps) {
    v = std::nextafter(v, prng.chance(0.5) ? 1e300 : -1e300);
  }
}

void jitter(Prng& prng, Points& points) {
  for (Point3& p : points) {
    jitter(prng, p.x);
    jitter(prng, p.y);
    jitter(prng, p.z);
  }
}

void repeat_sometimes(Prng& prng, Points& points) {
  if (prng.chance(0.1)) points[prng.below(5)] = points[prng.below(5)];
}

template <class Coordinate>
Points from_coordinates(Prng& prng, const Coordinate& coordinate) {
  Points points;
  for (Point3& p : points) p = {coordinate(), coordinate(), coordinate()};
  repeat_sometimes(prng, points);
  return points;
}

Points scaled(Points points, int exponent) {
  for (Point3& p : points) {
    p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  }
  return points;
}

Points uniform(Prng& prng) {
  return from_coordinates(prng, [&] { return prng.between(-1, 1); });
}

Points small_lattice(Prng& prng) {
  return from_coordinates(prng, [&] { return double(integer(prng, -2, 2)); });
}

Points far_lattice(Prng& prng) {
  return from_coordinates(prng, [&] { return 123456.75 + 0.25 * integer(prng, 0, 5); });
}

/// Too wide for 64-bit integers, exact nevertheless.
Points wide_lattice(Prng& prng) {
  return from_coordinates(prng, [&] {
    return integer(prng, -2, 2) + std::ldexp(integer(prng, -1, 1), -integer(prng, 5, 45));
  });
}

Points decimal_lattice(Prng& prng) {
  return from_coordinates(prng, [&] { return 0.1 * integer(prng, 0, 5); });
}

Points jittered_lattice(Prng& prng) {
  Points points = small_lattice(prng);
  jitter(prng, points);
  return points;
}

Points nearly_collinear(Prng& prng) {
  const Point3 start = uniform(prng)[0];
  const Point3 step = uniform(prng)[1];
  Points points;
  for (Point3& p : points) {
    const double t = prng.chance(0.5) ? integer(prng, -3, 3) : prng.between(-3, 3);
    p = {start.x + t * step.x, start.y + t * step.y, start.z + t * step.z};
  }
  jitter(prng, points);
  return points;
}

Points nearly_coplanar(Prng& prng) {
  const Points frame = uniform(prng);
  Points points;
  for (Point3& p : points) {
    const double s = prng.between(-3, 3);
    const double t = prng.chance(0.5) ? integer(prng, -3, 3) : prng.between(-3, 3);
    p = {frame[0].x + s * frame[1].x + t * frame[2].x, frame[0].y + s * frame[1].y + t * frame[2].y,
         frame[0].z + s * frame[1].z + t * frame[2].z};
  }
  jitter(prng, points);
  return points;
}

/// Points with integer coordinates on spheres of radius 15 about the origin, many of them on
/// common circles.
Points cospherical(Prng& prng) {
  static constexpr int triples[][3] = {{0, 9, 12}, {15, 0, 0},  {10, 10, 5}, {2, 10, 11},
                                       {2, 5, 14}, {10, 2, 11}, {12, 9, 0}};
  Points points;
  for (Point3& p : points) {
    const auto& t = triples[prng.below(std::size(triples))];
    const std::size_t turn = prng.below(3);
    const auto coordinate = [&](std::size_t i) {
      return (prng.chance(0.5) ? 1.0 : -1.0) * t[(turn + i) % 3];
    };
    p = {coordinate(0), coordinate(1), coordinate(2)};
  }
  return points;
}

/// Odd, of any size up to 46 bits: too many for the lattice stage, few enough for small
/// multiples to be doubles.
double odd_factor(Prng& prng) {
  return 1 + 2 * static_cast<double>(prng.below(1ULL << prng.below(46)));
}

/// Cospherical with up to full mantissas.
Points wide_cospherical(Prng& prng) {
  Points points = cospherical(prng);
  const double factor = odd_factor(prng);
  for (Point3& p : points) p = {factor * p.x, factor * p.y, factor * p.z};
  return points;
}

/// On circles of radius 65 above each other, with up to full mantissas.
Points wide_cocircular(Prng& prng) {
  static constexpr int pairs[][2] = {{65, 0}, {16, 63}, {33, 56}, {25, 60}, {39, 52}};
  const double factor = odd_factor(prng) / 16;
  Points points;
  for (Point3& p : points) {
    const auto& t = pairs[prng.below(std::size(pairs))];
    const std::size_t turn = prng.below(2);
    p = {(prng.chance(0.5) ? factor : -factor) * t[turn],
         (prng.chance(0.5) ? factor : -factor) * t[1 - turn], factor * integer(prng, 0, 2)};
  }
  return points;
}

Points far_cospherical(Prng& prng) {
  Points points = cospherical(prng);
  for (Point3& p : points) p = {p.x + 1000.5, p.y - 33.25, p.z + 7};
  return points;
}

Points nearly_cospherical(Prng& prng) {
  Points points = cospherical(prng);
  const double scale = prng.chance(0.5) ? 0.1 : 1;
  for (Point3& p : points) p = {scale * p.x + 0.7, scale * p.y, scale * p.z};
  jitter(prng, points);
  return points;
}

/// Circle points of radius 5 or 25 in two planes with an awkward gap.
Points two_planes(Prng& prng) {
  static constexpr int pairs[][2] = {{5, 0}, {3, 4}, {4, 3}, {0, 5}};
  const double low = prng.between(-1, 1);
  const double high = prng.chance(0.5) ? low + 0.7 : 3.5 * low;
  const double scale = prng.chance(0.5) ? 1 : 0.1;
  Points points;
  for (Point3& p : points) {
    const auto& t = pairs[prng.below(std::size(pairs))];
    p = {(prng.chance(0.5) ? scale : -scale) * t[0], (prng.chance(0.5) ? scale : -scale) * t[1],
         prng.chance(0.5) ? low : high};
  }
  if (prng.chance(0.3)) jitter(prng, points[prng.below(5)].x);
  if (prng.chance(0.3)) points[prng.below(5)].z = 0.25;
  repeat_sometimes(prng, points);
  return points;
}

/// So far apart that the gap hides all else from the filter of insphere.
Points distant_planes(Prng& prng) {
  Points points = prng.chance(0.5) ? uniform(prng) : small_lattice(prng);
  for (Point3& p : points) p.z = prng.chance(0.5) ? 0 : 1e9;
  return points;
}

Points two_planes_at_the_limits(Prng& prng) {
  Points points = two_planes(prng);
  return scaled(points, prng.chance(0.5) ? 1018 : -1072);
}

Points huge(Prng& prng) {
  return from_coordinates(prng, [&] {
    return prng.chance(0.5) ? std::ldexp(integer(prng, -1, 1), 1023)
                            : std::ldexp(prng.between(-1, 1), 1023 - integer(prng, 0, 3));
  });
}

Points largest(Prng& prng) {
  return from_coordinates(
      prng, [&] { return integer(prng, -1, 1) * std::numeric_limits<double>::max(); });
}

Points denormal(Prng& prng) {
  return from_coordinates(prng, [&] { return std::ldexp(integer(prng, -2, 2), -1074); });
}

Points nearly_denormal(Prng& prng) {
  return from_coordinates(prng, [&] { return std::ldexp(prng.between(-1, 1), -1030); });
}

Points mixed_magnitudes(Prng& prng) {
  return from_coordinates(prng, [&] {
    return prng.chance(0.2) ? 0.0 : std::ldexp(prng.between(-1, 1), integer(prng, -1074, 1023));
  });
}

/// A degenerate configuration next to much smaller or larger coordinates.
Points mixed_lattice(Prng& prng) {
  const int exponents[] = {-1074, -600, -30, 0, 0, 0, 40, 900};
  return from_coordinates(prng, [&] {
    return std::ldexp(integer(prng, -1, 1), exponents[prng.below(std::size(exponents))]);
  });
}

/// On both sides of the limits where expansions hand over to integers, and of those where
/// filters give up.
Points edges_of_ranges(Prng& prng) {
  static constexpr int limits[] = {-485, 495, -306, 329, -216, 246, -162, 196, 160, -100};
  const int limit = limits[prng.below(std::size(limits))] - integer(prng, -1, 1);
  Points points = prng.chance(0.5) ? cospherical(prng) : nearly_cospherical(prng);
  return scaled(points, limit - (limit < 0 ? 0 : 4));
}

/// Full mantissas of both signs right below the upper limit, or a full mantissa's last bit
/// at the lower one: what the proofs of the ranges have to cover.
Points full_mantissas(Prng& prng) {
  static constexpr int limits[][2] = {{-485, 495}, {-306, 329}, {-216, 246}, {-162, 196}};
  const auto& limit = limits[prng.below(4)];
  const int exponent = prng.chance(0.5) ? limit[0] + 1 : limit[1];
  return from_coordinates(prng, [&] {
    const double v = std::ldexp(1 - std::ldexp(static_cast<double>(prng.below(4)), -53), exponent);
    return prng.chance(0.5) ? v : -v;
  });
}

/// Products along x and y underflow, those along z make up for it.
Points tall_and_thin(Prng& prng) {
  Points points;
  for (Point3& p : points) {
    p = {std::ldexp(integer(prng, -8, 8), -539), std::ldexp(integer(prng, -8, 8), -539),
         std::ldexp(integer(prng, -2, 2), 300)};
  }
  return points;
}

/// Nearly cocircular along y and z, nearly denormal along x: an error bound that multiplied
/// its tiny factor first would underflow.
Points wide_and_thin(Prng& prng) {
  static constexpr int pairs[][2] = {{5, 0}, {3, 4}, {4, 3}, {0, 5}};
  Points points;
  for (Point3& p : points) {
    const auto& t = pairs[prng.below(std::size(pairs))];
    p = {0, (prng.chance(0.5) ? 0.1 : -0.1) * t[0] + 0.7, (prng.chance(0.5) ? 0.1 : -0.1) * t[1]};
    jitter(prng, p.y);
    p = {std::ldexp(integer(prng, -1, 1), -1040), std::ldexp(p.y, 157), std::ldexp(p.z, 157)};
  }
  return points;
}

/// One axis far thinner than the others, down to the least doubles; sometimes about cocircular.
Points thin_axis(Prng& prng) {
  const int exponent = integer(prng, -1074, -100);
  const std::uint64_t axis = prng.below(3);
  const bool round = prng.chance(0.3);
  Points points;
  for (Point3& p : points) {
    const double angle = prng.between(0, 6.3);
    std::array<double, 3> at{round ? std::cos(angle) : prng.between(-1, 1),
                             round ? std::sin(angle) : prng.between(-1, 1),
                             std::ldexp(double(integer(prng, -500, 500)), exponent)};
    std::swap(at[2], at[axis]);
    p = {at[0], at[1], at[2]};
  }
  repeat_sometimes(prng, points);
  return points;
}

Points signed_zeros(Prng& prng) {
  return from_coordinates(prng, [&] {
    const double values[] = {0.0, -0.0, 1.0, -1.0};
    return values[prng.below(4)];
  });
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"Uniform", uniform},
      {"SmallLattice", small_lattice},
      {"FarLattice", far_lattice},
      {"WideLattice", wide_lattice},
      {"DecimalLattice", decimal_lattice},
      {"JitteredLattice", jittered_lattice},
      {"NearlyCollinear", nearly_collinear},
      {"NearlyCoplanar", nearly_coplanar},
      {"Cospherical", cospherical},
      {"WideCospherical", wide_cospherical},
      {"WideCocircular", wide_cocircular},
      {"FarCospherical", far_cospherical},
      {"NearlyCospherical", nearly_cospherical},
      {"TwoPlanes", two_planes},
      {"DistantPlanes", distant_planes},
      {"TwoPlanesAtTheLimits", two_planes_at_the_limits},
      {"Huge", huge},
      {"Largest", largest},
      {"Denormal", denormal},
      {"NearlyDenormal", nearly_denormal},
      {"MixedMagnitudes", mixed_magnitudes},
      {"MixedLattice", mixed_lattice},
      {"EdgesOfRanges", edges_of_ranges},
      {"FullMantissas", full_mantissas},
      {"TallAndThin", tall_and_thin},
      {"WideAndThin", wide_and_thin},
      {"ThinAxis", thin_axis},
      {"SignedZeros", signed_zeros},
  };
  return all;
}

std::string to_string(const Points& points) {
  std::ostringstream out;
  out << std::hexfloat << "{";
  for (const Point3& p : points) out << "{" << p.x << ", " << p.y << ", " << p.z << "}, ";
  out << "}";
  return out.str();
}

}  // namespace tetloft::test
