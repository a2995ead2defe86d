// What from_tets() and add_tet() ask of tets, and how they refuse them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal::mesh_detail {

/// Ids are 32 bits, one of them the invalid one.
inline constexpr std::size_t kMostVertices = VertexId::kInvalid;
/// The half-face 4 t + i must stay below HalfFaceId::kInvalid = 2^32 − 1.
inline constexpr std::size_t kMostTetSlots = (std::size_t{1} << 30) - 1;

/// Why `tet`, slot `name`, cannot be in any mesh over `vertex_count`
/// vertices; nothing if it can.
[[nodiscard]] std::optional<Error> refuse_tet(const TetVertices& tet, std::size_t vertex_count,
                                              TetId name);

[[nodiscard]] Error refusal(std::string message);

/// "face (1, 2, 3)".
[[nodiscard]] std::string face_text(const std::array<std::uint32_t, 3>& vertices);

}  // namespace tetloft::internal::mesh_detail
