// Exact geometric predicates on doubles.
//
// Every predicate answers the sign of a determinant of its arguments exactly, for every
// finite double, also where intermediate values over- or underflow. Stages: a floating-
// point filter, exact expansion arithmetic (64-bit integers for lattice data), big
// integers where expansions leave the range of doubles (Shewchuk, "Adaptive precision
// floating-point arithmetic and fast robust geometric predicates", DCG 18, 1997).
//
// The perturbed predicates never return zero on distinct points in general enough
// position (stated at each): Simulation of Simplicity (Edelsbrunner and Mücke, ACM TOG 9,
// 1990) applied to the lifting coordinate alone. The point that comes later in canonical
// order (point.hpp) is perturbed by infinitely more. The perturbation depends on
// coordinates only; Delaunay triangulations are therefore unique.
//
// Requirement of all: finite coordinates, and the default floating-point environment
// (round to nearest, no flush to zero, no contraction); fp_self_check() verifies it.
#pragma once

#include <cstdint>

#include <tetloft/export.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

[[nodiscard]] constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

/// Positive iff a, b, c turn counter-clockwise: the sign of (b − a) × (c − a).
/// (1) Swapping two arguments negates the result. (2) Zero iff collinear.
[[nodiscard]] TETLOFT_API Sign orient2d(const Point2& a, const Point2& b, const Point2& c);

/// Positive iff (b − a) × (c − a) · (d − a) > 0: seen from d, the triangle a b c turns
/// counter-clockwise. The tet (a, b, c, d) is then positive.
/// (1) Swapping two arguments negates the result. (2) Zero iff coplanar.
[[nodiscard]] TETLOFT_API Sign orient3d(const Point3& a, const Point3& b, const Point3& c,
                                        const Point3& d);

/// For a, b, c counter-clockwise: positive iff d lies strictly inside their circle.
/// (1) Swapping two of a, b, c negates the result. (2) Zero iff cocircular or all collinear.
[[nodiscard]] TETLOFT_API Sign incircle(const Point2& a, const Point2& b, const Point2& c,
                                        const Point2& d);

/// For orient3d(a, b, c, d) positive: positive iff e lies strictly inside their sphere.
/// (1) Swapping two of a, b, c, d negates the result. (2) Zero iff cospherical.
[[nodiscard]] TETLOFT_API Sign insphere(const Point3& a, const Point3& b, const Point3& c,
                                        const Point3& d, const Point3& e);

/// incircle, symbolically perturbed. Never zero for four distinct points of which a, b, c
/// are not collinear; zero where two points coincide or all are collinear.
/// (1) Swapping any two of the four points negates the result.
[[nodiscard]] TETLOFT_API Sign incircle_perturbed(const Point2& a, const Point2& b, const Point2& c,
                                                  const Point2& d);

/// insphere, symbolically perturbed. Never zero for five distinct points of which a, b,
/// c, d are not coplanar; zero where two points coincide or all are coplanar.
/// (1) Swapping any two of the five points negates the result. (2) Restricted to a plane of
/// constant z it agrees with incircle_perturbed: for a, b, c, e in the plane it is that of
/// their (x, y) if d lies above the plane, and its negative if d lies below.
[[nodiscard]] TETLOFT_API Sign insphere_perturbed(const Point3& a, const Point3& b, const Point3& c,
                                                  const Point3& d, const Point3& e);

/// How many calls each stage answered, for tests and benchmarks.
struct PredicateCounters {
  struct Stages {
    std::uint64_t filter = 0;     ///< answered by the floating-point filter
    std::uint64_t expansion = 0;  ///< by exact expansion arithmetic
    std::uint64_t integer = 0;    ///< by big integers (range of doubles left)
    std::uint64_t symbolic = 0;   ///< by the perturbation (perturbed predicates only)
    std::uint64_t lattice = 0;    ///< by 64-bit integers (differences of few bits)
  };
  Stages orient2d, orient3d, incircle, insphere;
};

/// Counts the calling thread's predicate calls while it lives, into `counters`. Nesting
/// restores the outer scope at the end of the inner one. Without a live scope nothing is
/// counted.
class PredicateCounting {
 public:
  explicit PredicateCounting(PredicateCounters& counters);
  ~PredicateCounting();
  PredicateCounting(const PredicateCounting&) = delete;
  PredicateCounting& operator=(const PredicateCounting&) = delete;

 private:
  PredicateCounters* outer_;
};

/// Verifies that this build and this thread compute as the predicates need: IEEE double
/// without contraction, reassociation, excess precision or flush to zero, rounding to
/// nearest. Every entry of the library that decides geometry calls it once, and refuses with this
/// error, unfit_arithmetic, otherwise.
[[nodiscard]] TETLOFT_API Result<void> fp_self_check();

}  // namespace tetloft
