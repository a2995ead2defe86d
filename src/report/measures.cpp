#include "report/measures.hpp"

#include <algorithm>
#include <cmath>

#include "core/unit_of_length.hpp"
#include "render/vector.hpp"

namespace tetloft::internal::report {

namespace {

using render::cross;
using render::dot;
using render::operator-;

void include(ReportMeasures& measures, std::size_t plane) {
  if (!measures.first || plane < measures.first->index()) measures.first = SectionId(plane);
  if (!measures.last || plane > measures.last->index()) measures.last = SectionId(plane);
}

void add_tets(const Subject& subject, const MeasuringPoints& points, ReportFigures& figures) {
  const checking::ModelView& view = subject.view;
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    const TetVertices& v = view.tets[t];
    ReportMeasures& measures = figures.components[subject.component[t]].measures;
    ++measures.tets;
    measures.volume += tet_volume(points.corners(v));
    for (const VertexId corner : v) {
      const checking::Level level = view.level[corner.index()];
      if (subject.planes.empty() || !checking::on_plane(level)) continue;
      include(measures, static_cast<std::size_t>(level / 2));
      include(figures.all, static_cast<std::size_t>(level / 2));
    }
  }
}

void add_surfaces(const Subject& subject, const MeasuringPoints& points, ReportFigures& figures) {
  const checking::ModelView& view = subject.view;
  std::vector<std::uint8_t> counted(subject.surface.topology.size(), 0);
  for (std::size_t k = 0; k < view.boundary.size(); ++k) {
    const TriangleVertices& v = view.boundary[k];
    ReportMeasures& measures = figures.components[subject.component[subject.behind[k]]].measures;
    const Point3 twice = cross(points[v[1]] - points[v[0]], points[v[2]] - points[v[0]]);
    measures.surface_area += std::sqrt(dot(twice, twice)) / 2;
    const std::uint32_t surface = subject.surface.component[k];
    if (counted[surface] != 0) continue;
    counted[surface] = 1;
    ++measures.surfaces;
    if (!subject.is_whole()) continue;
    measures.genus = measures.genus.value_or(0) + subject.surface.topology[surface].genus();
    measures.cavities = measures.surfaces - 1;
  }
}

void sum_up(const Subject& subject, const MeasuringPoints& points, ReportFigures& figures) {
  ReportMeasures& all = figures.all;
  all.volume = volume(subject.model);
  for (ReportComponent& component : figures.components) {
    ReportMeasures& one = component.measures;
    all.tets += one.tets;
    all.surfaces += one.surfaces;
    one.volume = points.back(one.volume, 3);
    one.surface_area = points.back(one.surface_area, 2);
    all.surface_area += one.surface_area;
    if (one.genus) all.genus = all.genus.value_or(0) + *one.genus;
    if (one.cavities) all.cavities = all.cavities.value_or(0) + *one.cavities;
  }
}

}  // namespace

MeasuringPoints::MeasuringPoints(const Subject& subject) {
  UnitOfLength unit;
  points_.reserve(subject.view.points.size());
  for (std::size_t v = 0; v < subject.view.points.size(); ++v) {
    const Point3& p = subject.view.points[v];
    points_.push_back(subject.is_rigid ? p : place(subject.model.frame, p));
    if (subject.view.used[v] != 0) unit.include(points_.back());
  }
  exponent_ = unit.largest_to_one();
  for (Point3& p : points_) p = scaled(p, exponent_);
}

double MeasuringPoints::back(double measure, int power) const {
  return std::ldexp(measure, -power * exponent_);
}

double tet_volume(const std::array<Point3, 4>& p) {
  return dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) / 6;
}

void measure(const Subject& subject, const MeasuringPoints& points, ReportFigures& figures) {
  for (const std::string& name : subject.names) figures.components.push_back({name, {}});
  add_tets(subject, points, figures);
  add_surfaces(subject, points, figures);
  sum_up(subject, points, figures);
  const checking::ModelView& view = subject.view;
  figures.vertices =
      static_cast<std::size_t>(std::count(view.used.begin(), view.used.end(), std::uint8_t{1}));
  figures.boundary_triangles = view.boundary.size();
  figures.components_touch = tetloft::components_touch(subject.model);
  if (subject.model.kind.size() != subject.model.tets.size()) return;
  figures.kinds.assign(kTetKinds, 0);
  for (const TetId t : view.id) {
    ++figures.kinds[static_cast<std::size_t>(subject.model.kind[t])];
  }
}

}  // namespace tetloft::internal::report
