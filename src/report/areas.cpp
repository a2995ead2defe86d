#include "report/areas.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/overlap.hpp>

#include "render/vector.hpp"
#include "report/cuts.hpp"

namespace tetloft::internal::report {

namespace {

// Heights that are looked at in a slab, so that there are about kHeights of them in all.
constexpr std::size_t kHeights = 400;
constexpr std::size_t kMostInSlab = 16;
constexpr std::size_t kBeyondEnds = 4;

void append_between(std::vector<CutHeight>& heights, double low, double high, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(n);
    const double z = low + part * (high - low);
    if (z > low && z < high) heights.push_back({z, false});
  }
}

// At planes from below, where there is anything, and in between.
std::vector<CutHeight> heights_of(const Subject& subject) {
  std::vector<double> planes = subject.planes;
  if (planes.empty()) planes = {subject.low.z, subject.high.z};
  const std::size_t n = std::clamp<std::size_t>(kHeights / planes.size(), 1, kMostInSlab);
  std::vector<CutHeight> heights;
  append_between(heights, subject.low.z, planes.front(), kBeyondEnds);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    heights.push_back({planes[k], planes[k] <= subject.low.z});
    if (k + 1 < planes.size()) append_between(heights, planes[k], planes[k + 1], n);
  }
  append_between(heights, planes.back(), subject.high.z, kBeyondEnds);
  return heights;
}

// By how much areas in planes of the stack are larger in the file.
double area_factor(const Subject& subject) {
  if (subject.is_rigid) return 1;
  const auto& axes = subject.model.frame.axes;
  const Point3 normal = render::cross(axes[0], axes[1]);
  return std::sqrt(render::dot(normal, normal));
}

double region_area(const Section& section) {
  double sum = 0;
  for (const RegionOutline& region : outlines(section, nest(section))) sum += area(region);
  return sum;
}

// Of the tets that lie between the first and the last plane.
double volume_within(const Subject& subject, const MeasuringPoints& points) {
  const auto last = static_cast<checking::Level>(2 * (subject.planes.size() - 1));
  double sum = 0;
  for (const TetVertices& v : subject.view.tets) {
    const bool within = std::all_of(v.begin(), v.end(), [&](VertexId corner) {
      const checking::Level level = subject.view.level[corner.index()];
      return level >= 0 && level <= last;
    });
    if (within) sum += tet_volume(points.corners(v));
  }
  return points.back(sum, 3);
}

double frusta(const std::vector<ReportArea>& sections) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < sections.size(); ++k) {
    const double a = sections[k].area;
    const double b = sections[k + 1].area;
    sum += (sections[k + 1].z - sections[k].z) * (a + std::sqrt(a) * std::sqrt(b) + b) / 3;
  }
  return sum;
}

}  // namespace

void measure_areas(const Subject& subject, const MeasuringPoints& points, ReportFigures& figures) {
  const double factor = area_factor(subject);
  const std::vector<CutHeight> heights = heights_of(subject);
  const std::vector<double> areas = cut_areas(subject, heights);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    figures.solid.push_back({heights[k].z, factor * areas[k]});
  }
  if (subject.stack == nullptr) return;
  for (const Section& section : subject.stack->sections) {
    figures.sections.push_back({section.z, factor * region_area(section)});
  }
  if (figures.sections.size() < 2) return;
  figures.volume_between = volume_within(subject, points);
  // Heights of the stack times this are heights in the file.
  const double height_factor = volume_factor(subject.model.frame) / factor;
  figures.frustum_volume = height_factor * frusta(figures.sections);
}

}  // namespace tetloft::internal::report
