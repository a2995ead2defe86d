// Links of vertices as sets of triangles, and whether such a set is a disc: by definition.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "slab/slab.hpp"

namespace tetloft::testing {

using namespace internal;

using LinkTriangle = std::set<SlabVertexId>;

/// What the tets marked at their corner v are in the link of v; bit i of a mask: corner i.
[[nodiscard]] std::vector<LinkTriangle> link_of(const Slab& slab,
                                                const IdVector<TetId, std::uint8_t>& marked,
                                                SlabVertexId v);

/// Empty if the triangles form a disc, else what is wrong.
[[nodiscard]] std::string not_a_disc(const std::vector<LinkTriangle>& triangles);

}  // namespace tetloft::testing
