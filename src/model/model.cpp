// Names of what a model's tets and points come from, and its boundary surface.
#include <tetloft/model.hpp>

#include <algorithm>
#include <cstddef>

#include "core/entry.hpp"
#include "mesh/face_groups.hpp"
#include "model/well_formed.hpp"

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

}  // namespace tetloft
