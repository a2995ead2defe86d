// Pictures of models.
#include <tetloft/io.hpp>
#include <tetloft/render.hpp>

#include <array>
#include <filesystem>
#include <string_view>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"
#include "c/structs.hpp"
#include "core/text.hpp"

namespace tetloft::internal::c {

namespace {

tetloft_render_options default_render_options() {
  const RenderOptions defaults;
  tetloft_render_options options{};
  options.version = TETLOFT_RENDER_OPTIONS_VERSION;
  options.colour = static_cast<std::int32_t>(defaults.colour);
  options.azimuth = defaults.azimuth;
  options.elevation = defaults.elevation;
  options.width = defaults.width;
  options.height = defaults.height;
  options.cut_axis = -1;
  options.explode = defaults.explode;
  options.stretch = defaults.stretch;
  options.edges = defaults.edges ? 1 : 0;
  options.contours = defaults.contours ? 1 : 0;
  options.white = defaults.white ? 1 : 0;
  return options;
}

int side_of(std::int32_t pixels, const char* field) {
  if (pixels < 1 || pixels > kLargestPictureSide) {
    fail_usage("render options: " + std::string(field) + " is " + std::to_string(pixels) +
               ", not 1 to " + std::to_string(kLargestPictureSide));
  }
  return pixels;
}

RenderOptions render_options_of(const tetloft_render_options* options) {
  if (options == nullptr) return {};
  require_version(*options, TETLOFT_RENDER_OPTIONS_VERSION, "render options");
  RenderOptions result;
  result.colour = enumerator_of(options->colour, ColourBy::evidence, "render options: colour");
  result.azimuth = options->azimuth;
  result.elevation = options->elevation;
  result.width = side_of(options->width, "width");
  result.height = side_of(options->height, "height");
  if (options->cut_axis != -1) {
    if (options->cut_axis < 0 || options->cut_axis > 2) {
      fail_usage("render options: cut_axis is " + std::to_string(options->cut_axis) +
                 ", which is none of -1 to 2");
    }
    result.cut = PictureCut{options->cut_axis, options->cut_position};
  }
  result.explode = options->explode;
  result.stretch = options->stretch;
  result.edges = options->edges != 0;
  result.contours = options->contours != 0;
  result.white = options->white != 0;
  if (options->title != nullptr) result.title = options->title;
  result.execution = execution_of(options->execution);
  return result;
}

using RenderModel = Result<std::string> (*)(const Model&, const SectionStack*,
                                            const RenderOptions&);
struct PictureFormat {
  std::string_view extension;
  RenderModel render;
};
constexpr std::array kPictureFormats{PictureFormat{".png", render_png},
                                     PictureFormat{".svg", render_svg},
                                     PictureFormat{".html", render_html}};

// Of the path's extension, in letters of either case.
RenderModel renderer_of(const std::string& path) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  for (const PictureFormat& format : kPictureFormats) {
    if (extension == format.extension) return format.render;
  }
  Error error{ErrorCode::usage, "a picture is written as .png, .svg or .html", {}};
  error.where.file = path;
  throw Failed(error);
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_render_options_defaults(tetloft_render_options* options) {
  return answer([&] {
    require_output(options, "options");
    *options = default_render_options();
  });
}

tetloft_status tetloft_model_render(const tetloft_model* model, const tetloft_stack* stack,
                                    const char* path, const tetloft_render_options* options) {
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    const auto contours = stack == nullptr ? nullptr : value_of_handle(stack, "stack");
    const std::string file = text_of(path, "path");
    const RenderModel render = renderer_of(file);
    require_success(tetloft::write_file(
        file, value_of(render(value->model, contours.get(), render_options_of(options)))));
  });
}
