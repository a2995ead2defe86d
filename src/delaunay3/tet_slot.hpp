// How the engines hold a tet while they work.
#pragma once

#include <array>

#include <tetloft/ids.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal::delaunay3_detail {

/// A tet as an engine holds it: its vertices, and across the face opposite to each the
/// half-face of the neighbour, perhaps a ghost, or invalid on the hull.
struct TetSlot {
  TetVertices vertices;
  std::array<HalfFaceId, 4> opposite;
};

}  // namespace tetloft::internal::delaunay3_detail
