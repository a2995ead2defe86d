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

ClassShape shape_of(const SlabShape& slab, ClassId c, const std::optional<Point2>& rigid) {
  return interpolate(slab.classes[c].outlines, slab.step, slab.at, rigid);
}

}  // namespace

InnerSections trace_between(const SlabShape& slab) {
  ClassShapes shapes;
  for (const ClassId c : slab.classes.ids()) shapes.push_back(shape_of(slab, c, std::nullopt));
  TracedShapes traced = trace_shapes(slab, shapes);
  if (traced.left_apart.empty()) return traced.inner;
  for (const ClassId c : traced.left_apart) {
    if (const auto rigid = rigid_motion(slab, c)) shapes[c] = shape_of(slab, c, rigid);
  }
  traced = trace_shapes(slab, shapes);
  if (traced.left_apart.empty()) return traced.inner;
  for (const ClassId c : traced.left_apart) shapes[c] = shape_of(slab, c, std::nullopt);
  return trace_shapes(slab, shapes, traced.left_apart).inner;
}

}  // namespace tetloft::internal::between
