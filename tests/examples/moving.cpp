// Points that move, and the neighbours of each at every step: a gas of soft balls in a box, which
// push away the ones they have an edge with in the Delaunay triangulation.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 10000;
  std::uint64_t state = 1;
  const auto next = [&state] {  // of [0, 1), by a multiplicative generator
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) * 0x1p-53;
  };
  std::vector<tetloft::Point3> points(n);
  for (tetloft::Point3& point : points) point = {next(), next(), next()};
  const auto made = tetloft::DelaunayTriangulation3::of(points);
  if (!made) {
    std::fprintf(stderr, "%s\n", to_string(made.error()).c_str());
    return 1;
  }
  tetloft::DelaunayTriangulation3 balls = *made;

  // Ranges end with the next change, handles stay good: here they are kept.
  std::vector<tetloft::DelaunayVertex> all;
  for (const tetloft::DelaunayVertex v : balls.vertices()) all.push_back(v);
  const double reach = std::cbrt(1.0 / static_cast<double>(n));
  for (int step = 0; step < 3; ++step) {
    std::size_t joined = 0, pushed = 0, refused = 0;
    // Where each one goes is decided before any moves.
    tetloft::DelaunayVertexMap<tetloft::Point3> goes_to;
    for (const tetloft::DelaunayVertex v : all) {
      const tetloft::Point3 at = balls.point(v);
      tetloft::Point3 to = at;
      for (const tetloft::DelaunayVertex u : balls.neighbours(v)) {
        const tetloft::Point3 other = balls.point(u);
        const double x = at.x - other.x, y = at.y - other.y, z = at.z - other.z;
        const double distance = std::sqrt(x * x + y * y + z * z);
        ++joined;
        if (distance >= reach) continue;
        ++pushed;
        const double push = 0.1 * (reach - distance) / distance;
        to = {to.x + push * x, to.y + push * y, to.z + push * z};
      }
      goes_to[v] = to;
    }
    for (const tetloft::DelaunayVertex v : all) {
      // What is refused stays where it is: another ball is there.
      if (!balls.move(v, *goes_to.find(v))) ++refused;
    }
    std::printf("step %d: %zu tets, %.2f neighbours each, %zu contacts, %zu refused\n", step,
                balls.tet_count(), static_cast<double>(joined) / static_cast<double>(n), pushed / 2,
                refused);
  }

  const auto nearest = balls.nearest_vertices({0.5, 0.5, 0.5}, 3);
  if (!nearest) return 1;
  std::printf("nearest to the centre:");
  for (const tetloft::DelaunayVertex v : *nearest) std::printf(" %u", v.index);
  std::printf("\n");
  return 0;
}
