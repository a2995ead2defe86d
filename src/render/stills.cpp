// Without a cut the scene is the same from all sides: it is made once.
#include "render/stills.hpp"

#include <cmath>
#include <utility>

#include "render/encoders.hpp"
#include "render/raster.hpp"
#include "render/scene.hpp"
#include "render/view.hpp"

namespace tetloft::internal::render {

namespace {

// Pixels between contours: nearer ones would hide the surface.
constexpr double kLeastLineGap = 3;

}  // namespace

Result<std::vector<Still>> render_stills(const Model& model, const SectionStack* contours,
                                         const RenderOptions& options, std::span<const Side> sides,
                                         WatchedWork& work) {
  RenderOptions each = options;
  each.cut.reset();
  auto scene = scene_of(model, contours, View::toward(each), each);
  if (!scene) return scene.error();
  if (View(*scene, each).pixels(scene->line_gap) < kLeastLineGap) scene->lines.clear();
  work.step_done_go_on();
  // The steps of one picture are no steps of the whole.
  const Execution untold_steps = untold(options.execution);
  std::vector<Still> stills;
  for (const Side& side : sides) {
    each.azimuth = side.azimuth;
    each.elevation = side.elevation;
    WatchedWork drawing(untold_steps, 0);
    Still still;
    still.is_svg = scene->triangles.size() <= kMostSvgTriangles;
    still.bytes = still.is_svg ? svg_text(*scene, each, drawing)
                               : png_bytes(draw(*scene, each, drawing), each.white);
    still.pixels = std::ldexp(View(*scene, each).pixels(1), -scene->exponent);
    stills.push_back(std::move(still));
    work.step_done_go_on();
  }
  return stills;
}

}  // namespace tetloft::internal::render
