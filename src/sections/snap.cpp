// Snapping to a lattice, finer and finer until the stack stays valid and as it was nested.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <tetloft/nesting.hpp>
#include <tetloft/repair.hpp>

#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "sections/validation.hpp"

namespace tetloft {

using namespace internal;

namespace {

// The exponent of the least power of two not below the largest coordinate magnitude.
int extent_exponent(const SectionStack& stack) {
  double largest = 0;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
      }
    }
  }
  int exponent = 0;
  const double mantissa = std::frexp(largest, &exponent);
  return mantissa == 0.5 ? exponent - 1 : exponent;
}

// The nearest multiple of 2^exponent, ties to even. At most 2^50 multiples below the
// extent: neither scaling loses a bit that counts.
double to_lattice(double value, int exponent) {
  const double snapped = std::ldexp(std::nearbyint(std::ldexp(value, -exponent)), exponent);
  return snapped == value ? value : snapped + 0.0;  // no new negative zeros
}

class Snapper {
 public:
  Snapper(const SectionStack& stack, int exponent) : exponent_(exponent) {
    result_.stack = stack;
    for (std::size_t s = 0; s < stack.sections.size(); ++s) {
      Section& section = result_.stack.sections[SectionId(s)];
      for (std::size_t c = 0; c < section.contours.size(); ++c) {
        snap_contour(SectionId(s), ContourId(c), section.contours[ContourId(c)]);
      }
    }
  }

  [[nodiscard]] Snapped& result() { return result_; }

 private:
  void snap_contour(SectionId s, ContourId c, Contour& contour) {
    std::vector<Point2> snapped;
    snapped.reserve(contour.vertices.size());
    for (const Point2& p : contour.vertices) {
      snapped.push_back({to_lattice(p.x, exponent_), to_lattice(p.y, exponent_)});
    }
    // The last vertices may fall on the first, which then stands for them.
    std::size_t end = snapped.size();
    while (end > 1 && snapped[end - 1] == snapped[0]) --end;
    std::vector<Point2> kept;
    kept.reserve(end);
    for (std::size_t v = 0; v < snapped.size(); ++v) {
      const Point2& from = contour.vertices[v];
      const Point2& to = snapped[v];
      const bool falls = v >= end || (v > 0 && kept.back() == to);
      if (falls || !(from == to)) result_.moved.push_back({s, c, v, from, to});
      if (!falls) kept.push_back(to);
    }
    contour.vertices = std::move(kept);
  }

  int exponent_;
  Snapped result_;
};

// What snapping changed for the worse; ok if nothing.
Result<void> acceptable(const SectionStack& before, const SectionStack& after,
                        const Execution& execution) {
  WatchedWork work(execution, after.sections.size());
  if (Result<void> valid = sections::validate_within(after, work); !valid) return valid;
  for (std::size_t s = 0; s < before.sections.size(); ++s) {
    const SectionId id(s);
    if (nest(before.sections[id]).parent == nest(after.sections[id]).parent) continue;
    Error error{ErrorCode::invalid_input, "a contour moves into another one", {}};
    error.where.section = s;
    return error;
  }
  return {};
}

Result<Snapped> snap_all(const SectionStack& stack, int bits, const Execution& execution) {
  if (bits < kFewestSnapBits || bits > kMostSnapBits) {
    return Error{ErrorCode::usage, "snapping takes 1 to 50 bits, not " + std::to_string(bits), {}};
  }
  // How many lattices will be tried nobody knows: all are one step.
  WatchedWork work(execution, stack.sections.size() + 1);
  const Result<void> sound = sections::validate_within(stack, work);
  if (!sound) return sound.error();
  const Execution trial = untold(execution);
  const int extent = extent_exponent(stack);
  for (;; ++bits) {
    work.go_on();
    // All doubles are multiples of 2^-1074 already.
    const int exponent = std::max(extent - bits, -1074);
    Snapper snapper(stack, exponent);
    const Result<void> valid = acceptable(stack, snapper.result().stack, trial);
    if (accepted(valid)) {
      snapper.result().lattice = std::ldexp(1, exponent);
      snapper.result().bits = extent - exponent;
      work.step_done();
      return std::move(snapper.result());
    }
    if (bits < kMostSnapBits) continue;
    Error error = valid.error();
    error.message = "no lattice keeps the stack valid; at 50 bits: " + error.message;
    return error;
  }
}

}  // namespace

Result<Snapped> snap(const SectionStack& stack, int bits, const Execution& given) {
  return guard_threads(
      given, [&](const Execution& execution) { return snap_all(stack, bits, execution); });
}

}  // namespace tetloft
