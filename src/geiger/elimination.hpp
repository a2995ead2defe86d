// Steps 4 and 5 of Geiger's algorithm: which tets of a slab stay.
#pragma once

#include <cstdint>
#include <vector>

#include "slab/slab.hpp"

namespace tetloft::internal::geiger {

struct Elimination {
  IdVector<TetId, std::uint8_t> stays;
  std::size_t external = 0;  ///< tets that an external edge or triangle eliminated
  std::size_t singular = 0;  ///< tets of singular connections
};

[[nodiscard]] Elimination eliminate(const Slab& slab);

}  // namespace tetloft::internal::geiger
