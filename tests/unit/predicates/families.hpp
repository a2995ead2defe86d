// Generators of points that are hard for predicates: degenerate, nearly so, and at the
// limits of doubles. Deterministic by seed.
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include <tetloft/point.hpp>

#include "core/prng.hpp"

namespace tetloft::test {

using namespace internal;

/// Arguments of any predicate; those of fewer points take the first, those in the plane
/// x and y.
using Points = std::array<Point3, 5>;

struct Family {
  std::string name;
  Points (*make)(Prng&);
};

inline void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

[[nodiscard]] const std::vector<Family>& families();

[[nodiscard]] inline Point2 flat(const Point3& p) { return {p.x, p.y}; }

/// Hexadecimal, to be pasted into a test.
[[nodiscard]] std::string to_string(const Points& points);

}  // namespace tetloft::test
