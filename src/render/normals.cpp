#include "render/normals.hpp"

#include "model/corner_normals.hpp"
#include "render/subject.hpp"

namespace tetloft::internal::render {

std::vector<std::array<Point3, 3>> smooth_normals(const Subject& subject) {
  std::vector<std::array<std::uint32_t, 3>> triangles(subject.boundary.size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const HalfFaceId h = subject.boundary[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto local = static_cast<std::size_t>(kFaceVertex[h.value() & 3U][i]);
      triangles[k][i] = subject.tets[h.value() >> 2][local].value();
    }
  }
  return corner_normals(subject.points, triangles);
}

}  // namespace tetloft::internal::render
