// See polygons.hpp.
#include "io/polygons.hpp"

#include <algorithm>
#include <utility>

namespace tetloft::internal::io {

void PolygonList::add_polygon(const std::vector<std::uint32_t>& corners, std::size_t place) {
  if (!corners.empty()) {
    const std::uint32_t most = *std::max_element(corners.begin(), corners.end());
    if (!highest_ || most > highest_->point) highest_ = Missing{most, place};
  }
  if (corners.size() < 3) ++small_;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    read_.mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

std::optional<PolygonList::Missing> PolygonList::missing() const {
  return highest_ && highest_->point >= points() ? highest_ : std::nullopt;
}

ReadTriangles PolygonList::take(const std::string& name) {
  if (small_ > 0) {
    Warning warning{"left out: " + std::to_string(small_) + (small_ == 1 ? " face" : " faces") +
                        " of fewer than three corners",
                    {}};
    warning.where.file = name;
    read_.warnings.push_back(std::move(warning));
  }
  return std::move(read_);
}

}  // namespace tetloft::internal::io
