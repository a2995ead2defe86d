#include "io/float32.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tetloft::internal::io {

namespace {

bool fits_float32(const Point3& p) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return std::fabs(p.x) <= kLargest && std::fabs(p.y) <= kLargest && std::fabs(p.z) <= kLargest;
}

// Whether the sum of six doubles is zero, exactly: they are collected in a non-overlapping
// expansion (Shewchuk 1997, Grow-Expansion), which is zero iff its components are.
bool sums_to_zero(const std::array<double, 6>& terms) {
  std::array<double, 6> expansion{};
  std::size_t size = 0;
  for (const double term : terms) {
    double carry = term;
    for (std::size_t i = 0; i < size; ++i) {
      const double sum = carry + expansion[i];
      const double virtual_part = sum - carry;
      expansion[i] = (carry - (sum - virtual_part)) + (expansion[i] - virtual_part);
      carry = sum;
    }
    expansion[size++] = carry;
  }
  return std::all_of(expansion.begin(), expansion.end(), [](double e) { return e == 0; });
}

// Whether the projection of a, b, c to two axes is collinear. Products of two floats are
// exact as doubles: 48 bits, exponents between −298 and 256.
bool collinear_in(const FloatPoint& a, const FloatPoint& b, const FloatPoint& c, std::size_t u,
                  std::size_t v) {
  const auto product = [](float x, float y) {
    return static_cast<double>(x) * static_cast<double>(y);
  };
  return sums_to_zero({product(a[u], b[v]), -product(a[v], b[u]), product(b[u], c[v]),
                       -product(b[v], c[u]), product(c[u], a[v]), -product(c[v], a[u])});
}

bool flat(const FloatPoint& a, const FloatPoint& b, const FloatPoint& c) {
  return collinear_in(a, b, c, 0, 1) && collinear_in(a, b, c, 1, 2) && collinear_in(a, b, c, 2, 0);
}

// Within a closed surface; with the origin in its first point, far from which digits are few.
template <class Coordinates>
double volume_within(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                     Coordinates&& coordinates) {
  double six_volumes = 0;
  const std::array<double, 3> origin = coordinates(0);
  const auto from_origin = [&](std::uint32_t v) {
    std::array<double, 3> p = coordinates(v);
    for (std::size_t k = 0; k < 3; ++k) p[k] -= origin[k];
    return p;
  };
  for (const auto& t : triangles) {
    const auto a = from_origin(t[0]);
    const auto b = from_origin(t[1]);
    const auto c = from_origin(t[2]);
    six_volumes += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six_volumes / 6;
}

}  // namespace

FloatPoint float_point(const Point3& p) {
  return {static_cast<float>(p.x) + 0.0F, static_cast<float>(p.y) + 0.0F,
          static_cast<float>(p.z) + 0.0F};
}

std::optional<Error> beyond_float32(const std::vector<Point3>& points, const std::string& format) {
  const auto place = std::find_if_not(points.begin(), points.end(), fits_float32);
  if (place == points.end()) return std::nullopt;
  Error error{ErrorCode::invalid_input,
              "a coordinate is beyond the float32 of " + format + "; write .ply or .vtp",
              {}};
  error.where.point = *place;
  return error;
}

void Float32Loss::add(const std::vector<Point3>& points,
                      const std::vector<std::array<std::uint32_t, 3>>& triangles,
                      const std::vector<FloatPoint>& written) {
  std::vector<std::uint32_t> order(written.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return written[i] != written[j] ? written[i] < written[j] : i < j;
  });
  std::size_t merged = 0;
  std::uint32_t first = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (written[order[i]] != written[order[i - 1]]) continue;
    first = merged == 0 ? order[i] : std::min(first, order[i]);
    ++merged;
  }
  if (merged_.number == 0 && merged != 0) merged_.place = points[first];
  merged_.number += merged;
  if (!points.empty()) {
    volume_ += volume_within(triangles, [&](std::size_t v) {
      return std::array<double, 3>{points[v].x, points[v].y, points[v].z};
    });
    written_volume_ += volume_within(triangles, [&](std::size_t v) {
      const FloatPoint& p = written[v];
      return std::array<double, 3>{p[0], p[1], p[2]};
    });
  }
  for (const auto& t : triangles) {
    if (!flat(written[t[0]], written[t[1]], written[t[2]])) continue;
    if (flattened_.number++ == 0) flattened_.place = points[t[0]];
  }
}

Warning Float32Loss::warning(const char* does, const Count& count, const char* what,
                             const char* whats, const char* so) const {
  Warning warning{"rounding to the float32 of " + format_ + ' ' + does + ' ' +
                      std::to_string(count.number) + ' ' + (count.number == 1 ? what : whats) + so +
                      "; .ply and .vtp keep double precision",
                  {}};
  warning.where.point = count.place;
  return warning;
}

std::vector<Warning> Float32Loss::warnings() const {
  std::vector<Warning> all;
  if (merged_.number != 0) {
    all.push_back(warning("merges", merged_, "vertex", "vertices",
                          " with others; the surface may touch itself"));
  }
  if (flattened_.number != 0) {
    all.push_back(
        warning("flattens", flattened_, "triangle", "triangles", "; the surface may not be valid"));
  }
  const double change = std::fabs(written_volume_ / volume_ - 1);
  if (all.empty() && std::isfinite(change) && change > 0.001) {
    // Of slivers, which may grow without bound, no more digits than an integer holds.
    const long long permille = std::llround(std::min(1000 * change, 1e15));
    all.push_back({"rounding to the float32 of " + format_ + " changes the volume by " +
                       std::to_string(permille / 10) + '.' + std::to_string(permille % 10) +
                       " %; .obj, .ply and .vtp keep double precision",
                   {}});
  }
  return all;
}

}  // namespace tetloft::internal::io
