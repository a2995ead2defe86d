// generate_samples FOLDER: writes the generated samples of data/, sections of implicit
// solids: tooth.cnt, bifurcation.cnt, torus.cnt.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "support/stacks/bitmap.hpp"
#include "support/stacks/shapes.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::testing;

/// Positive inside.
using Field = std::function<double(Point2 p)>;

// Rounding to thousandths keeps the files short and the same whatever the last bits of a
// mathematical library are.
double rounded(double x) { return std::round(1000 * x) / 1000; }

// The outlines of field > 0 in [−size, size]², traced on a grid of the given step.
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

// A disc of a cross section. Radius 0: absent.
struct Lobe {
  Point2 centre;
  double radius = 0;
};

// Union of discs, blended: positive inside, about the distance in radii.
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

// Smooth from 0 at `from` to 1 at `to`.
double ramp(double z, double from, double to) {
  const double t = std::clamp((z - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// The radius of a rounded end: 0 at `tip`, 1 from `tip` + `length` on.
double rounded_end(double z, double tip, double length) {
  const double t = std::clamp((z - tip) / length, 0.0, 1.0);
  return std::sqrt(t * (2 - t));
}

Point2 on_circle(double radius, double degrees) {
  return {radius * std::cos(degrees * kPi / 180), radius * std::sin(degrees * kPi / 180)};
}

// A molar: three roots that join below the crown, four cusps on top, and inside a pulp
// chamber with three canals. Heights in millimetres from the longest root's tip.
std::vector<Lobe> tooth_surface(double z) {
  std::vector<Lobe> lobes;
  for (int root = 0; root < 3; ++root) {
    const double tip = 0.6 * root;
    const double away = 4.4 - 2.4 * ramp(z, 0, 9);
    const double radius = (0.7 + 1.9 * ramp(z, 0, 10)) * rounded_end(z, tip, 1.5);
    lobes.push_back({on_circle(away, 90 + 120 * root), radius * (1 - ramp(z, 12, 15))});
  }
  for (int cusp = 0; cusp < 4; ++cusp) {
    const double away = 2.3 + 0.3 * ramp(z, 10, 15) + 0.3 * ramp(z, 16, 19);
    const double top = 19 + 0.4 * (cusp % 2);
    const double radius = 2.9 * ramp(z, 7, 13) * rounded_end(-z, -top, 5);
    lobes.push_back({on_circle(away, 45 + 90 * cusp), radius});
  }
  // The middle closes where roots or cusps join, without pits.
  lobes.push_back({{0, 0}, 2.4 * ramp(z, 5.4, 7) * rounded_end(-z, -18.2, 3)});
  return lobes;
}

std::vector<Lobe> tooth_pulp(double z) {
  std::vector<Lobe> lobes;
  for (int root = 0; root < 3; ++root) {
    const double tip = 2 + 0.6 * root;
    const double away = 4.4 - 2.4 * ramp(z, 0, 9) - 1.2 * ramp(z, 8, 11);
    const double radius = 0.45 + 0.4 * ramp(z, 4, 10);
    lobes.push_back({on_circle(away, 90 + 120 * root),
                     radius * rounded_end(z, tip, 1) * rounded_end(-z, -13, 2)});
  }
  lobes.push_back({{0, 0}, 1.5 * rounded_end(z, 9, 0.6) * rounded_end(-z, -14, 2)});
  return lobes;
}

// A tube that parts twice: 1, 2, 4.
std::vector<Lobe> bifurcating_tube(double z) {
  std::vector<Lobe> lobes;
  const double first = 3.2 * ramp(z, 1, 6);
  const double second = 2 * ramp(z, 6, 11);
  for (const double side : {-1.0, 1.0}) {
    for (const double twig : {-1.0, 1.0}) {
      lobes.push_back({{side * (first + 0.4 * second), twig * second}, 2 - 0.07 * z});
    }
  }
  return lobes;
}

Layer sections_of(const std::vector<Lobe>& lobes, double size, double step) {
  return level_set([&](Point2 p) { return blended(lobes, p); }, size, step);
}

SectionStack tooth() {
  std::vector<Layer> layers;
  std::vector<double> heights;
  for (int i = 0; i < 30; ++i) {
    const double z = 0.25 + 0.65 * i;
    Layer layer = sections_of(tooth_surface(z), 7, 0.4);
    append(layer, sections_of(tooth_pulp(z), 7, 0.2));
    layers.push_back(std::move(layer));
    heights.push_back(rounded(z));
  }
  return stack_of(std::move(layers), heights);
}

SectionStack bifurcation() {
  std::vector<Layer> layers;
  std::vector<double> heights;
  for (int z = 0; z <= 12; ++z) {
    layers.push_back(sections_of(bifurcating_tube(z), 8, 0.4));
    heights.push_back(z);
  }
  return stack_of(std::move(layers), heights);
}

// Standing, its axis along x: sections of one, two and one contours.
SectionStack torus() {
  constexpr double kLarge = 5;
  constexpr double kSmall = 2;
  std::vector<Layer> layers;
  std::vector<double> heights;
  for (int i = 0; i < 20; ++i) {
    const double z = 0.7 * i - 6.65;
    const Field field = [&](Point2 p) {
      return kSmall - std::hypot(std::hypot(p.y, z) - kLarge, p.x);
    };
    layers.push_back(level_set(field, 8, 0.4));
    heights.push_back(rounded(z));
  }
  return stack_of(std::move(layers), heights);
}

bool write(const std::string& folder, const char* name, const SectionStack& stack) {
  const Result<void> valid = validate(stack);
  const Result<void> written = valid ? write_cnt(folder + "/" + name, stack) : valid;
  if (!written) std::fprintf(stderr, "%s: %s\n", name, to_string(written.error()).c_str());
  return written.ok();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: generate_samples FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  const bool good = write(folder, "tooth.cnt", tooth()) &&
                    write(folder, "bifurcation.cnt", bifurcation()) &&
                    write(folder, "torus.cnt", torus());
  return good ? 0 : 1;
}
