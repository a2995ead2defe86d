#include "periodic/lattice.hpp"

#include <algorithm>
#include <cmath>

#include <tetloft/predicates.hpp>

#include "arithmetic/double_double.hpp"
#include "core/vector.hpp"

namespace tetloft::internal::periodic {

using namespace vectors;

namespace {

constexpr double kMostLength = 0x1p300, kLeastLength = 0x1p-300;
constexpr double kMostInteger = 0x1p40;  // products with 53 bits fit in two doubles
constexpr double kMostShift = 0x1p30;
// Longest vector over shortest height: below, the grid has 30 bits for the shortest.
constexpr double kMostElongation = 0x1p16;

double norm(const Point3& p) { return std::sqrt(dot(p, p)); }

bool fits_range(const Point3& p) {  // false for what is not finite
  return std::abs(p.x) <= kMostLength && std::abs(p.y) <= kMostLength &&
         std::abs(p.z) <= kMostLength;
}

// start + k · (a, b, c) in one coordinate, from exact products.
double combination(double start, const std::array<double, 3>& k, double a, double b, double c) {
  const auto wide = [](double value) { return DoubleDouble{value, 0}; };
  return (wide(start) + wide(k[0]) * wide(a) + wide(k[1]) * wide(b) + wide(k[2]) * wide(c)).high;
}

Point3 combination(const Point3& start, const std::array<double, 3>& k, const PeriodicBox& box) {
  return {combination(start.x, k, box.a.x, box.b.x, box.c.x),
          combination(start.y, k, box.a.y, box.b.y, box.c.y),
          combination(start.z, k, box.a.z, box.b.z, box.c.z)};
}

struct Reduction {
  std::array<Point3, 3> basis;
  std::array<std::array<double, 3>, 3> in_box{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  bool is_lost = false;  // the integers are too large

  // Takes by[k] of each vector k off vector i, by[i] = 0, where that makes it shorter; by enough to
  // end.
  [[nodiscard]] bool shorten(std::size_t i, const std::array<double, 3>& by,
                             const PeriodicBox& box) {
    constexpr double kShorter = 1 - 0x1p-30;
    if (by == std::array<double, 3>{}) return false;
    std::array<double, 3> made = in_box[i];
    for (std::size_t m = 0; m < 3; ++m) {
      for (std::size_t k = 0; k < 3; ++k) made[m] -= by[k] * in_box[k][m];
      if (!(std::abs(made[m]) < kMostInteger)) is_lost = true;
    }
    if (is_lost) return false;
    const Point3 shorter = combination(Point3(), made, box);
    if (!(dot(shorter, shorter) < kShorter * dot(basis[i], basis[i]))) return false;
    basis[i] = shorter;
    in_box[i] = made;
    return true;
  }
  [[nodiscard]] std::array<std::size_t, 3> by_length() const {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
      const double of_i = dot(basis[i], basis[i]), of_k = dot(basis[k], basis[k]);
      return of_i != of_k ? of_i < of_k : i < k;
    });
    return order;
  }
  // Of the two shortest first: by two that are nearly parallel a long one goes in tiny steps.
  [[nodiscard]] bool shorten_once(const PeriodicBox& box) {
    const std::array<std::size_t, 3> order = by_length();
    for (std::size_t i = 1; i < 3; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Point3& short_one = basis[order[k]];
        std::array<double, 3> by{};
        by[order[k]] = std::nearbyint(dot(basis[order[i]], short_one) / dot(short_one, short_one));
        if (shorten(order[i], by, box)) return true;
      }
    }
    for (const double of_first : {-1.0, 1.0}) {
      for (const double of_second : {-1.0, 1.0}) {
        std::array<double, 3> by{};
        by[order[0]] = of_first;
        by[order[1]] = of_second;
        if (shorten(order[2], by, box)) return true;
      }
    }
    return false;
  }
};

// Pairs as by Gauss, and sums of three: shorter until nothing gets shorter, so that the basis is
// reduced as by Minkowski, but for kShorter. How good it is decides how much work there is, and by
// how much rounding of coordinates is larger than of lengths.
Reduction reduction_of(const PeriodicBox& box) {
  Reduction result;
  result.basis = {box.a, box.b, box.c};
  while (!result.is_lost && result.shorten_once(box)) {
  }
  return result;
}

double on_grid(double value, int exponent) {
  return std::ldexp(std::nearbyint(std::ldexp(value, -exponent)), exponent);
}
Point3 on_grid(const Point3& p, const std::array<int, 3>& grid) {
  return {on_grid(p.x, grid[0]), on_grid(p.y, grid[1]), on_grid(p.z, grid[2])};
}

void measure(Lattice& lattice) {
  const std::array<Point3, 3>& v = lattice.basis;
  const double determinant = dot(v[0], cross(v[1], v[2]));
  lattice.volume = std::abs(determinant);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3 normal = cross(v[(i + 1) % 3], v[(i + 2) % 3]);
    lattice.dual[i] = (1 / determinant) * normal;
    lattice.slope[i] = norm(lattice.dual[i]);
  }
  lattice.covering_radius =
      0.5 * (1 + 0x1p-30) * std::sqrt(dot(v[0], v[0]) + dot(v[1], v[1]) + dot(v[2], v[2]));
}

// Exponents such that coordinates of images within two covering radii of the cell take 52 bits.
std::array<int, 3> grid_of(const Lattice& lattice) {
  std::array<int, 3> grid{};
  for (int axis = 0; axis < 3; ++axis) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      most += std::abs(coordinate(lattice.basis[i], axis)) *
              (4 + 2 * lattice.covering_radius * lattice.slope[i]);
    }
    grid[static_cast<std::size_t>(axis)] = std::ilogb(most) + 1 - 52;
  }
  return grid;
}

Result<void> check_box(const PeriodicBox& box) {
  for (const Point3& v : {box.a, box.b, box.c}) {
    if (fits_range(v)) continue;
    Error error{ErrorCode::invalid_input, "a vector of the box is not finite, or beyond 2^300", {}};
    error.where.point = v;
    return error;
  }
  if (orient3d(Point3(), box.a, box.b, box.c) != Sign::zero) return {};
  return Error{ErrorCode::invalid_input, "the box has no volume", {}};
}

Result<Integers> checked_shift(const std::array<double, 3>& shift, std::size_t point) {
  Integers result{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(shift[i]) < kMostShift)) {
      Error error{ErrorCode::unrepresentable, "a point is 2^30 boxes away", {}};
      error.where.vertex = point;
      return error;
    }
    result[i] = static_cast<std::int64_t>(shift[i]);
  }
  return result;
}

}  // namespace

Result<Lattice> reduced_lattice(const PeriodicBox& box) {
  if (Result<void> fine = check_box(box); !fine) return fine.error();
  const Error lost{ErrorCode::unrepresentable,
                   "the box is too long and thin: doubles do not hold its images",
                   {}};
  const Reduction reduction = reduction_of(box);
  if (reduction.is_lost) return lost;
  Lattice lattice;
  lattice.box = box;
  lattice.basis = reduction.basis;
  measure(lattice);
  const double longest =
      std::max({norm(lattice.basis[0]), norm(lattice.basis[1]), norm(lattice.basis[2])});
  const double steepest = *std::max_element(lattice.slope.begin(), lattice.slope.end());
  if (!(longest * steepest <= kMostElongation) || !(1 / steepest >= kLeastLength)) return lost;
  lattice.grid = grid_of(lattice);
  for (Point3& v : lattice.basis) v = on_grid(v, lattice.grid);
  measure(lattice);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(std::abs(reduction.in_box[i][k]) < kMostShift)) return lost;
      lattice.in_box[i][k] = static_cast<std::int64_t>(reduction.in_box[i][k]);
    }
  }
  return lattice;
}

std::array<double, 3> coordinates(const Lattice& lattice, const Point3& p) {
  return {dot(lattice.dual[0], p), dot(lattice.dual[1], p), dot(lattice.dual[2], p)};
}

// In rounds, as the first quotient of a point far away has few digits behind the point.
Result<WrappedPoints> wrapped(const Lattice& lattice, std::span<const Point3> points) {
  constexpr int kRounds = 8;
  WrappedPoints result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!fits_range(points[i])) {
      Error error{ErrorCode::invalid_input, "a coordinate is not finite, or beyond 2^300", {}};
      error.where.vertex = i;
      error.where.point = points[i];
      return error;
    }
    Point3 at = points[i];
    std::array<double, 3> taken{};  // in the caller's vectors, negative
    bool inside = false;
    for (int round = 0; !inside && round < kRounds; ++round) {
      const std::array<double, 3> x = coordinates(lattice, at);
      inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        if (x[k] >= -kWrapSlack / 2 && x[k] <= 1 + kWrapSlack / 2) continue;
        inside = false;
        const double whole = std::floor(x[k]);
        for (std::size_t m = 0; m < 3; ++m) {
          taken[m] -= whole * static_cast<double>(lattice.in_box[k][m]);
        }
      }
      if (!inside) at = combination(points[i], taken, lattice.box);
    }
    Result<Integers> shift = checked_shift({-taken[0], -taken[1], -taken[2]}, i);
    if (!shift) return shift.error();
    if (!inside) {
      Error error{ErrorCode::unrepresentable, "a point is too far from the box to be wrapped", {}};
      error.where.vertex = i;
      return error;
    }
    result.points.push_back(on_grid(at, lattice.grid));
    result.subtracted.push_back(*shift);
  }
  return result;
}

}  // namespace tetloft::internal::periodic
