// What a point lies in, of a triangulation.
#pragma once

#include <cstdint>

#include <tetloft/export.hpp>

namespace tetloft {

/// The smallest simplex that holds a point. A triangle is a facet, in the plane too.
enum class LocationKind : std::uint8_t { vertex, edge, facet, tet, outside };
/// "vertex", "edge", "facet", "tet", "outside".
[[nodiscard]] TETLOFT_API const char* name_of(LocationKind kind);

}  // namespace tetloft
