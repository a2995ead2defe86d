#include <cstdio>
#include <tetloft/tetloft.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto input = tetloft::read_cnt(argv[1]);
  if (!input) {
    std::fprintf(stderr, "%s\n", to_string(input.error()).c_str());
    return 3;
  }

  tetloft::ReconstructOptions options;
  options.correspondence.tau = 0.1;  // unite regions that overlap by a tenth
  const auto solid = tetloft::reconstruct(input->stack, options);
  if (!solid) {  // never a wrong model: an error that names the place
    std::fprintf(stderr, "%s\n", to_string(solid.error()).c_str());
    return 5;
  }
  std::printf("%zu tets in %zu components, volume %g\n", solid->report.tets,
              solid->report.components, solid->report.volume);

  // The model is values: points, tets, and where each of them comes from.
  const tetloft::Surface surface = tetloft::boundary_surface(solid->model);
  const auto topology = tetloft::surface_components(surface.triangles).topology;
  std::printf("%zu boundary surfaces, the first of genus %ld\n", topology.size(),
              topology.empty() ? 0 : topology[0].genus());

  return tetloft::write_vtu(argv[2], solid->model) ? 0 : 4;
}
