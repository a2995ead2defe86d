#include "io/drawing/geojson_write.hpp"

#include <string>
#include <utility>
#include <vector>

#include <tetloft/nesting.hpp>

#include "io/drawing/written_stack.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

void append_position(std::string& text, const Point2& p) {
  text += '[';
  append_number(text, p.x);
  text += ',';
  append_number(text, p.y);
  text += ']';
}

// The first vertex stands at the end again.
void append_ring(std::string& text, const Contour& contour, bool counter_clockwise) {
  const std::vector<Point2>& v = contour.vertices;
  const bool turned = (area_sign(contour) == Sign::positive) != counter_clockwise;
  text += '[';
  for (std::size_t i = 0; i <= v.size(); ++i) {
    if (i > 0) text += ',';
    const std::size_t at = i % v.size();
    append_position(text, v[turned && at > 0 ? v.size() - at : at]);
  }
  text += ']';
}

}  // namespace

Written write_geojson(Sink& sink, const SectionStack& stack, const Target& target) {
  const Result<std::vector<Warning>> fit = check_written(stack, target);
  if (!fit) return fit.error();
  std::vector<Warning> warnings = *fit;
  for (Warning& warning : warnings_of_turned(stack, target, "GeoJSON")) {
    warnings.push_back(std::move(warning));
  }
  Pieces pieces(sink);
  std::string& text = pieces.text();
  text = "{\"type\":\"FeatureCollection\",\"features\":[";
  bool first = true;
  for (const Section& section : stack.sections) {
    if (section.contours.empty()) continue;
    const Nesting nesting = nest(section);
    const auto rings = rings_by_outer(nesting);
    for (const std::vector<ContourId>& ring : rings) {
      text += first ? "\n" : ",\n";
      first = false;
      text += "{\"type\":\"Feature\",\"properties\":{\"z\":";
      append_number(text, section.z);
      text += "},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[";
      for (std::size_t i = 0; i < ring.size(); ++i) {
        if (i > 0) text += ',';
        append_ring(text, section.contours[ring[i]], i == 0);
        pieces.next();
      }
      text += "]}}";
      pieces.next();
    }
  }
  text += "\n]}\n";
  pieces.finish();
  return warnings;
}

}  // namespace tetloft::internal::io
