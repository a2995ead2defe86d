// The item buffer: for each pixel the triangle that is seen there (Weghorst, Hooper and Greenberg
// 1984), and where nothing farther can be seen (Greene, Kass and Miller 1993).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/scene.hpp"
#include "render/view.hpp"

namespace tetloft::internal::render {

/// A square of pixels knows the depth of the farthest it shows: what lies behind it is hidden.
/// Squares of 8 × 8 pixels, and of 2 × 2 squares each, up to one.
class DepthPyramid {
 public:
  static constexpr std::size_t kSide = 8;
  struct Level {
    std::size_t width = 0, height = 0;
    std::vector<float> farthest;  ///< −∞ where a pixel shows nothing
  };

  DepthPyramid(std::size_t width, std::size_t height);
  [[nodiscard]] const std::vector<Level>& levels() const { return level_; }
  /// Whether all of the pixels [x0, x1) × [y0, y1) show something at `nearest` or nearer, as far as
  /// the squares tell. Time O(1).
  [[nodiscard]] bool hides(std::size_t x0, std::size_t y0, std::size_t x1, std::size_t y1,
                           float nearest) const;
  /// The farthest of a square of level 0 became nearer.
  void raise(std::size_t x, std::size_t y, float farthest);

 private:
  std::vector<Level> level_;
};

struct ItemBuffer {
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
  std::size_t width, height;
  std::vector<std::uint32_t> item;
  std::vector<float> depth;  ///< −∞ where nothing is seen
  DepthPyramid pyramid;
  std::uint64_t visits = 0;  ///< pixels, rows and squares that were looked at: the time it took

  ItemBuffer(std::size_t width, std::size_t height);
  [[nodiscard]] std::size_t at(std::size_t x, std::size_t y) const { return y * width + x; }
};

/// Of triangles that are equally near the one that reaches nearer to the eye is seen, then the
/// first. Time O(n log n) for n triangles and O(1) for each pixel that they cover, but for what
/// nearer ones hide by whole squares: neither the boxes of needles nor layers behind each other
/// cost more.
[[nodiscard]] ItemBuffer draw_items(const Scene& scene, const View& view, std::size_t width,
                                    std::size_t height);

}  // namespace tetloft::internal::render
