// generate_samples FOLDER: writes the generated samples of data/, sections of implicit
// solids: tooth.cnt, bifurcation.cnt, torus.cnt.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "tools/implicit.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::testing;

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

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: generate_samples FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  const bool good = write_sample(folder, "tooth.cnt", tooth()) &&
                    write_sample(folder, "bifurcation.cnt", bifurcation()) &&
                    write_sample(folder, "torus.cnt", torus());
  return good ? 0 : 1;
}
