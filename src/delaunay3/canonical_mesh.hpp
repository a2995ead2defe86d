// The finite tets of an engine as a mesh in canonical numbering: the order of insertion,
// recycled slots, ghosts and the number of threads leave no trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <tetloft/ids.hpp>
#include <tetloft/tet_mesh.hpp>

#include "delaunay3/tet_slot.hpp"

namespace tetloft::internal::delaunay3_detail {

/// How the engine's vertices are named outside.
struct VertexNames {
  /// rank_of[v]: place of the engine's vertex v in canonical order; below 2^30.
  std::span<const std::uint32_t> rank_of;
  /// input_of[r]: the input index of the point of canonical rank r.
  std::span<const VertexId> input_of;
  /// Number of input points.
  std::size_t input_count = 0;
};

/// The finite tets, numbered as struct Delaunay3 says. Slots are skipped whose vertex 0 is no
/// vertex: ghosts and dead ones. Uses up `built`: what its slots hold afterwards is unspecified,
/// and of many their memory is given back on the way, so that slots and mesh together never take
/// much more than the larger of them. Linear in tets but for sorting the tets that share their
/// lowest vertex.
[[nodiscard]] TetMesh canonical_mesh(std::span<TetSlot> built, const VertexNames& names,
                                     unsigned threads);

}  // namespace tetloft::internal::delaunay3_detail
