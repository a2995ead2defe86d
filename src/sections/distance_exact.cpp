// With all coordinates integers of a common unit, the square of a distance is a fraction:
// |p − a|² before the edge, |p − b|² behind it, ((b − a) × (p − a))² / |b − a|² beside it.
#include "sections/distance_exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "arithmetic/big_integer.hpp"

namespace tetloft::internal::sections {

namespace {

struct SquareFraction {
  BigInteger numerator, denominator;

  friend bool operator<(const SquareFraction& a, const SquareFraction& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
};

struct Vector {
  BigInteger x, y;
};

Vector vector_between(const Point2& a, const Point2& b, int unit) {
  return {BigInteger::from_double(a.x, unit) - BigInteger::from_double(b.x, unit),
          BigInteger::from_double(a.y, unit) - BigInteger::from_double(b.y, unit)};
}

BigInteger dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }

SquareFraction squared_distance(const PointAndEdge& pair, int unit) {
  const Vector u = vector_between(pair.p, pair.edge.a, unit);
  const Vector v = vector_between(pair.edge.b, pair.edge.a, unit);
  const BigInteger along = dot(u, v);
  BigInteger length2 = dot(v, v);
  if (along.sign() <= 0) return {dot(u, u), BigInteger(1)};
  if (length2 < along) {
    const Vector w = vector_between(pair.p, pair.edge.b, unit);
    return {dot(w, w), BigInteger(1)};
  }
  const BigInteger cross = v.x * u.y - v.y * u.x;
  return {cross * cross, std::move(length2)};
}

int common_unit(std::span<const PointAndEdge> pairs) {
  int unit = std::numeric_limits<int>::max();
  for (const PointAndEdge& pair : pairs) {
    for (const Point2& q : {pair.p, pair.edge.a, pair.edge.b}) {
      for (const double value : {q.x, q.y}) {
        if (value != 0) unit = std::min(unit, Dyadic(value).exponent);
      }
    }
  }
  return unit;
}

// The root of a positive fraction times 2^unit, rounded.
double rounded_root(const SquareFraction& square, int unit, int bits) {
  const auto length = [](const BigInteger& value) { return static_cast<int>(value.bits()); };
  const int n = length(square.numerator);
  const int d = length(square.denominator);
  const int odd = (n - d) % 2 == 0 ? 0 : 1;
  const double root =
      std::sqrt(square.numerator.to_double(odd - n) / square.denominator.to_double(-d));
  int exponent = 0;
  const double mantissa = std::frexp(root, &exponent);
  exponent += (n - d - odd) / 2;

  // One bit more than asked for decides the rounding: y ≤ root · 2^shift < y + 1. As the root in
  // doubles is off by a few units of their last place, a guess of y is off by 1 at most.
  const int shift = bits + 1 - exponent;
  BigInteger left = square.numerator;
  BigInteger right = square.denominator;
  if (shift > 0) {
    left = left << static_cast<std::size_t>(2 * shift);
  } else {
    right = right << static_cast<std::size_t>(-2 * shift);
  }
  auto y = static_cast<std::int64_t>(std::ldexp(mantissa, bits + 1));
  const auto is_above = [&](std::int64_t value) {
    return left < BigInteger(value) * BigInteger(value) * right;
  };
  while (is_above(y)) --y;
  while (!is_above(y + 1)) ++y;
  return std::ldexp(static_cast<double>((y + 1) / 2), unit + 1 - shift);
}

}  // namespace

double smallest_distance(std::span<const PointAndEdge> pairs, int bits) {
  const int unit = common_unit(pairs);
  SquareFraction smallest = squared_distance(pairs.front(), unit);
  for (const PointAndEdge& pair : pairs.subspan(1)) {
    SquareFraction other = squared_distance(pair, unit);
    if (other < smallest) smallest = std::move(other);
  }
  return rounded_root(smallest, unit, bits);
}

}  // namespace tetloft::internal::sections
