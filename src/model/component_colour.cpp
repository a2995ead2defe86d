#include "model/component_colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetloft::internal {

namespace {

constexpr std::array<Rgb, 12> kComponents{{{222, 196, 152},
                                           {84, 140, 168},
                                           {206, 108, 94},
                                           {126, 164, 108},
                                           {146, 118, 172},
                                           {228, 170, 78},
                                           {88, 166, 158},
                                           {196, 128, 160},
                                           {110, 124, 148},
                                           {168, 156, 82},
                                           {120, 176, 210},
                                           {168, 116, 84}}};

// Later rounds of the palette are darker, then lighter, by turns.
constexpr std::array<double, 4> kShade{1, 0.78, 1.14, 0.64};

static_assert(kComponents.size() * kShade.size() == kComponentColours);

}  // namespace

Rgb component_colour(std::size_t component) {
  const Rgb& base = kComponents[component % kComponents.size()];
  const double shade = kShade[component / kComponents.size() % kShade.size()];
  const auto shaded = [shade](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::lround(std::min(shade * value, 255.0)));
  };
  return {shaded(base.r), shaded(base.g), shaded(base.b)};
}

}  // namespace tetloft::internal
