// Exact overlaps: one fraction per edge, one more per crossing, summed pairwise.
//
// Where e runs below f over a whole common range, the term falls into an integral under e
// alone and one under f alone, of denominators dx_e and dx_f: these are collected edge by
// edge. Only crossings have denominators of their own. Fractions of equal denominator are
// merged before anything is multiplied, so that lattice data stays small.
#include "sections/overlap_exact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sections/overlap_pairs.hpp"

namespace tetloft::internal::sections {

namespace {

// Lattices of up to this many bits fit 128-bit integers: heights over a crossing are
// scaled to 3 b + 2 bits and squared, 6 b + 4 ≤ 127; denominators have 4 b + 1 bits. The
// integrals collected per edge have 3 b + 2 bits, and no more than 2^32 are added.
constexpr int kSmallLatticeBits = 20;

template <class Int>
struct Term {
  Int numerator, denominator;
};

struct Fraction {
  BigInteger numerator, denominator;
};

template <class Int>
Int signed_by(int sign, const Int& value) {
  return sign > 0 ? value : -value;
}

// Twice the integral of e over [l, r], times dx_e.
template <class Int>
Int integral_below(const IntegerTrapezoid<Int>& e, const Int& l, const Int& r) {
  return (r - l) * (Int(2) * e.y0 * (e.x1 - e.x0) + (e.y1 - e.y0) * (l + r - Int(2) * e.x0));
}

// e(x) − f(x), times dx_e dx_f.
template <class Int>
Int height(const IntegerTrapezoid<Int>& e, const IntegerTrapezoid<Int>& f, const Int& x) {
  const Int dxe = e.x1 - e.x0;
  const Int dxf = f.x1 - f.x0;
  return ((e.y0 - f.y0) * dxe + (e.y1 - e.y0) * (x - e.x0)) * dxf -
         (f.y1 - f.y0) * (x - f.x0) * dxe;
}

// Twice the overlap of the edges a and b, which are ia and ib in units, as a list of terms.
template <class Int>
std::vector<Term<Int>> overlap_terms(const std::vector<Trapezoid>& a,
                                     const std::vector<Trapezoid>& b,
                                     const std::vector<IntegerTrapezoid<Int>>& ia,
                                     const std::vector<IntegerTrapezoid<Int>>& ib) {
  const Int zero{0};
  std::vector<Int> below_a(ia.size(), zero);
  std::vector<Int> below_b(ib.size(), zero);
  std::vector<Term<Int>> terms;
  visit_pairs(a, b, [&](std::uint32_t i, std::uint32_t j) {
    const IntegerTrapezoid<Int>& e = ia[i];
    const IntegerTrapezoid<Int>& f = ib[j];
    const int sign = e.side * f.side;
    const Int& l = e.x0 < f.x0 ? f.x0 : e.x0;
    const Int& r = e.x1 < f.x1 ? e.x1 : f.x1;
    const Int at_l = height(e, f, l);
    const Int at_r = height(e, f, r);
    if (!(at_l < zero) && !(at_r < zero)) return;
    if (!(zero < at_l) && !(zero < at_r)) {
      below_a[i] += signed_by(sign, integral_below(e, l, r));
      below_b[j] += signed_by(-sign, integral_below(f, l, r));
      return;
    }
    // A triangle of height |h| / (dx_e dx_f) and width |h| / |slope|.
    const Int& h = at_l < zero ? at_l : at_r;
    const Int dxe = e.x1 - e.x0;
    const Int dxf = f.x1 - f.x0;
    const Int slope = (e.y1 - e.y0) * dxf - (f.y1 - f.y0) * dxe;
    terms.push_back({signed_by(-sign, h * h), (slope < zero ? -slope : slope) * dxe * dxf});
  });
  for (std::size_t i = 0; i < ia.size(); ++i) {
    if (!(below_a[i] == zero)) terms.push_back({below_a[i], ia[i].x1 - ia[i].x0});
  }
  for (std::size_t j = 0; j < ib.size(); ++j) {
    if (!(below_b[j] == zero)) terms.push_back({below_b[j], ib[j].x1 - ib[j].x0});
  }
  return terms;
}

Fraction sum(std::vector<Fraction> terms) {
  if (terms.empty()) return {BigInteger(0), BigInteger(1)};
  while (terms.size() > 1) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < terms.size(); k += 2) {
      if (k + 1 == terms.size()) {
        terms[kept++] = std::move(terms[k]);
        continue;
      }
      const Fraction& p = terms[k];
      const Fraction& q = terms[k + 1];
      terms[kept++] = {p.numerator * q.denominator + q.numerator * p.denominator,
                       p.denominator * q.denominator};
    }
    terms.resize(kept);
  }
  return std::move(terms.front());
}

template <class Int>
Fraction sum_of_terms(std::vector<Term<Int>> terms) {
  std::sort(terms.begin(), terms.end(),
            [](const Term<Int>& s, const Term<Int>& t) { return s.denominator < t.denominator; });
  std::vector<Fraction> merged;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const BigInteger numerator{terms[k].numerator};
    if (k > 0 && terms[k].denominator == terms[k - 1].denominator) {
      merged.back().numerator += numerator;
    } else {
      merged.push_back({numerator, BigInteger{terms[k].denominator}});
    }
  }
  return sum(std::move(merged));
}

template <class Int>
ExactOverlap overlap_in(const Trapezoids& a, const Trapezoids& b, const Point2& origin, int unit) {
  const std::vector<Trapezoid> near_a = edges_for_pairs(a.edges, b.box);
  const std::vector<Trapezoid> near_b = edges_for_pairs(b.edges, a.box);
  Fraction overlap = sum_of_terms(overlap_terms(near_a, near_b, in_units<Int>(near_a, origin, unit),
                                                in_units<Int>(near_b, origin, unit)));
  BigInteger area_a = twice_area(in_units<Int>(a.edges, origin, unit));
  BigInteger area_b = twice_area(in_units<Int>(b.edges, origin, unit));
  return {std::move(overlap.numerator), std::move(overlap.denominator),
          area_a < area_b ? std::move(area_a) : std::move(area_b)};
}

}  // namespace

ExactOverlap exact_overlap(const Trapezoids& a, const Trapezoids& b) {
  Box2 box = a.box;
  box.add(b.box);
  const Point2 origin{box.x0, box.y0};
  const int unit = std::min(lattice_exponent(a.edges), lattice_exponent(b.edges));
  // A rounded extent is off by a relative 2^-53: far less than the 1 taken off.
  const double extent = std::max(box.x1 - box.x0, box.y1 - box.y0);
  const bool small = std::ldexp(extent, -unit) < std::ldexp(1, kSmallLatticeBits) - 1;
  return small ? overlap_in<Int128>(a, b, origin, unit)
               : overlap_in<BigInteger>(a, b, origin, unit);
}

Sign compare(const ExactOverlap& overlap, double tau) {
  const Dyadic t(tau);
  BigInteger left = overlap.numerator;
  BigInteger right = BigInteger(t.mantissa) * overlap.denominator * overlap.smaller;
  if (t.exponent < 0) {
    left = left << static_cast<std::size_t>(-t.exponent);
  } else {
    right = right << static_cast<std::size_t>(t.exponent);
  }
  return static_cast<Sign>((left - right).sign());
}

double rounded_ratio(const ExactOverlap& overlap, int bits) {
  BigInteger rest = overlap.numerator;
  const BigInteger divisor = overlap.denominator * overlap.smaller;
  // ratio · 2^shift lies between 2^bits and 2^(bits + 2): long division, bit by bit.
  const int shift = bits + 1 + static_cast<int>(divisor.bits()) - static_cast<int>(rest.bits());
  BigInteger part = divisor;
  if (shift > 0) {
    rest = rest << static_cast<std::size_t>(shift);
  } else {
    part = part << static_cast<std::size_t>(-shift);
  }
  double quotient = 0;
  for (int bit = bits + 2; bit >= 0; --bit) {
    const BigInteger left = rest - (part << static_cast<std::size_t>(bit));
    if (left.sign() < 0) continue;
    rest = left;
    quotient += std::ldexp(1, bit);
  }
  // Truncation drops less than one unit of a bit below the one that decides the rounding.
  int exponent = 0;
  const double mantissa = std::frexp(quotient, &exponent);
  return std::ldexp(std::floor(std::ldexp(mantissa, bits) + 0.5), exponent - bits - shift);
}

}  // namespace tetloft::internal::sections
