#include "io/length_unit.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/text.hpp"

namespace tetloft::internal::io {

namespace {

struct NamedLength {
  std::string_view name;
  double metres;
};

constexpr std::array kLengths{NamedLength{"pm", 1e-12},        NamedLength{"angstrom", 1e-10},
                              NamedLength{"nm", 1e-9},         NamedLength{"nanometer", 1e-9},
                              NamedLength{"um", 1e-6},         NamedLength{"µm", 1e-6},
                              NamedLength{"μm", 1e-6},         NamedLength{"micron", 1e-6},
                              NamedLength{"micrometer", 1e-6}, NamedLength{"mm", 1e-3},
                              NamedLength{"millimeter", 1e-3}, NamedLength{"cm", 1e-2},
                              NamedLength{"centimeter", 1e-2}, NamedLength{"m", 1},
                              NamedLength{"meter", 1},         NamedLength{"km", 1000},
                              NamedLength{"kilometer", 1000},  NamedLength{"in", 0.0254},
                              NamedLength{"inch", 0.0254},     NamedLength{"ft", 0.3048},
                              NamedLength{"foot", 0.3048}};

}  // namespace

std::optional<double> metres_in(std::string_view unit) {
  std::string name = lower_case(unit);
  if (name.ends_with("metre")) name.replace(name.size() - 2, 2, "er");
  const auto* const known = std::find_if(kLengths.begin(), kLengths.end(),
                                         [&](const NamedLength& l) { return l.name == name; });
  if (known == kLengths.end()) return std::nullopt;
  return known->metres;
}

}  // namespace tetloft::internal::io
