// SVG 1.1: the triangles that are seen, from far to near, and the visible parts of lines.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/render.hpp>

#include "core/guard.hpp"
#include "io/numbers.hpp"
#include "render/encoders.hpp"
#include "render/raster.hpp"
#include "render/vector.hpp"

namespace tetloft::internal::render {

namespace {

// Hundredths of a pixel.
void append_place(std::string& out, const Projected& p) {
  io::append_number(out, std::round(100 * p.x) / 100);
  out += ' ';
  io::append_number(out, std::round(100 * p.y) / 100);
}

struct Seen {
  std::uint32_t triangle;
  double depth;
  double open;  // mean over its pixels
};

// What the item buffer shows, from far to near.
std::vector<Seen> seen_triangles(const Scene& scene, const View& view, const ItemBuffer& items) {
  const std::vector<float> open = openness(items, scene, view);
  std::vector<double> sum(scene.triangles.size(), 0);
  std::vector<std::uint32_t> count(scene.triangles.size(), 0);
  for (std::size_t at = 0; at < items.item.size(); ++at) {
    if (items.item[at] == ItemBuffer::kNothing) continue;
    sum[items.item[at]] += static_cast<double>(open[at]);
    ++count[items.item[at]];
  }
  std::vector<Seen> seen;
  for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
    if (count[k] == 0) continue;
    double depth = 0;
    for (const Point3& p : scene.triangles[k].corner) depth += view.project(p).depth / 3;
    seen.push_back({static_cast<std::uint32_t>(k), depth, sum[k] / count[k]});
  }
  std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
    return std::pair(a.depth, a.triangle) < std::pair(b.depth, b.triangle);
  });
  return seen;
}

void append_triangle(std::string& out, const SceneTriangle& triangle, double open, const View& view,
                     bool edges) {
  const Point3 normal = unit(triangle.normal[0] + triangle.normal[1] + triangle.normal[2]);
  const Light light = lit(triangle.colour, view.turned(normal), static_cast<float>(open));
  const std::string fill = hex({encoded(light.r), encoded(light.g), encoded(light.b)});
  out += "<path d=\"M";
  for (std::size_t i = 0; i < 3; ++i) {
    if (i != 0) out += 'L';
    append_place(out, view.project(triangle.corner[i]));
  }
  out += "Z\" fill=\"" + fill + '"';
  // A hairline of its own colour closes the seams that renderers leave between neighbours.
  if (!edges) out += " stroke=\"" + fill + '"';
  out += "/>\n";
}

// The parts of a line that are seen, tested pixel by pixel; joined to what was written last where
// they go on from there.
void append_line(std::string& out, const std::array<Point3, 2>& line, const View& view,
                 const View& fine, const ItemBuffer& items) {
  const Projected a = fine.project(line[0]);
  const Projected b = fine.project(line[1]);
  const double lift = kLineLift * static_cast<double>(std::max(items.width, items.height));
  const auto steps =
      std::max(1L, std::lround(std::ceil(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)))));
  const auto visible = [&](double t) {
    const double x = a.x + t * (b.x - a.x);
    const double y = a.y + t * (b.y - a.y);
    if (x < 0 || y < 0 || x >= static_cast<double>(items.width) ||
        y >= static_cast<double>(items.height)) {
      return false;
    }
    const std::size_t at = items.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
    return static_cast<double>(items.depth[at]) <= a.depth + t * (b.depth - a.depth) + lift;
  };
  const auto place = [&](long k) {
    const double t = static_cast<double>(k) / static_cast<double>(steps);
    return view.project(line[0] + t * (line[1] - line[0]));
  };
  for (long k = 0; k < steps;) {
    const auto middle = [&](long i) {
      return visible((static_cast<double>(i) + 0.5) / static_cast<double>(steps));
    };
    if (!middle(k)) {
      ++k;
      continue;
    }
    long end = k + 1;
    while (end < steps && middle(end)) ++end;
    std::string from;
    append_place(from, place(k));
    if (!out.ends_with(from)) out += 'M' + from;
    out += 'L';
    append_place(out, place(end));
    k = end;
  }
}

}  // namespace

std::string svg_text(const Scene& scene, const RenderOptions& options, WatchedWork& work) {
  const View view(scene, options);
  // Twice as fine: thin triangles are seen.
  const View fine = view.enlarged(2);
  const ItemBuffer items = draw_items(scene, fine, 2 * static_cast<std::size_t>(options.width),
                                      2 * static_cast<std::size_t>(options.height));
  work.step_done_go_on();
  const std::string size =
      std::to_string(options.width) + "\" height=\"" + std::to_string(options.height);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size +
                    "\" viewBox=\"0 0 " + std::to_string(options.width) + ' ' +
                    std::to_string(options.height) + "\">\n";
  if (options.white) out += "<rect width=\"" + size + "\" fill=\"#ffffff\"/>\n";
  const std::string ink = hex(kContourColour);
  out += options.edges ? "<g stroke=\"" + ink +
                             "\" stroke-opacity=\"0.5\" stroke-width=\"0.4\" "
                             "stroke-linejoin=\"round\">\n"
                       : "<g stroke-width=\"0.5\" stroke-linejoin=\"round\">\n";
  for (const Seen& seen : seen_triangles(scene, fine, items)) {
    append_triangle(out, scene.triangles[seen.triangle], seen.open, view, options.edges);
  }
  out += "</g>\n";
  work.step_done_go_on();
  std::string lines;
  for (const auto& line : scene.lines) append_line(lines, line, view, fine, items);
  if (!lines.empty()) {
    out += "<path d=\"" + lines + "\" fill=\"none\" stroke=\"" + ink + "\" stroke-width=\"";
    io::append_number(out, std::round(100 * line_width(scene, view)) / 100);
    out += "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n";
  }
  out += "</svg>\n";
  work.step_done();
  return out;
}

}  // namespace tetloft::internal::render

namespace tetloft {

using namespace internal;

Result<std::string> render_svg(const Model& model, const SectionStack* contours,
                               const RenderOptions& options) {
  return guard_internal([&]() -> Result<std::string> {
    WatchedWork work(options.execution, render::kSvgSteps + 1);
    work.go_on();
    const auto scene = render::scene_of(model, contours, render::View::toward(options), options);
    if (!scene) return scene.error();
    work.step_done_go_on();
    return render::svg_text(*scene, options, work);
  });
}

}  // namespace tetloft
