#include <cstdio>
#include <tetloft/tetloft.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto input = tetloft::read_stack(argv[1]);
  const auto solid = input ? tetloft::reconstruct(input->stack) : input.error();
  if (!solid) {  // never a wrong model: an error that names the place
    std::fprintf(stderr, "%s\n", to_string(solid.error()).c_str());
    return 1;
  }
  std::printf("%zu tets, volume %g\n", solid->report.tets, solid->report.volume);
  const auto written = tetloft::write_model(argv[2], solid->model);
  if (!written) std::fprintf(stderr, "%s\n", to_string(written.error()).c_str());
  return written ? 0 : 1;
}
