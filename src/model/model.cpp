// Names of what a model's tets and points come from, its boundary surface and its volume.
#include <tetloft/model.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/entry.hpp"
#include "core/unit_of_length.hpp"
#include "mesh/face_groups.hpp"

namespace tetloft {

using namespace internal;

const char* name_of(TetKind kind) {
  switch (kind) {
    case TetKind::t1_internal: return "t1_internal";
    case TetKind::t1_external: return "t1_external";
    case TetKind::ii: return "ii";
    case TetKind::ie: return "ie";
    case TetKind::ic: return "ic";
    case TetKind::ee: return "ee";
    case TetKind::ec: return "ec";
    case TetKind::cc: return "cc";
    case TetKind::prism: return "prism";
  }
  return "unknown";
}

const char* name_of(PointOrigin origin) {
  switch (origin) {
    case PointOrigin::input: return "input";
    case PointOrigin::contour_split: return "contour_split";
    case PointOrigin::lifted: return "lifted";
    case PointOrigin::cut: return "cut";
    case PointOrigin::cap: return "cap";
    case PointOrigin::projected: return "projected";
    case PointOrigin::inserted: return "inserted";
  }
  return "unknown";
}

namespace {

// Its vertices are the model's.
bool is_sound(const Model& model, const TetVertices& tet) {
  return std::all_of(tet.begin(), tet.end(),
                     [&](VertexId v) { return v.index() < model.points.size(); });
}

}  // namespace

Result<TetMesh> half_faces(const Model& model) {
  return TetMesh::from_tets(model.points.size(), model.tets.raw());
}

Surface boundary_surface(const Model& model) {
  require_fit(model.tets.size() < std::size_t{1} << 30, "2^30 tets or more");
  const auto corners = [&](std::size_t t) -> const TetVertices& { return model.tets[TetId(t)]; };
  std::vector<HalfFaceId> boundary;
  const auto sound = [&](std::size_t t) { return is_sound(model, model.tets[TetId(t)]); };
  mesh_detail::for_each_boundary_face(model.points.size(), model.tets.size(), corners, sound,
                                      [&](HalfFaceId h) { boundary.push_back(h); });
  std::sort(boundary.begin(), boundary.end());
  Surface surface;
  surface.triangles.reserve(boundary.size());
  surface.tet.reserve(boundary.size());
  for (const HalfFaceId h : boundary) {
    const TetId t = TetMesh::tet_of(h);
    surface.triangles.push_back(face_of(model.tets[t], TetMesh::face_of(h)));
    surface.tet.push_back(t);
  }
  return surface;
}

double volume(const Model& model) {
  IdVector<VertexId, std::uint8_t> used(model.points.size(), 0);
  for (const TetVertices& tet : model.tets) {
    if (!is_sound(model, tet)) continue;
    for (const VertexId v : tet) used[v] = 1;
  }
  UnitOfLength unit;
  for (const VertexId v : used.ids()) {
    if (used[v] != 0) unit.include(model.points[v]);
  }
  const int exponent = unit.largest_to_one();
  // Neumaier's compensated sum: a stack has many tets far smaller than the whole.
  double sum = 0;
  double lost = 0;
  for (const TetVertices& tet : model.tets) {
    if (!is_sound(model, tet)) continue;
    const Point3 d = scaled(model.points[tet[3]], exponent);
    const auto from_d = [&](int i) {
      const Point3 p = scaled(model.points[tet[static_cast<std::size_t>(i)]], exponent);
      return Point3{p.x - d.x, p.y - d.y, p.z - d.z};
    };
    const Point3 a = from_d(0);
    const Point3 b = from_d(1);
    const Point3 c = from_d(2);
    // a · (b × c) is minus the orientation determinant of (a, b, c, d).
    const double term = -(a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                          a.z * (b.x * c.y - b.y * c.x)) /
                        6;
    const double next = sum + term;
    lost += std::fabs(sum) >= std::fabs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  return std::ldexp(sum + lost, -3 * exponent) * volume_factor(model.frame);
}

}  // namespace tetloft
