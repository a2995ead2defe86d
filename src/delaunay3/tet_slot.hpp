// How the engines hold a tet while they work.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <tetloft/ids.hpp>
#include <tetloft/tet_mesh.hpp>

#include "mesh/tet_soup.hpp"

namespace tetloft::internal::delaunay3_detail {

/// There are no more.
using mesh_detail::kMostTetSlots;

/// A tet as an engine holds it: its vertices, and across the face opposite to each the
/// half-face of the neighbour, perhaps a ghost, or invalid on the hull.
struct TetSlot {
  TetVertices vertices;
  std::array<HalfFaceId, 4> opposite;
};

/// Of face i, as TetMesh has it.
[[nodiscard]] inline HalfFaceId half_face(TetId t, std::size_t i) {
  return HalfFaceId(4 * t.value() + static_cast<std::uint32_t>(i));
}

}  // namespace tetloft::internal::delaunay3_detail
