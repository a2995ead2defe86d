// Still pictures: parallel projection, an item buffer, and light.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <tetloft/render.hpp>

#include "core/watched_work.hpp"
#include "render/scene.hpp"

namespace tetloft::render {

/// On the picture: pixels from its upper left corner, and height towards the eye, in pixels.
struct Projected {
  double x = 0, y = 0, depth = 0;
};

/// A parallel projection that fits a scene into a picture.
class View {
 public:
  /// The direction in which the eye stands.
  [[nodiscard]] static Point3 toward(const RenderOptions& options);

  View(const Scene& scene, const RenderOptions& options);
  [[nodiscard]] Projected project(const Point3& p) const;
  /// x to the right, y up, z to the eye.
  [[nodiscard]] Point3 turned(const Point3& vector) const;
  /// Pixels for a length across the direction of view.
  [[nodiscard]] double pixels(double length) const { return scale_ * length; }
  /// The picture enlarged `times`.
  [[nodiscard]] View enlarged(double times) const;

 private:
  Point3 right_, up_, toward_;
  double scale_ = 1;
  double x_ = 0, y_ = 0;
};

/// For each pixel the triangle that is seen there.
struct ItemBuffer {
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
  std::size_t width = 0, height = 0;
  std::vector<std::uint32_t> item;
  std::vector<float> depth;

  [[nodiscard]] std::size_t at(std::size_t x, std::size_t y) const { return y * width + x; }
};
[[nodiscard]] ItemBuffer draw_items(const Scene& scene, const View& view, std::size_t width,
                                    std::size_t height);

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

}  // namespace tetloft::render
