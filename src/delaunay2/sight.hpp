// What a segment that is no edge of the triangulation meets there, and what of it is in sight.
//
// The triangles that it crosses have all vertices near it on both sides. Those behind another
// missing segment do not matter: once that is a chain of edges, they are in no triangle at this
// one. What is in sight is told along the crossed edges: from its end an edge sees the first
// segment that crosses it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "delaunay2/incremental.hpp"

namespace tetloft::internal::delaunay2_detail {

struct Sight {
  /// By segment: the vertices of the edges it crosses that see it along one of them, sorted.
  std::vector<std::vector<SiteId>> vertices;
  std::size_t crossings = 0;  // of segments and edges: what it cost
};

/// Requires segments that are no edges, between vertices, and do not cross each other. Where a
/// segment passes through a vertex, that vertex sees it, and what lies behind is left out.
[[nodiscard]] Sight look(const Incremental2& plane,
                         std::span<const std::array<SiteId, 2>> segments);

/// The vertices of all edges that the segment crosses, sorted: those that other segments hide,
/// too.
[[nodiscard]] std::vector<SiteId> vertices_around(const Incremental2& plane,
                                                  const std::array<SiteId, 2>& segment);

}  // namespace tetloft::internal::delaunay2_detail
