#include "triangulation3/nearest.hpp"

namespace tetloft::internal::triangulation3 {

std::vector<VertexId> points_near(const LiveTets& tets, const Point3& p, VertexId near) {
  std::vector<VertexId> result;
  const auto add = [&](const TetVertices& tet) {
    for (const VertexId v : tet) {
      if (LiveTets::is_point(v)) result.push_back(v);
    }
  };
  add(tets.tets().tet(tets.locate(p, near)));
  // A hull facet of auxiliary vertices has no point; every finite tet has.
  if (result.empty()) add(tets.tets().tet(tets.start(p, near)));
  return result;
}

}  // namespace tetloft::internal::triangulation3
