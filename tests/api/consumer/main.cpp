// A cube from its lower and upper side.
#include <cstdio>
#include <tetloft/tetloft.hpp>

int main() {
  const tetloft::Contour square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  tetloft::SectionStack stack;
  for (const double z : {0.0, 10.0}) {
    tetloft::Section section;
    section.z = z;
    section.contours.push_back(square);
    stack.sections.push_back(section);
  }
  const auto cube = tetloft::reconstruct(stack);
  if (!cube) {
    std::fprintf(stderr, "%s\n", to_string(cube.error()).c_str());
    return 1;
  }
  std::printf("tetloft %s: volume %g\n", tetloft::version(), cube->report.volume);
  return 0;
}
