// Projection, and light.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/raster.hpp"
#include "render/vector.hpp"

namespace tetloft::internal::render {

Point3 View::toward(const RenderOptions& options) {
  const double azimuth = options.azimuth * std::numbers::pi / 180;
  const double elevation = options.elevation * std::numbers::pi / 180;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

View::View(const Scene& scene, const RenderOptions& options) : toward_(toward(options)) {
  const double azimuth = options.azimuth * std::numbers::pi / 180;
  right_ = {-std::sin(azimuth), std::cos(azimuth), 0};
  up_ = cross(toward_, right_);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double left = kInfinity, bottom = kInfinity, right = -kInfinity, top = -kInfinity;
  const auto include = [&](const Point3& p) {
    left = std::min(left, dot(p, right_));
    right = std::max(right, dot(p, right_));
    bottom = std::min(bottom, dot(p, up_));
    top = std::max(top, dot(p, up_));
  };
  for (const SceneTriangle& triangle : scene.triangles) {
    for (const Point3& p : triangle.corner) include(p);
  }
  for (const auto& line : scene.lines) {
    for (const Point3& p : line) include(p);
  }
  if (!(left <= right)) left = right = bottom = top = 0;
  constexpr double kFilled = 0.92;
  const double across = std::max(right - left, std::numeric_limits<double>::min());
  const double along = std::max(top - bottom, std::numeric_limits<double>::min());
  scale_ = kFilled * std::min(options.width / across, options.height / along);
  if (!std::isfinite(scale_)) scale_ = 1;
  x_ = options.width / 2.0 - scale_ * (left + right) / 2;
  y_ = options.height / 2.0 + scale_ * (bottom + top) / 2;
}

Projected View::project(const Point3& p) const {
  // float32 must hold the depth of needles that point to the eye.
  constexpr double kFarthest = 1e30;
  return {x_ + scale_ * dot(p, right_), y_ - scale_ * dot(p, up_),
          std::clamp(scale_ * dot(p, toward_), -kFarthest, kFarthest)};
}

Point3 View::turned(const Point3& vector) const {
  return {dot(vector, right_), dot(vector, up_), dot(vector, toward_)};
}

View View::enlarged(double times) const {
  View view = *this;
  view.scale_ *= times;
  view.x_ *= times;
  view.y_ *= times;
  return view;
}

std::vector<float> openness(const ItemBuffer& items, const Scene& scene, const View& view) {
  constexpr std::size_t kDirections = 12;
  constexpr std::size_t kSteps = 5;
  const double radius = 0.07 * static_cast<double>(std::max(items.width, items.height));
  std::array<std::array<std::array<double, 2>, kSteps>, kDirections> away;
  for (std::size_t d = 0; d < kDirections; ++d) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(d) + 0.5) / kDirections;
    for (std::size_t s = 0; s < kSteps; ++s) {
      const double length = radius * static_cast<double>((s + 1) * (s + 1)) / (kSteps * kSteps);
      away[d][s] = {std::round(length * std::cos(angle)), std::round(length * std::sin(angle))};
    }
  }
  std::vector<float> open(items.item.size(), 1);
  for (std::size_t y = 0; y < items.height; ++y) {
    for (std::size_t x = 0; x < items.width; ++x) {
      const std::size_t at = items.at(x, y);
      if (items.item[at] == ItemBuffer::kNothing) continue;
      const auto& corner = scene.triangles[items.item[at]].corner;
      const Point3 normal = view.turned(unit(cross(corner[1] - corner[0], corner[2] - corner[0])));
      double hidden = 0;
      for (const auto& direction : away) {
        double horizon = 0;
        for (const auto& [dx, dy] : direction) {
          const double sx = static_cast<double>(x) + dx;
          const double sy = static_cast<double>(y) + dy;
          if (sx < 0 || sy < 0 || sx >= static_cast<double>(items.width) ||
              sy >= static_cast<double>(items.height)) {
            break;
          }
          const std::size_t there =
              items.at(static_cast<std::size_t>(sx), static_cast<std::size_t>(sy));
          if (items.item[there] == ItemBuffer::kNothing) continue;
          const Point3 v{dx, -dy, static_cast<double>(items.depth[there] - items.depth[at])};
          const double square = dot(v, v);
          if (square == 0 || square > 4 * radius * radius) continue;
          const double fall = 1 - square / (4 * radius * radius);
          horizon = std::max(horizon, (dot(v, normal) / std::sqrt(square) - 0.12) * fall);
        }
        hidden += horizon;
      }
      open[at] = static_cast<float>(1 - hidden / kDirections);
    }
  }
  return open;
}

double line_width(const Scene& scene, const View& view) {
  return std::min(1.7, 0.3 * view.pixels(scene.line_gap));
}

Light linear(const Rgb& colour) {
  const auto one = [](std::uint8_t value) {
    const double s = value / 255.0;
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
  };
  return {one(colour.r), one(colour.g), one(colour.b)};
}

std::uint8_t encoded(float light) {
  const double l = std::clamp(static_cast<double>(light), 0.0, 1.0);
  const double s = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * s));
}

Light lit(const Rgb& colour, const Point3& normal, float openness) {
  const Point3 key = unit({-0.45, 0.6, 0.66});
  const Point3 fill = unit({0.75, 0.1, 0.65});
  const Point3 half = unit(key + Point3{0, 0, 1});
  const double ambient = (0.30 + 0.12 * normal.y) * openness * openness;
  const double direct = 0.68 * std::max(0.0, dot(normal, key)) * (0.35 + 0.65 * openness);
  const double second = 0.16 * std::max(0.0, dot(normal, fill)) * openness;
  double gloss = std::max(0.0, dot(normal, half));
  for (int k = 0; k < 5; ++k) gloss *= gloss;
  const auto diffuse = static_cast<float>(ambient + direct + second);
  const auto shine = static_cast<float>(0.05 * gloss);
  const Light base = linear(colour);
  return {base.r * diffuse + shine, base.g * diffuse + shine, base.b * diffuse + shine};
}

}  // namespace tetloft::internal::render
