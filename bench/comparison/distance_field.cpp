#include "comparison/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "comparison/nearest.hpp"

namespace tetloft::bench {

namespace {

using Segments = std::vector<std::array<Point3, 2>>;

Segments segments_of(const Section& section) {
  Segments segments;
  for (const Contour& contour : section.contours) {
    const auto& v = contour.vertices;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Point2& a = v[i];
      const Point2& b = v[(i + 1) % v.size()];
      segments.push_back({Point3{a.x, a.y, 0}, Point3{b.x, b.y, 0}});
    }
  }
  return segments;
}

double length(const std::array<Point3, 2>& s) {
  return std::hypot(s[1].x - s[0].x, s[1].y - s[0].y);
}

// Layers from section s up to the next, that one not counted.
std::size_t layers_above(const SectionStack& stack, std::size_t s, double step,
                         const GridOptions& options) {
  const double gap = stack.sections[SectionId(s + 1)].z - stack.sections[SectionId(s)].z;
  const double layers =
      std::clamp(std::round(gap / step), 1.0, static_cast<double>(options.most_layers));
  return static_cast<std::size_t>(layers);
}

// The grid without its values.
ScalarGrid layout(const SectionStack& stack, const Box3& box, double step,
                  const GridOptions& options) {
  ScalarGrid grid;
  grid.step = step;
  grid.origin = {box.low.x - 1.5 * step, box.low.y - 1.5 * step};
  grid.nx = static_cast<std::size_t>((box.high.x - box.low.x) / step) + 5;
  grid.ny = static_cast<std::size_t>((box.high.y - box.low.y) / step) + 5;
  for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
    const double low = stack.sections[SectionId(s)].z, high = stack.sections[SectionId(s + 1)].z;
    const std::size_t n = layers_above(stack, s, step, options);
    for (std::size_t k = 0; k < n; ++k) {
      grid.z.push_back(low + (high - low) * static_cast<double>(k) / static_cast<double>(n));
    }
  }
  grid.z.push_back(stack.sections[SectionId(stack.sections.size() - 1)].z);
  return grid;
}

// Estimated before anything is allocated: steps may be far too small.
double sample_count(const SectionStack& stack, const Box3& box, double step,
                    const GridOptions& options) {
  double layers = 1;
  for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
    layers += static_cast<double>(layers_above(stack, s, step, options));
  }
  return ((box.high.x - box.low.x) / step + 5) * ((box.high.y - box.low.y) / step + 5) * layers;
}

// Where contours cross the rows of the grid, by row and x.
std::vector<std::vector<double>> row_crossings(const ScalarGrid& grid, const Segments& segments) {
  std::vector<std::vector<double>> rows(grid.ny);
  for (auto [a, b] : segments) {
    if (a.y > b.y) std::swap(a, b);
    const double first = std::ceil((a.y - grid.origin.y) / grid.step) - 1;
    for (auto r = static_cast<std::size_t>(std::max(first, 0.0)); r < grid.ny; ++r) {
      const double y = grid.origin.y + grid.step * static_cast<double>(r);
      if (y < a.y) continue;
      if (y >= b.y) break;  // half-open: a vertex counts for one of its edges that go on
      rows[r].push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  }
  for (auto& row : rows) std::sort(row.begin(), row.end());
  return rows;
}

std::vector<float> section_layer(const ScalarGrid& grid, const Section& section) {
  const Segments segments = segments_of(section);
  const double width = grid.step * static_cast<double>(grid.nx);
  const double depth = grid.step * static_cast<double>(grid.ny);
  const double diagonal = std::hypot(width, depth);
  std::vector<float> layer(grid.nx * grid.ny, static_cast<float>(diagonal));
  if (segments.empty()) return layer;
  std::vector<Box3> boxes(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const Point3& p : segments[i]) boxes[i].extend(p);
  }
  const BoxHierarchy tree(boxes);
  const auto rows = row_crossings(grid, segments);
  for (std::size_t y = 0; y < grid.ny; ++y) {
    double distance = 2 * diagonal;
    std::size_t crossed = 0;
    for (std::size_t x = 0; x < grid.nx; ++x) {
      const Point3 p{grid.origin.x + grid.step * static_cast<double>(x),
                     grid.origin.y + grid.step * static_cast<double>(y), 0};
      // No farther than from the sample before, and a step (with room for rounding).
      const double bound = distance + 1.001 * grid.step;
      distance = std::sqrt(tree.nearest2(p, bound * bound, [&](std::uint32_t i) {
        return distance2_to_segment(p, segments[i][0], segments[i][1]);
      }));
      while (crossed < rows[y].size() && rows[y][crossed] < p.x) ++crossed;
      layer[y * grid.nx + x] = static_cast<float>(crossed % 2 == 1 ? -distance : distance);
    }
  }
  return layer;
}

}  // namespace

double mean_edge_length(const SectionStack& stack) {
  double sum = 0;
  std::size_t edges = 0;
  for (const Section& section : stack.sections) {
    for (const auto& segment : segments_of(section)) {
      sum += length(segment);
      ++edges;
    }
  }
  return edges == 0 ? 0 : sum / static_cast<double>(edges);
}

Result<ScalarGrid> distance_field(const SectionStack& stack, const GridOptions& options) {
  if (Result<void> valid = validate(stack); !valid) return valid.error();
  if (stack.sections.size() < 2 || stack.contour_count() == 0) {
    return Error{ErrorCode::invalid_input, "a distance field needs two sections and contours", {}};
  }
  Box3 box;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) box.extend({p.x, p.y, 0});
    }
  }
  const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  double step = options.step > 0 ? options.step
                                 : std::min(mean_edge_length(stack), side / options.least_steps);
  while (sample_count(stack, box, step, options) > static_cast<double>(options.most_samples)) {
    step *= 1.05;
  }
  ScalarGrid grid = layout(stack, box, step, options);
  const std::size_t area = grid.nx * grid.ny;
  grid.value.reserve(area * grid.z.size());
  std::vector<float> low = section_layer(grid, stack.sections[SectionId(0)]);
  for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
    std::vector<float> high = section_layer(grid, stack.sections[SectionId(s + 1)]);
    const std::size_t n = layers_above(stack, s, step, options);
    for (std::size_t k = 0; k < n; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(n);
      for (std::size_t i = 0; i < area; ++i) grid.value.push_back(low[i] + t * (high[i] - low[i]));
    }
    low = std::move(high);
  }
  grid.value.insert(grid.value.end(), low.begin(), low.end());
  return grid;
}

}  // namespace tetloft::bench
