// One module of the library, by its public header.
#include <tetloft/delaunay.hpp>

std::size_t tets(const std::vector<tetloft::Point3>& points) {
  const auto delaunay = tetloft::delaunay3(points);
  return delaunay ? delaunay->mesh.tet_count() : 0;
}
