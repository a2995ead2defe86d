// incircle and insphere with every point's lifting coordinate raised by an infinitesimal.
//
// The predicate is the sign of a determinant that is linear in each lift. Where it vanishes,
// the perturbed one is Σ ε(p) · cofactor(p), and the ε of the point latest in canonical order
// exceeds all others infinitely: the first nonzero cofactor in descending order decides.
// The cofactor of a simplex vertex's lift is the orientation of the simplex with that vertex
// replaced by the query point; that of the query point's is minus the orientation of the
// simplex (a raised point lies outside). Equal points have equal lifts; the perturbed
// determinant then vanishes as well.
//
// Products of infinitesimals do not occur: the determinant is linear in the column of lifts.
//
// Edelsbrunner and Mücke, "Simulation of simplicity", ACM TOG 9, 1990; for Delaunay
// triangulations: Devillers and Teillaud, "Perturbations for Delaunay and weighted Delaunay
// 3D triangulations", CGTA 44, 2011.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <tetloft/predicates.hpp>

#include "predicates/counting.hpp"
#include "predicates/exact.hpp"
#include "predicates/filter.hpp"
#include "predicates/plane_filter.hpp"
#include "predicates/set_filter.hpp"

namespace tetloft {

using namespace internal;

namespace {

using predicates::Answer;
using predicates::count_answer;
using predicates::Stages;

// Orientations inside a perturbation are part of the call that needs them: not counted.

Sign orientation(const std::array<Point2, 3>& p) {
  const int s = predicates::orient2d_filter(p[0], p[1], p[2]);
  return s != 0 ? static_cast<Sign>(s) : predicates::exact_orient2d(p[0], p[1], p[2]).sign;
}

Sign orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const int s = predicates::orient3d_filter(a, b, c, d);
  return s != 0 ? static_cast<Sign>(s) : predicates::exact_orient3d(a, b, c, d).sign;
}

Sign orientation(const std::array<Point3, 4>& p) { return orientation(p[0], p[1], p[2], p[3]); }

/// The sign of the perturbed predicate of `simplex` and `query` where the unperturbed one
/// is zero.
template <class Point, std::size_t n>
Sign perturbed_sign(const std::array<Point, n>& simplex, const Point& query) {
  // Indices of the simplex's vertices, n for the query point; descending.
  std::array<std::size_t, n + 1> order;
  const auto point = [&](std::size_t i) -> const Point& { return i == n ? query : simplex[i]; };
  for (std::size_t i = 0; i <= n; ++i) {
    std::size_t k = i;
    for (; k > 0 && canonical_less(point(order[k - 1]), point(i)); --k) order[k] = order[k - 1];
    order[k] = i;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (point(order[k]) == point(order[k + 1])) return Sign::zero;
  }
  for (const std::size_t i : order) {
    if (i == n) {
      if (const Sign s = orientation(simplex); s != Sign::zero) return -s;
    } else {
      std::array<Point, n> replaced = simplex;
      replaced[i] = query;
      if (const Sign s = orientation(replaced); s != Sign::zero) return s;
    }
  }
  return Sign::zero;  // all points in one hyperplane
}

}  // namespace

// Most calls end at the first cofactor, but on lattices, where four of the points often lie in a
// plane.
Sign predicates::perturbed_insphere_of_cospherical(const Point3& a, const Point3& b,
                                                   const Point3& c, const Point3& d,
                                                   const Point3& e) {
  count_answer(&PredicateCounters::insphere, &Stages::symbolic);
  const std::array<const Point3*, 5> p{&a, &b, &c, &d, &e};
  std::size_t latest = 4;
  for (std::size_t i = 0; i < 4; ++i) {
    if (canonical_less(*p[latest], *p[i])) latest = i;
  }
  // Where two points are equal the predicate is zero: left, as other zeros, to the general case.
  // A cofactor other than zero shows its four points distinct.
  bool tied = false;
  for (std::size_t i = 0; i < 5; ++i) tied |= i != latest && *p[i] == *p[latest];
  if (!tied) {
    std::array<const Point3*, 4> cofactor{&a, &b, &c, &d};
    if (latest < 4) cofactor[latest] = &e;
    const Sign s = orientation(*cofactor[0], *cofactor[1], *cofactor[2], *cofactor[3]);
    if (s != Sign::zero) return latest < 4 ? s : -s;
  }
  return perturbed_sign(std::array{a, b, c, d}, e);
}

Sign predicates::perturbed_insphere_of_cospherical(const SetFilter& filter,
                                                   const std::array<const Point3*, 5>& p,
                                                   std::array<std::uint32_t, 5> rank) {
  count_answer(&PredicateCounters::insphere, &Stages::symbolic);
  for (std::uint32_t& r : rank) ++r;  // 0 for those that were tried
  for (std::size_t left = p.size(); left > 0; --left) {
    // No branch depends on which it is.
    std::size_t latest = 0;
    std::uint32_t most = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
      latest = rank[k] > most ? k : latest;
      most = std::max(rank[k], most);
    }
    rank[latest] = 0;
    std::array<const Point3*, 5> cofactor = p;
    cofactor[latest] = p[4];
    const int s = filter.orient3d(*cofactor[0], *cofactor[1], *cofactor[2], *cofactor[3]);
    if (s != 0) return static_cast<Sign>(latest == 4 ? -s : s);
  }
  return Sign::zero;  // all points in one plane
}

// Most calls end at the first cofactor: no three of the points lie on a line unless two are
// equal.
Sign predicates::perturbed_incircle_of_cocircular(const Point2& a, const Point2& b, const Point2& c,
                                                  const Point2& d) {
  count_answer(&PredicateCounters::incircle, &Stages::symbolic);
  const std::array<Point2, 4> p{a, b, c, d};
  std::size_t latest = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (canonical_less(p[latest], p[i])) latest = i;
  }
  std::array<Point2, 3> cofactor{a, b, c};
  if (latest < 3) cofactor[latest] = d;
  // Where two points are equal the predicate is zero: left, as other zeros, to the general case.
  // A cofactor other than zero shows its three points distinct.
  bool tied = false;
  for (std::size_t i = 0; i < 4; ++i) tied |= i != latest && p[i] == p[latest];
  if (!tied) {
    if (const Sign s = orientation(cofactor); s != Sign::zero) return latest < 3 ? s : -s;
  }
  return perturbed_sign(std::array{a, b, c}, d);
}

Sign incircle_perturbed(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (const int s = predicates::incircle_filter(a, b, c, d); s != 0) {
    count_answer(&PredicateCounters::incircle, &Stages::filter);
    return static_cast<Sign>(s);
  }
  const Answer exact = predicates::exact_incircle(a, b, c, d);
  if (exact.sign != Sign::zero) {
    count_answer(&PredicateCounters::incircle, exact.stage);
    return exact.sign;
  }
  return predicates::perturbed_incircle_of_cocircular(a, b, c, d);
}

Sign insphere_perturbed(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                        const Point3& e) {
  if (const int s = predicates::insphere_filter(a, b, c, d, e); s != 0) {
    count_answer(&PredicateCounters::insphere, &Stages::filter);
    return static_cast<Sign>(s);
  }
  return predicates::perturbed_insphere_beyond_filter(a, b, c, d, e);
}

Sign predicates::perturbed_insphere_beyond_filter(const Point3& a, const Point3& b, const Point3& c,
                                                  const Point3& d, const Point3& e) {
  const Answer exact = predicates::exact_insphere(a, b, c, d, e);
  if (exact.sign != Sign::zero) {
    count_answer(&PredicateCounters::insphere, exact.stage);
    return exact.sign;
  }
  return predicates::perturbed_insphere_of_cospherical(a, b, c, d, e);
}

}  // namespace tetloft
