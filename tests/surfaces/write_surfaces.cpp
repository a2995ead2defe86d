// write_surfaces FOLDER: a patient's boxes in every format of surfaces, and their solid as .vtu,
// for read_surfaces.py.
#include <cstdio>
#include <string>

#include <tetloft/formats.hpp>

#include "support/box_models.hpp"

int main(int argc, char** argv) {
  using namespace tetloft;
  if (argc != 2) return 2;
  const std::string folder = std::string(argv[1]) + '/';
  const Model model = testing::boxes_in_a_patient();
  bool fine = write_vtu(folder + "solid.vtu", model).ok();
  for (const FormatInfo& format : formats()) {
    if (!format.writes.has(Contents::surface)) continue;
    const std::string extension(format.extensions.front());
    fine = fine && write_surface(folder + "binary" + extension, model, Encoding::binary).ok() &&
           write_surface(folder + "text" + extension, model, Encoding::ascii).ok();
  }
  if (!fine) std::fputs("cannot write\n", stderr);
  return fine ? 0 : 1;
}
