// Still pictures as the bytes of files.
#pragma once

#include <cstddef>
#include <string>

#include <tetloft/render.hpp>

#include "core/watched_work.hpp"
#include "render/raster.hpp"
#include "render/scene.hpp"

namespace tetloft::internal::render {

/// Without an alpha channel where `opaque`.
[[nodiscard]] std::string png_bytes(const Picture& picture, bool opaque);

/// The scene as an <svg> element. Tells `work` of kSvgSteps steps.
[[nodiscard]] std::string svg_text(const Scene& scene, const RenderOptions& options,
                                   WatchedWork& work);
inline constexpr std::size_t kSvgSteps = 3;

}  // namespace tetloft::internal::render
