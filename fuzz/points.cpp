// The readers of points: text, or binary where the first byte says so.
#include <cmath>

#include <tetloft/formats.hpp>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  if (size == 0) return 0;
  const bool binary = data[0] == 'b';
  const auto points = parse_points(text_of(data + 1, size - 1), binary ? "fuzz.bin" : "fuzz.txt");
  if (!points) {
    require_clean(points.error());
    require(!points.error().where.file.empty(), "an error without the file's name");
    return 0;
  }
  for (const Point3& p : points->points) {
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "not finite");
  }
  return 0;
}
