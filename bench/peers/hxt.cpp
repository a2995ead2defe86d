// HXT (Marot, Pellerin and Remacle 2019), as gmsh has it: its public call for the tets of points,
// with that algorithm. What it spends on gmsh's own vertices and tets is in the time, as for
// whoever calls it.
#include "engines.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmsh.h>

#include "measure.hpp"

namespace tetloft::bench {

namespace {

constexpr double kHxt = 10;  // of Mesh.Algorithm3D

Run run3(std::span<const Point3> points, unsigned threads) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  gmsh::initialize();
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", threads);
  gmsh::option::setNumber("Mesh.MaxNumThreads3D", threads);
  gmsh::option::setNumber("Mesh.Algorithm3D", kHxt);
  std::vector<std::size_t> tets;
  const Clock clock;
  gmsh::model::mesh::tetrahedralize(coordinates, tets);
  const double seconds = clock.seconds();
  gmsh::finalize();
  if (tets.empty()) throw std::runtime_error("gmsh made no tets");
  return {seconds, tets.size() / 4};
}

}  // namespace

Peer hxt() { return {"HXT", "of gmsh " GMSH_API_VERSION, run3, {}, true}; }

}  // namespace tetloft::bench
