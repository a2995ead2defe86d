#include "tools/implicit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <tetloft/io.hpp>

#include "support/stacks/bitmap.hpp"

namespace tetloft::testing {

double rounded(double x) { return std::round(1000 * x) / 1000; }

Layer level_set(const Field& field, double size, double step) {
  const int n = static_cast<int>(std::ceil(2 * size / step)) + 1;
  const auto at = [&](int x, int y) { return Point2{step * x - size, step * y - size}; };
  Bitmap inside(n, n);
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) inside.set(x, y, field(at(x, y)) > 0);
  }
  return marching_squares(inside, true, [&](int x2, int y2) {
    // Linear interpolation on the lattice edge, kept off its ends: two crossings near one
    // lattice point would round to the same vertex.
    const Point2 a = at(x2 / 2, y2 / 2);
    const Point2 b = at((x2 + 1) / 2, (y2 + 1) / 2);
    const double fa = field(a);
    const double t = std::clamp(fa / (fa - field(b)), 0.1, 0.9);
    return Point2{rounded(a.x + t * (b.x - a.x)), rounded(a.y + t * (b.y - a.y))};
  });
}

double blended(const std::vector<Lobe>& lobes, Point2 p) {
  constexpr double kSharpness = 6;
  double sum = 0;
  for (const Lobe& lobe : lobes) {
    if (lobe.radius <= 0) continue;
    const double distance = std::hypot(p.x - lobe.centre.x, p.y - lobe.centre.y);
    sum += std::exp(kSharpness * (1 - distance / lobe.radius));
  }
  return std::log(std::max(sum, 1e-300));
}

double ramp(double z, double from, double to) {
  const double t = std::clamp((z - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double rounded_end(double z, double tip, double length) {
  const double t = std::clamp((z - tip) / length, 0.0, 1.0);
  return std::sqrt(t * (2 - t));
}

Point2 on_circle(double radius, double degrees) {
  return {radius * std::cos(degrees * kPi / 180), radius * std::sin(degrees * kPi / 180)};
}

Layer sections_of(const std::vector<Lobe>& lobes, double size, double step) {
  return level_set([&](Point2 p) { return blended(lobes, p); }, size, step);
}

bool write_sample(const std::string& folder, const char* name, const SectionStack& stack) {
  const Result<void> valid = validate(stack);
  const Result<void> written = valid ? write_cnt(folder + "/" + name, stack) : valid;
  if (!written) std::fprintf(stderr, "%s: %s\n", name, to_string(written.error()).c_str());
  return written.ok();
}

}  // namespace tetloft::testing
