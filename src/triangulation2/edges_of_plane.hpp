// From vertex to vertex along the edges of a plane, whatever its dimension.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "triangulation2/live_plane.hpp"

namespace tetloft::internal::triangulation2 {

class EdgesOfPlane {
 public:
  explicit EdgesOfPlane(const LivePlane& plane) : plane_(&plane) {}

  [[nodiscard]] Point3 point(VertexId v) const {
    return {plane_->point(v).x, plane_->point(v).y, 0};
  }
  /// Counter-clockwise, where there are triangles, each once, until visit(neighbour) is false.
  template <class Visit>
  void for_each_neighbour(VertexId v, const Visit& visit) const {
    if (!plane_->has_triangles()) {
      const std::vector<VertexId>& row = plane_->row();
      const std::size_t at = plane_->place_in_row(plane_->point(v));
      if (at > 0 && !visit(row[at - 1])) return;
      if (at + 1 < row.size()) (void)visit(row[at + 1]);
      return;
    }
    const Incremental2& triangles = plane_->triangles();
    const HalfEdgeId first = triangles.out(plane_->site(v));
    HalfEdgeId h = first;
    do {
      const SiteId u = triangles.destination(h);
      if (u != Incremental2::kGhost && !visit(plane_->vertex(u))) return;
      h = triangles.rotate(h);
    } while (h != first);
  }

 private:
  const LivePlane* plane_;
};

}  // namespace tetloft::internal::triangulation2
