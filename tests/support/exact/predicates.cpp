#include "support/exact/predicates.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "support/exact/big_int.hpp"

namespace tetloft::oracle {

namespace {

using Row = std::vector<BigInt>;
using Matrix = std::vector<Row>;

/// Expansion along the first column; the depth is that of the matrix.
BigInt determinant(const Matrix& m) {
  if (m.size() == 1) return m[0][0];
  BigInt result;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (m[i][0].sign() == 0) continue;
    Matrix minor;
    for (std::size_t k = 0; k < m.size(); ++k) {
      if (k != i) minor.emplace_back(m[k].begin() + 1, m[k].end());
    }
    const BigInt term = m[i][0] * determinant(minor);
    result = i % 2 == 0 ? result + term : result - term;
  }
  return result;
}

std::vector<double> coordinates(const Point2& p) { return {p.x, p.y}; }
std::vector<double> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

/// One row of coordinates per point, in a common unit.
template <class Point, std::size_t n>
Matrix integer_rows(const std::array<Point, n>& points) {
  int unit = 1023;
  for (const Point& p : points) {
    for (const double v : coordinates(p)) unit = std::min(unit, BigInt::exponent_of(v));
  }
  Matrix rows;
  for (const Point& p : points) {
    Row row;
    for (const double v : coordinates(p)) row.push_back(BigInt::from_scaled(v, unit));
    rows.push_back(row);
  }
  return rows;
}

template <class Point, std::size_t n>
int orientation(const std::array<Point, n>& points) {
  Matrix rows = integer_rows(points);
  for (Row& row : rows) row.insert(row.begin(), BigInt(1));
  return determinant(rows).sign();
}

BigInt lift_of(const Row& row) {
  BigInt sum;
  for (const BigInt& v : row) sum = sum + v * v;
  return sum;
}

/// Rows (coordinates, lift, 1). The simplex is positive and the query point inside where
/// this is positive in the plane and negative in space.
template <class Point, std::size_t n>
int in_ball(const std::array<Point, n>& points, bool perturbed) {
  Matrix rows = integer_rows(points);
  // No determinant here is 2^bits or more: a step of the ladder outweighs all below it.
  int bits = 16;
  for (const Row& row : rows) {
    for (const BigInt& v : row) bits = std::max(bits, 16 + 5 * (v.bits() + 1));
  }
  constexpr int steps = static_cast<int>(n);
  for (std::size_t i = 0; i < n; ++i) {
    BigInt lift = lift_of(rows[i]);
    if (perturbed) {
      int later = 0;  // distinct points after this one
      for (std::size_t k = 0; k < n; ++k) {
        const bool repeated =
            std::find(points.begin(), points.begin() + k, points[k]) != points.begin() + k;
        if (!repeated && canonical_less(points[i], points[k])) ++later;
      }
      lift = lift.shifted_left(steps * bits) + BigInt(1).shifted_left((steps - 1 - later) * bits);
    }
    rows[i].push_back(lift);
    rows[i].emplace_back(1);
  }
  const int sign = determinant(rows).sign();
  return n == 5 ? -sign : sign;
}

}  // namespace

int orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return orientation(std::array{a, b, c});
}

int orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return orientation(std::array{a, b, c, d});
}

int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return in_ball(std::array{a, b, c, d}, false);
}

int insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return in_ball(std::array{a, b, c, d, e}, false);
}

int incircle_perturbed(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return in_ball(std::array{a, b, c, d}, true);
}

int insphere_perturbed(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                       const Point3& e) {
  return in_ball(std::array{a, b, c, d, e}, true);
}

}  // namespace tetloft::oracle
