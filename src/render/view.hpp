// Parallel projection.
#pragma once

#include <tetloft/render.hpp>

#include "render/scene.hpp"

namespace tetloft::internal::render {

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

}  // namespace tetloft::internal::render
