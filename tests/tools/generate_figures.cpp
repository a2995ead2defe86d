// generate_figures FOLDER: writes the stacks of data/figures, each the subject of a figure of
// Nonato et al. (2000). Fig. 11(b) is data/terrain.cnt, Fig. 21 data/tooth.cnt.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/implicit.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::testing;

Contour circle(Point2 centre, double radius, std::size_t n = 24) {
  Contour contour = regular_polygon(centre, radius, n, 0.1);
  for (Point2& p : contour.vertices) p = {rounded(p.x), rounded(p.y)};
  return contour;
}

Contour ellipse(Point2 centre, double a, double b, std::size_t n = 32) {
  Contour contour = regular_polygon({0, 0}, 1, n, 0.1);
  for (Point2& p : contour.vertices) p = {rounded(centre.x + a * p.x), rounded(centre.y + b * p.y)};
  return contour;
}

SectionStack stack(std::vector<Layer> layers, double gap = 1) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < layers.size(); ++i) heights.push_back(gap * static_cast<double>(i));
  return stack_of(std::move(layers), heights);
}

// Fig. 1: which contours belong together? Two below, three above, one of them apart.
SectionStack correspondence() {
  return stack({{ellipse({-3, 0}, 2.4, 1.6), circle({3.2, 0}, 1.5)},
                {circle({-4, 0.1}, 1.1), circle({-1.9, -0.2}, 0.9), circle({3.4, 0.3}, 1.3)}},
               2);
}

// Fig. 6: skeletons that cross, hence reverse tets: two crossed bars.
SectionStack crossed_skeletons() {
  return stack({{ellipse({0, 0}, 4, 1.1)}, {ellipse({0.2, 0.1}, 1.2, 3.6)}}, 2);
}

// Fig. 9: what the subdivision parts: one contour below three.
SectionStack one_to_three() {
  return stack({{circle({0, 0}, 3, 36)},
                {circle(on_circle(2.1, 90), 1.1), circle(on_circle(2.1, 210), 1.1),
                 circle(on_circle(2.1, 330), 1.1)}},
               2);
}

// Fig. 11(a): a lying ring on four legs, with two handles on top.
SectionStack complex_object() {
  std::vector<Layer> layers;
  std::vector<double> heights;
  for (int i = 0; i < 24; ++i) {
    const double z = 0.2 + 0.45 * i;
    const Field field = [z](Point2 p) {
      const double around = std::hypot(p.x, p.y) - 5;
      double inside = 1.3 - std::hypot(around, z - 5.5);
      for (int leg = 0; leg < 4; ++leg) {
        const Point2 foot = on_circle(5 + 0.25 * (5.5 - z), 45 + 90 * leg);
        if (z < 5.5) inside = std::max(inside, 0.85 - std::hypot(p.x - foot.x, p.y - foot.y));
      }
      for (const double side : {-5.0, 5.0}) {
        const double ring = std::hypot(p.y, z - 7.4) - 2.1;
        inside = std::max(inside, 0.75 - std::hypot(ring, p.x - side));
      }
      return inside;
    };
    layers.push_back(level_set(field, 8, 0.4));
    heights.push_back(rounded(z));
  }
  return stack_of(std::move(layers), heights);
}

// Fig. 11(c): a vertebra: body, canal, arch, three processes.
SectionStack vertebra() {
  std::vector<Layer> layers;
  std::vector<double> heights;
  for (int i = 0; i < 16; ++i) {
    const double z = 0.3 + 0.6 * i;
    const auto lasting = [z](double from, double to) {
      return rounded_end(z, from, 1.2) * rounded_end(-z, -to, 1.2);
    };
    std::vector<Lobe> lobes;
    for (const double x : {-1.6, 0.0, 1.6}) {
      lobes.push_back({{x, 2.6 + 0.3 * (1.6 - std::abs(x))}, 2.1 * rounded_end(z, -1, 1.5)});
    }
    for (const double side : {-1.0, 1.0}) {
      lobes.push_back({{1.9 * side, 0.2}, 1.0 * lasting(4, 9)});
      lobes.push_back({{2.0 * side, -1.3}, 0.9 * lasting(2.6, 8.6)});
      lobes.push_back({{1.1 * side, -2.4}, 0.9 * lasting(2.2, 7.4)});
      lobes.push_back({{3.6 * side, -1.5}, 0.85 * lasting(4.2, 7.6)});
      lobes.push_back({{4.9 * side, -1.9}, 0.75 * lasting(4.6, 7.2)});
    }
    lobes.push_back({{0, -3.2}, 0.85 * lasting(1.6, 6.6)});
    lobes.push_back({{0, -4.6}, 0.8 * lasting(1.0, 5.4)});
    layers.push_back(level_set(
        [&](Point2 p) {
          return std::min(blended(lobes, p), 2 * (std::hypot(p.x, p.y + 0.5) - 1.2));
        },
        7, 0.35));
    heights.push_back(rounded(z));
  }
  return stack_of(std::move(layers), heights);
}

// Fig. 11(d): two lungs; the airway parts and runs into them, an island in a channel.
SectionStack lungs() {
  std::vector<Layer> layers;
  std::vector<double> heights;
  for (int i = 0; i < 20; ++i) {
    const double z = 0.3 + 0.7 * i;
    // The airway's distance from the middle: parted below z = 10.
    const double apart = 0.8 * std::max(0.0, 10 - z);
    const auto near_airway = [&](Point2 p) { return std::hypot(std::abs(p.x) - apart, p.y); };
    const double closing = rounded_end(z, 4.2, 1.0);
    const Field field = [&](Point2 p) {
      const double height = (z - 6.4) / 7;
      const double width = std::max(0.0, 1 - height * height);
      const double wide = 2.9 * std::sqrt(width), deep = 3.6 * std::sqrt(width);
      double lung = -1;
      if (wide > 0) lung = 1 - std::hypot((std::abs(p.x) - 4) / wide, p.y / deep);
      const double channel = near_airway(p) - 1.25 * closing;
      // The airway ends before its channel does, and so stays a piece of its own.
      const double airway = 0.62 * rounded_end(z, 5.7, 1.2) - near_airway(p);
      return std::max(std::min(lung, channel), airway);
    };
    layers.push_back(level_set(field, 8, 0.3));
    heights.push_back(rounded(z));
  }
  return stack_of(std::move(layers), heights);
}

// Fig. 15: one contour below, two above.
SectionStack bifurcation() {
  return stack({{ellipse({0, 0}, 4, 2, 36)}, {circle({-2.2, 0}, 1.5), circle({2.2, 0}, 1.5)}}, 2);
}

// Fig. 16: both sections branch: two bars below, two across them above.
SectionStack double_sided() {
  Layer below, above;
  for (const double side : {-1.0, 1.0}) {
    below.push_back(rectangle({-5, 3 * side - 1}, {5, 3 * side + 1}, 10));
    above.push_back(rectangle({3 * side - 1, -5}, {3 * side + 1, 5}, 10));
  }
  return stack({below, above}, 2);
}

// Fig. 17: branches of several sections: 1, 2, 3, 5.
SectionStack many_branches() {
  Layer five;
  for (int k = 0; k < 5; ++k) five.push_back(circle(on_circle(4.2, 90 + 72 * k), 1.2));
  return stack({{ellipse({0, 0}, 4.6, 4.2, 40)},
                {ellipse({-2.3, 0.4}, 2, 3.6), ellipse({2.3, 0.4}, 2, 3.6)},
                {ellipse({-3, 0.2}, 1.5, 2.2), ellipse({3, 0.2}, 1.5, 2.2), circle({0, 2.6}, 1.5),
                 ellipse({0, -2.9}, 2.4, 1.2)},
                five},
               2);
}

// Fig. 18 and 19: the left branch has drifted, so far that it overlaps nothing.
SectionStack drifted() {
  return stack({{ellipse({0, 0}, 4, 2, 36)}, {circle({-5.8, 1.4}, 1.5), circle({2.2, 0}, 1.5)}}, 2);
}
SectionStack drifting() {
  return stack({{ellipse({0, 0}, 4, 2, 36)}, {circle({-4.2, 0.9}, 1.5), circle({2.2, 0}, 1.5)}}, 2);
}

// Fig. 20: a contour that overlaps nothing.
SectionStack isolated() {
  return stack({{circle({-2, 0}, 2)},
                {circle({-2, 0.2}, 2.1), circle({4, 0}, 1.2)},
                {circle({-1.8, 0.2}, 1.9)}},
               1.5);
}

// Fig. 22: a thorax: its wall, and in it lungs and heart.
SectionStack thorax() {
  std::vector<Layer> layers;
  for (int i = 0; i < 12; ++i) {
    const double z = i;
    const double wide = 6.6 - 0.03 * (z - 6) * (z - 6);
    Layer layer{ellipse({0, 0}, wide, 0.68 * wide, 48),
                ellipse({0, 0.1}, wide - 0.8, 0.58 * wide, 44)};
    const double lung = std::sqrt(std::max(0.0, 1 - (z - 5.4) * (z - 5.4) / 27));
    if (lung > 0.2) {
      for (const double side : {-1.0, 1.0}) {
        layer.push_back(ellipse({3.0 * side, 0.2}, 1.7 * lung, 2.6 * lung, 32));
      }
    }
    const double heart = std::sqrt(std::max(0.0, 1 - (z - 4.4) * (z - 4.4) / 8));
    if (heart > 0.2) layer.push_back(ellipse({0.15, -0.9}, 0.95 * heart, 1.3 * heart, 24));
    layers.push_back(std::move(layer));
  }
  return stack(std::move(layers));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: generate_figures FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  const std::vector<std::pair<const char*, SectionStack (*)()>> all{
      {"fig01_correspondence.cnt", correspondence},
      {"fig06_reverse.cnt", crossed_skeletons},
      {"fig09_subdivision.cnt", one_to_three},
      {"fig11a_complex.cnt", complex_object},
      {"fig11c_vertebra.cnt", vertebra},
      {"fig11d_lungs.cnt", lungs},
      {"fig15_bifurcation.cnt", bifurcation},
      {"fig16_double_sided.cnt", double_sided},
      {"fig17_branches.cnt", many_branches},
      {"fig18_drifting.cnt", drifting},
      {"fig19_drifted.cnt", drifted},
      {"fig20_isolated.cnt", isolated},
      {"fig22_thorax.cnt", thorax}};
  for (const auto& [name, make] : all) {
    if (!write_sample(folder, name, make())) return 1;
  }
  return 0;
}
