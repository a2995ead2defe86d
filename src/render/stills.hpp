// Pictures of one model from several sides.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <tetloft/render.hpp>

#include "core/watched_work.hpp"

namespace tetloft::internal::render {

/// Where the eye stands, in degrees as in RenderOptions.
struct Side {
  double azimuth = 0;
  double elevation = 0;
};

struct Still {
  std::string bytes;  ///< of an SVG, or of a PNG
  bool is_svg = false;
  double pixels = 0;  ///< for a unit of length across the direction of view
};

/// A model of at most this many triangles, faces of tets on its surface, is drawn as SVG: below it
/// that is about as small as the PNG, and sharp at any size.
inline constexpr std::size_t kMostSvgTriangles = 1200;

/// Contours that are nearer than lines can show are left out. Errors as render_png(); `options.cut`
/// is not looked at. Tells `work` of one step more than there are sides.
[[nodiscard]] Result<std::vector<Still>> render_stills(const Model& model,
                                                       const SectionStack* contours,
                                                       const RenderOptions& options,
                                                       std::span<const Side> sides,
                                                       WatchedWork& work);

}  // namespace tetloft::internal::render
