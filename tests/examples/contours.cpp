// Contours to arrays: a stack out of numbers, a solid, and its numbers for whoever takes arrays.
#include <cstdint>
#include <cstdio>
#include <vector>

#include <tetloft/tetloft.hpp>

int main() {
  // A ring that narrows upwards: an outer contour and a hole, in either direction.
  tetloft::SectionStack stack;
  for (int i = 0; i < 4; ++i) {
    const double r = 5 - i;
    tetloft::Section section;
    section.z = 2 * i;
    section.contours.push_back({{{-r, -r}, {r, -r}, {r, r}, {-r, r}}});
    section.contours.push_back({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
    stack.sections.push_back(section);
  }

  const auto solid = tetloft::reconstruct(stack);
  if (!solid) {  // never a wrong model: an error that names the place
    std::fprintf(stderr, "%s\n", to_string(solid.error()).c_str());
    return 1;
  }
  const tetloft::Model& model = solid->model;

  // Points are three doubles and tets four 32-bit ids, one behind the other.
  const double* const xyz = &model.points.raw().front().x;
  std::vector<std::uint32_t> ids;
  for (const tetloft::TetVertices& tet : model.tets) {
    for (const tetloft::VertexId v : tet) ids.push_back(v.value());
  }
  std::printf("%zu points, the first (%g, %g, %g); %zu tets\n", model.points.size(), xyz[0], xyz[1],
              xyz[2], ids.size() / 4);

  // Where everything comes from: which points are the input's, bit for bit.
  std::size_t given = 0;
  for (const tetloft::PointOrigin origin : model.origin) {
    if (origin == tetloft::PointOrigin::input) ++given;
  }
  const tetloft::Surface surface = tetloft::boundary_surface(model);
  const auto shells = tetloft::surface_components(surface.triangles).topology;
  std::printf("%zu vertices of the input; volume %g; %zu boundary of genus %ld\n", given,
              tetloft::volume(model), shells.size(), shells.front().genus());
  return 0;
}
