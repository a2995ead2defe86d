// The viewer's page.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/render.hpp>

#include "core/guard.hpp"
#include "core/text.hpp"
#include "core/watched_work.hpp"
#include "io/json_write.hpp"
#include "io/numbers.hpp"
#include "model/component_colour.hpp"
#include "render/page_json.hpp"
#include "render/page_layer.hpp"
#include "render/subject.hpp"
#include "render/vector.hpp"
#include "render/viewer_parts.hpp"

namespace tetloft {

using namespace internal;

namespace {

using render::PageLayer;
using render::PageSpace;

PageSpace space_of(const std::vector<PageLayer>& layers) {
  PageSpace space{std::numeric_limits<int>::min(), {}, 1};
  for (const PageLayer& layer : layers) {
    space.exponent = std::max(space.exponent, layer.placed_exponent());
  }
  using render::operator+, render::operator-, render::operator*;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Point3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  for (const PageLayer& layer : layers) {
    for (const TetVertices& tet : layer.subject.tets) {
      for (const VertexId v : tet) {
        const Point3 p = layer.placed(layer.subject.points[v.index()], space.exponent);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
  }
  space.centre = 0.5 * (low + high);
  const Point3 diagonal = high - low;
  const double scale = std::sqrt(render::dot(diagonal, diagonal)) / 2;
  if (scale > 0) space.scale = scale;
  return space;
}

// Of the first model that has any.
std::string first_text(const std::vector<PageLayer>& layers, std::string Description::*what) {
  for (const PageLayer& layer : layers) {
    if (!(layer.model->about.*what).empty()) return layer.model->about.*what;
  }
  return {};
}

// Of components the first: all that differ (model/component_colour.hpp); the viewer begins again
// after these.
void add_palettes(io::JsonWriter& json) {
  render::json_colours(json, "componentColours", kComponentColours, component_colour);
  render::json_colours(json, "dihedralColours", 256, [](std::size_t k) {
    return render::dihedral_colour(static_cast<double>(k) / 255);
  });
  render::json_colours(json, "kindColours", kTetKinds,
                       [](std::size_t k) { return render::kind_colour(static_cast<TetKind>(k)); });
  render::json_list(json, "kindNames", kTetKinds,
                    [](std::size_t k) { return name_of(static_cast<TetKind>(k)); });
  render::json_colours(json, "evidenceColours", kEvidences + 1, render::evidence_colour);
  render::json_list(json, "evidenceNames", kEvidences,
                    [](std::size_t k) { return name_of(static_cast<Evidence>(k)); });
}

// `given`: contours were, which all models share.
std::string page_header(const std::vector<PageLayer>& layers, const PageSpace& space, bool given,
                        const RenderOptions& options) {
  io::JsonWriter json;
  json.begin_object();
  render::json_text(json, "title", options.title);
  render::json_text(json, "unit", first_text(layers, &Description::unit));
  render::json_text(json, "orientation", first_text(layers, &Description::orientation));
  json.member("length", std::ldexp(space.scale, space.exponent));
  json.member("stretch", options.stretch);
  json.member("colour", name_of(options.colour));
  json.member("azimuth", options.azimuth);
  json.member("elevation", options.elevation);
  json.member("explode", options.explode);
  json.member("edges", options.edges);
  json.member("drawContours", options.contours);
  json.member("contoursGiven", given);
  std::optional<double> cut;
  if (options.cut) {
    json.member("cutAxis", options.cut->axis);
    cut = render::page_layer_cut(layers.front(), space, *options.cut, options.stretch);
  }
  json.member("cut", cut);
  add_palettes(json);
  json.key("models");
  json.begin_array();
  for (const PageLayer& layer : layers) {
    render::add_page_layer_header(json, layer, space, options.stretch);
  }
  json.end_array();
  json.end_object();
  return render::json_script(json.text());
}

std::string page_text(const std::vector<PageLayer>& layers, bool given,
                      const RenderOptions& options, WatchedWork& work) {
  const PageSpace space = space_of(layers);
  std::string page =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1, "
      "viewport-fit=cover\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>" +
      render::html_text(options.title) + "</title>\n<style>\n" + render::kViewerCss +
      "</style>\n</head>\n<body>\n" + render::kViewerHtml;
  page += "<script type=\"application/json\" id=\"model\">" +
          page_header(layers, space, given, options) + "</script>\n";
  work.step_done_go_on();
  for (std::size_t k = 0; k < layers.size(); ++k) {
    render::append_page_layer(page, k, layers[k], space, work);
  }
  for (const char* script : render::viewer_scripts()) {
    page += "<script>\n";
    page += script;
    page += "</script>\n";
  }
  return page + "</body>\n</html>\n";
}

// What a page calls a model that was given no name.
std::string layer_name(const NamedModel& named, std::size_t number) {
  if (!named.name.empty()) return named.name;
  const std::string& own = named.model->about.name;
  return own.empty() ? "model " + std::to_string(number + 1) : own;
}

Result<std::string> render_page(std::span<const NamedModel> models, const SectionStack* contours,
                                const RenderOptions& options) {
  if (models.empty()) return Error{ErrorCode::usage, "there is no model to draw", {}};
  // A subject, and the arrays, of each; the header.
  WatchedWork work(options.execution, models.size() * (1 + render::kPageArrays) + 1);
  work.go_on();
  std::vector<PageLayer> layers;
  for (const NamedModel& named : models) {
    if (named.model == nullptr) return Error{ErrorCode::usage, "a model is null", {}};
    const std::string name = layer_name(named, layers.size());
    Result<render::Subject> subject = render::subject_of(*named.model, contours, options);
    if (!subject) {
      Error error = subject.error();
      if (models.size() > 1) error.message = io::in_quotes(name) + ": " + error.message;
      return error;
    }
    layers.push_back({named.model, name, *std::move(subject)});
    work.step_done_go_on();
  }
  return page_text(layers, contours != nullptr, options, work);
}

}  // namespace

Result<std::string> render_html(std::span<const NamedModel> models, const SectionStack* contours,
                                const RenderOptions& options) {
  return guard_internal([&] { return render_page(models, contours, options); });
}

Result<std::string> render_html(const Model& model, const SectionStack* contours,
                                const RenderOptions& options) {
  return guard_internal([&] {
    const NamedModel one{&model, options.title};
    return render_page({&one, 1}, contours, options);
  });
}

}  // namespace tetloft
