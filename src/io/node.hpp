// TetGen's .node: points, by themselves or of the .ele beside them.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

#include "io/format.hpp"

namespace tetloft::internal::io {

struct NodePoints {
  std::vector<Point3> points;  ///< finite
  std::int64_t first = 0;      ///< the number of the first: 0 or 1
  std::vector<Warning> warnings;
};

[[nodiscard]] Result<NodePoints> read_node_points(const Source& source);

}  // namespace tetloft::internal::io
