// Still pictures: lines, and light.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <tetloft/render.hpp>

#include "core/watched_work.hpp"
#include "render/items.hpp"
#include "render/scene.hpp"
#include "render/view.hpp"

namespace tetloft::internal::render {

/// Lines lie on surfaces: they are seen up to this far behind, in parts of the picture's larger
/// side.
inline constexpr double kLineLift = 0.004;
/// The width of lines in pixels: thinner where they are dense, and would cover the surface.
[[nodiscard]] double line_width(const Scene& scene, const View& view);

/// How much light reaches each pixel that shows a triangle: 1 in the open, less in hollows
/// (ambient occlusion by horizons, after Bavoil and Sainz 2008).
[[nodiscard]] std::vector<float> openness(const ItemBuffer& items, const Scene& scene,
                                          const View& view);

/// Linear light.
struct Light {
  float r = 0, g = 0, b = 0;
};
[[nodiscard]] Light linear(const Rgb& colour);
[[nodiscard]] std::uint8_t encoded(float light);
/// The colour of a surface of this unit normal (in the view's axes).
[[nodiscard]] Light lit(const Rgb& colour, const Point3& normal, float openness);

/// Pixels by row, not premultiplied.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 4>> pixel;  ///< r, g, b, alpha
};
/// Tells `work` of kDrawSteps steps.
[[nodiscard]] Picture draw(const Scene& scene, const RenderOptions& options, WatchedWork& work);
inline constexpr std::size_t kDrawSteps = 5;

}  // namespace tetloft::internal::render
