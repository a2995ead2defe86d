// What is asked of a triangulation and answered in its own ids.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "triangulation3/live_tets.hpp"

namespace tetloft::internal::triangulation3 {

/// The smallest simplex that holds a point.
struct Simplex {
  TetId tet;  ///< a finite one that has it; invalid where the point is outside
  std::vector<VertexId> vertices;
};
[[nodiscard]] Simplex simplex_at(const LiveTets& tets, const Point3& p, VertexId near);

/// The tets that go where p is inserted, finite and ghosts, in the order in which they are found.
/// Requires dimension 3, and a point that is no vertex.
[[nodiscard]] std::vector<TetId> zone_of(const LiveTets& tets, const Point3& p, VertexId near);

/// The tets around the edge u v in order, ghosts included, each next across the face that leads on;
/// empty where it is no edge. `u` and `v` are live.
[[nodiscard]] std::vector<TetId> ring_of(const LiveTets& tets, VertexId u, VertexId v);

}  // namespace tetloft::internal::triangulation3
