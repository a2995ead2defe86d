// The picture: several samples a pixel, lines, edges.
#include <algorithm>
#include <cmath>
#include <utility>

#include "render/raster.hpp"
#include "render/vector.hpp"

namespace tetloft::internal::render {

namespace {

constexpr double kEdgeWidth = 0.75;  // pixels
constexpr float kEdgeStrength = 0.5F;

std::size_t samples_across(const RenderOptions& options) {
  const double pixels = static_cast<double>(options.width) * options.height;
  return pixels <= 4e6 ? 3 : pixels <= 16e6 ? 2 : 1;
}

// Light changes slowly: of large pictures it is found for blocks of pixels of this side.
std::size_t light_block(const RenderOptions& options) {
  constexpr double kMost = 4e6;
  const double pixels = static_cast<double>(options.width) * options.height;
  return static_cast<std::size_t>(std::ceil(std::sqrt(pixels / kMost)));
}

// Samples that show a line. Time O(1) for each row that a line crosses, and each sample on it.
class LinePainter {
 public:
  LinePainter(const View& view, const ItemBuffer& items, double width)
      : view_(view),
        items_(items),
        reach_(width / 2),
        lift_(kLineLift * static_cast<double>(std::max(items.width, items.height))),
        drawn_(items.item.size(), 0) {}

  void paint(const std::array<Point3, 2>& line) {
    const Projected a = view_.project(line[0]);
    const Projected b = view_.project(line[1]);
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double left = std::min(a.x, b.x) - reach_;
    const double right = std::max(a.x, b.x) + reach_ + 1;
    const std::size_t y0 = clamped(std::min(a.y, b.y) - reach_, items_.height);
    const std::size_t y1 = clamped(std::max(a.y, b.y) + reach_ + 1, items_.height);
    const std::size_t x0 = clamped(left, items_.width);
    const std::size_t x1 = clamped(right, items_.width);
    const auto nearest = static_cast<float>(std::max(a.depth, b.depth) + lift_);
    if (x0 >= x1 || y0 >= y1 || items_.pyramid.hides(x0, y0, x1, y1, nearest)) return;
    for (std::size_t y = y0; y < y1; ++y) {
      const double py = static_cast<double>(y) + 0.5 - a.y;
      // Where the row meets the strip of points near the whole straight line; of one that rises by
      // less than can be seen, all of the row, since a division would leave no digits of it.
      const bool crosses = std::abs(dy) > 1e-6;
      const double middle = crosses ? a.x + dx * py / dy : a.x;
      const double half = crosses ? reach_ * std::sqrt(square) / std::abs(dy) + 1 : right - left;
      const std::size_t begin = std::max(x0, clamped(middle - half, items_.width));
      const std::size_t end = std::min(x1, clamped(middle + half + 1, items_.width));
      for (std::size_t x = begin; x < end; ++x) {
        const std::size_t at = items_.at(x, y);
        if (drawn_[at] != 0) continue;
        const double px = static_cast<double>(x) + 0.5 - a.x;
        const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
        const double ox = px - t * dx;
        const double oy = py - t * dy;
        if (ox * ox + oy * oy > reach_ * reach_) continue;
        const double depth = a.depth + t * (b.depth - a.depth) + lift_;
        if (items_.depth[at] > depth) continue;
        drawn_[at] = 1;
      }
    }
  }
  [[nodiscard]] std::vector<std::uint8_t> drawn() { return std::move(drawn_); }

 private:
  [[nodiscard]] static std::size_t clamped(double value, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(size)));
  }

  const View& view_;
  const ItemBuffer& items_;
  double reach_, lift_;
  std::vector<std::uint8_t> drawn_;
};

struct Sampled {
  Point3 normal;
  bool on_edge = false;
};

Sampled sample(const SceneTriangle& triangle, const View& view, double px, double py,
               double edge_reach) {
  std::array<Projected, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = view.project(triangle.corner[i]);
  const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  Sampled result;
  Point3 normal{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Projected& a = p[(i + 1) % 3];
    const Projected& b = p[(i + 2) % 3];
    const double twice = (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x);
    normal = normal + (twice / area) * triangle.normal[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    // The side opposite corner i begins at corner i + 1.
    if ((triangle.outline >> (i + 1) % 3 & 1) != 0 && std::abs(twice) < edge_reach * length) {
      result.on_edge = true;
    }
  }
  result.normal = view.turned(unit(normal));
  return result;
}

}  // namespace

Picture draw(const Scene& scene, const RenderOptions& options, WatchedWork& work) {
  const auto width = static_cast<std::size_t>(options.width);
  const auto height = static_cast<std::size_t>(options.height);
  const View view(scene, options);
  const std::size_t across = samples_across(options);
  const View fine = view.enlarged(static_cast<double>(across));
  const std::size_t block = light_block(options);
  const ItemBuffer coarse = draw_items(scene, view.enlarged(1 / static_cast<double>(block)),
                                       (width + block - 1) / block, (height + block - 1) / block);
  work.step_done_go_on();
  const std::vector<float> open = openness(coarse, scene, view);
  work.step_done_go_on();
  const ItemBuffer items = draw_items(scene, fine, width * across, height * across);
  work.step_done_go_on();
  LinePainter line_painter(fine, items, line_width(scene, view) * static_cast<double>(across));
  for (const auto& line : scene.lines) line_painter.paint(line);
  const std::vector<std::uint8_t> lines = line_painter.drawn();
  work.step_done_go_on();
  const double edge_reach = options.edges ? kEdgeWidth / 2 * static_cast<double>(across) : -1.0;
  const Light ink = linear(kContourColour);

  Picture picture{width, height, {}};
  picture.pixel.resize(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    work.go_on();
    for (std::size_t x = 0; x < width; ++x) {
      Light sum;
      float covered = 0;
      for (std::size_t k = 0; k < across * across; ++k) {
        const std::size_t sx = x * across + k % across;
        const std::size_t sy = y * across + k / across;
        const std::size_t at = items.at(sx, sy);
        Light light;
        if (lines[at] != 0) {
          light = ink;
        } else if (items.item[at] != ItemBuffer::kNothing) {
          const SceneTriangle& triangle = scene.triangles[items.item[at]];
          const Sampled s = sample(triangle, fine, static_cast<double>(sx) + 0.5,
                                   static_cast<double>(sy) + 0.5, edge_reach);
          light = lit(triangle.colour, s.normal, open[coarse.at(x / block, y / block)]);
          if (s.on_edge) {
            const auto mixed = [](float a, float b) {
              return (1 - kEdgeStrength) * a + kEdgeStrength * b;
            };
            light = {mixed(light.r, ink.r), mixed(light.g, ink.g), mixed(light.b, ink.b)};
          }
        } else {
          continue;
        }
        sum = {sum.r + light.r, sum.g + light.g, sum.b + light.b};
        covered += 1;
      }
      auto& pixel = picture.pixel[y * width + x];
      const auto all = static_cast<float>(across * across);
      if (options.white) {
        const float ground = (all - covered) / all;
        pixel = {encoded(sum.r / all + ground), encoded(sum.g / all + ground),
                 encoded(sum.b / all + ground), 255};
      } else if (covered > 0) {
        pixel = {encoded(sum.r / covered), encoded(sum.g / covered), encoded(sum.b / covered),
                 static_cast<std::uint8_t>(std::lround(255 * covered / all))};
      }
    }
  }
  work.step_done();
  return picture;
}

}  // namespace tetloft::internal::render
