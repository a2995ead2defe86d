// Gathers the in-plane faces of all tets and counts the sides of their edges.
#include "check/in_plane.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <tetloft/predicates.hpp>

namespace tetloft::internal::checking {

namespace {

struct FaceUse {
  std::uint32_t plane;
  TriangleVertices sorted;
  std::int8_t side;  // of the fourth vertex: −1 below, 1 above, 0 in the plane

  [[nodiscard]] auto face() const { return std::tie(plane, sorted); }
};

std::vector<FaceUse> in_plane_faces(const ModelView& view, const SectionRange& sections) {
  std::vector<FaceUse> faces;
  for (const TetVertices& tet : view.tets) {
    for (std::size_t apex = 0; apex < 4; ++apex) {
      TriangleVertices face;
      for (std::size_t k = 0; k < 3; ++k) {
        face[k] = tet[static_cast<std::size_t>(kFaceVertex[apex][k])];
      }
      const Level level = view.level[face[0].index()];
      if (!sections.holds_plane(level) || view.level[face[1].index()] != level ||
          view.level[face[2].index()] != level) {
        continue;
      }
      std::sort(face.begin(), face.end());
      const Level of_apex = view.level[tet[apex].index()];
      const int side = of_apex < level ? -1 : (of_apex > level ? 1 : 0);
      faces.push_back(
          {static_cast<std::uint32_t>(level / 2), face, static_cast<std::int8_t>(side)});
    }
  }
  std::sort(faces.begin(), faces.end(),
            [](const FaceUse& a, const FaceUse& b) { return a.face() < b.face(); });
  return faces;
}

InPlaneTriangle as_triangle(const ModelView& view, const FaceUse& face) {
  InPlaneTriangle triangle;
  triangle.plane = face.plane;
  triangle.vertices = face.sorted;
  const Sign turn =
      orient2d(view.xy(face.sorted[0]), view.xy(face.sorted[1]), view.xy(face.sorted[2]));
  triangle.flat = turn == Sign::zero;
  if (turn == Sign::negative) std::swap(triangle.vertices[1], triangle.vertices[2]);
  return triangle;
}

}  // namespace

InPlaneComplex in_plane_complex(const ModelView& view, const SectionRange& sections) {
  InPlaneComplex complex;
  const std::vector<FaceUse> faces = in_plane_faces(view, sections);
  for (std::size_t i = 0; i < faces.size();) {
    InPlaneTriangle triangle = as_triangle(view, faces[i]);
    const std::size_t first = i;
    for (; i < faces.size() && faces[i].face() == faces[first].face(); ++i) {
      const int side = faces[i].side;
      ++(side < 0 ? triangle.below : (side > 0 ? triangle.above : triangle.within));
    }
    complex.triangles.push_back(triangle);
  }

  struct Side {
    VertexId low, high;
    bool left;
    [[nodiscard]] auto edge() const { return std::tie(low, high); }
  };
  std::vector<Side> sides;
  for (const InPlaneTriangle& triangle : complex.triangles) {
    if (triangle.flat) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId from = triangle.vertices[k];
      const VertexId to = triangle.vertices[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.edge() < b.edge(); });
  for (std::size_t i = 0; i < sides.size();) {
    InPlaneComplex::Edge edge{sides[i].low, sides[i].high};
    const std::size_t first = i;
    for (; i < sides.size() && sides[i].edge() == sides[first].edge(); ++i) {
      ++(sides[i].left ? edge.left : edge.right);
    }
    complex.edges.push_back(edge);
  }
  complex.first_edge.assign(view.points.size() + 1, 0);
  for (const InPlaneComplex::Edge& edge : complex.edges) ++complex.first_edge[edge.low.index() + 1];
  for (std::size_t v = 0; v < view.points.size(); ++v) {
    complex.first_edge[v + 1] += complex.first_edge[v];
  }
  return complex;
}

bool InPlaneComplex::has_edge(VertexId a, VertexId b) const {
  const VertexId low = std::min(a, b);
  const VertexId high = std::max(a, b);
  const auto begin = edges.begin() + first_edge[low.index()];
  const auto end = edges.begin() + first_edge[low.index() + 1];
  const auto at = std::lower_bound(begin, end, high,
                                   [](const Edge& edge, VertexId v) { return edge.high < v; });
  return at != end && at->high == high;
}

}  // namespace tetloft::internal::checking
