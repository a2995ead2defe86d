// See questions3.hpp.
#include "triangulation3/questions3.hpp"

#include <algorithm>

#include <tetloft/predicates.hpp>

#include "triangulation3/stars.hpp"

namespace tetloft::internal::triangulation3 {

namespace {

bool in_conflict(const LiveTets& tets, TetId t, const Point3& p) {
  const TetVertices& v = tets.tets().tet(t);
  const auto in_sphere = [&](const TetVertices& tet) {
    return insphere_perturbed(tets.point(tet[0]), tets.point(tet[1]), tets.point(tet[2]),
                              tets.point(tet[3]), p) == Sign::positive;
  };
  if (v[0] != kGhost) return in_sphere(v);
  // As delaunay3/insertion has it.
  const Sign side = orient3d(p, tets.point(v[1]), tets.point(v[2]), tets.point(v[3]));
  if (side != Sign::zero) return side == Sign::positive;
  return in_sphere(tets.tets().tet(TetMesh::tet_of(tets.tets().opposite(half_face(t, 0)))));
}

}  // namespace

Simplex simplex_at(const LiveTets& tets, const Point3& p, VertexId near) {
  if (!tets.spans(p)) return {};
  const TetId t = tets.locate(p, near);
  if (tets.tets().is_ghost(t)) return {};
  const TetVertices& tet = tets.tets().tet(t);
  Simplex result{t, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    // Of the closed tet that holds p: vertex i has no part in p iff p lies in face i.
    const TriangleVertices f = delaunay3_detail::facet_of(tet, i);
    if (orient3d(tets.point(f[0]), tets.point(f[1]), tets.point(f[2]), p) != Sign::zero) {
      result.vertices.push_back(tet[i]);
    }
  }
  return result;
}

std::vector<TetId> zone_of(const LiveTets& tets, const Point3& p, VertexId near) {
  IdSet<TetId> zone;
  IdSet<TetId> outside;
  zone.insert(tets.locate(p, near));
  for (std::size_t next = 0; next < zone.ids().size(); ++next) {
    const TetId t = zone.ids()[next];
    for (std::size_t i = 0; i < 4; ++i) {
      const TetId neighbour = TetMesh::tet_of(tets.tets().opposite(half_face(t, i)));
      if (zone.contains(neighbour) || outside.contains(neighbour)) continue;
      if (in_conflict(tets, neighbour, p)) {
        zone.insert(neighbour);
      } else {
        outside.insert(neighbour);
      }
    }
  }
  return zone.ids();
}

std::vector<TetId> ring_of(const LiveTets& tets, VertexId u, VertexId v) {
  TetId first;
  IdSet<TetId> seen;
  for_each_around(tets, u, seen, [&](TetId t, VertexId w) {
    if (w == v) first = t;
    return !first.valid();
  });
  std::vector<TetId> ring;
  if (!first.valid()) return ring;
  const auto has = [](const TetVertices& tet, VertexId w) {
    return std::find(tet.begin(), tet.end(), w) != tet.end();
  };
  // The tet is left through the face without the vertex that it was entered with.
  const TetVertices& start = tets.tets().tet(first);
  VertexId behind;
  for (const VertexId w : start) {
    if (w != u && w != v) behind = w;
  }
  TetId t = first;
  do {
    ring.push_back(t);
    const TetVertices& tet = tets.tets().tet(t);
    const HalfFaceId across = tets.tets().opposite(half_face(t, index_of(tet, behind)));
    VertexId ahead;
    for (const VertexId w : tet) {
      if (w != u && w != v && w != behind) ahead = w;
    }
    t = TetMesh::tet_of(across);
    behind = ahead;
  } while (t != first && has(tets.tets().tet(t), u));
  return ring;
}

}  // namespace tetloft::internal::triangulation3
