// The colours of components, the same in pictures and in files.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tetloft::internal {

/// sRGB.
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
};

/// So many colours differ; after these they are the same again.
inline constexpr std::size_t kComponentColours = 48;
/// Neighbouring numbers get colours that are well apart.
[[nodiscard]] Rgb component_colour(std::size_t component);

}  // namespace tetloft::internal
