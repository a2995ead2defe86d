#include "between/inner_sections.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "between/trace_shapes.hpp"

namespace tetloft::internal::between {

namespace {

// The mean vertex of the regions, summed in canonical order.
std::optional<Point2> mean_vertex(const Section& section, const Nesting& nesting,
                                  const std::vector<RegionId>& regions) {
  std::vector<Point2> vertices;
  for (const ContourId c : section.contours.ids()) {
    if (std::find(regions.begin(), regions.end(), nesting.region[c]) == regions.end()) continue;
    const std::vector<Point2>& more = section.contours[c].vertices;
    vertices.insert(vertices.end(), more.begin(), more.end());
  }
  if (vertices.empty()) return std::nullopt;
  std::sort(vertices.begin(), vertices.end(),
            [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
  Point2 sum;
  for (const Point2& p : vertices) sum = {sum.x + p.x, sum.y + p.y};
  const auto n = static_cast<double>(vertices.size());
  return Point2{sum.x / n, sum.y / n};
}

// How a class moves if all of it moves alike.
std::optional<Point2> rigid_motion(const SlabShape& slab, ClassId c) {
  const auto low = mean_vertex(slab.lower, slab.lower_nesting, slab.classes[c].lower);
  const auto high = mean_vertex(slab.upper, slab.upper_nesting, slab.classes[c].upper);
  if (!low || !high) return std::nullopt;
  return Point2{high->x - low->x, high->y - low->y};
}

}  // namespace

InnerSections trace_between(const SlabShape& shape) {
  ClassShapes shapes;
  for (const SlabClass& c : shape.classes) {
    shapes.push_back(interpolate(c.outlines, shape.step, shape.at));
  }
  TracedShapes traced = trace_shapes(shape, shapes);
  if (traced.left_apart.empty()) return traced.inner;
  for (const ClassId c : traced.left_apart) {
    const std::optional<Point2> rigid = rigid_motion(shape, c);
    if (!rigid) return {};
    shapes[c] = interpolate(shape.classes[c].outlines, shape.step, shape.at, rigid);
  }
  return trace_shapes(shape, shapes).inner;
}

}  // namespace tetloft::internal::between
