// A triangulation as bytes: places, generations, points and the order in which free places are
// taken. Tets are not among them: they are unique, so whoever reads the bytes makes them anew.
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/record.hpp"
#include "triangulation3/handles3.hpp"

namespace tetloft {

using namespace internal;

namespace {

constexpr RecordKind kRecordOfTriangulation3{"tri3", 1, "a triangulation"};

}  // namespace

Result<std::vector<std::byte>> DelaunayTriangulation3::serialise() const {
  return guard_internal([&]() -> Result<std::vector<std::byte>> {
    const Impl& impl = get();
    RecordWriter writer(kRecordOfTriangulation3);
    writer.put_all(impl.places.generation);
    writer.put_all(impl.places.free);
    writer.put_count(vertex_count());
    for (const DelaunayVertex v : vertices()) {
      writer.put(v.index);
      for (const double x : {point(v).x, point(v).y, point(v).z}) writer.put(x);
    }
    const std::string bytes = writer.take();
    std::vector<std::byte> result(bytes.size());
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  });
}

Result<DelaunayTriangulation3> DelaunayTriangulation3::deserialise(
    std::span<const std::byte> bytes) {
  return guard_internal([&]() -> Result<DelaunayTriangulation3> {
    if (Result<void> fit = fp_self_check(); !fit) return fit.error();
    RecordReader reader({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                        kRecordOfTriangulation3, {});
    DelaunayTriangulation3 result;
    Impl& impl = result.own();
    impl.places.generation = reader.get_all<std::uint32_t>();
    impl.places.free = reader.get_all<std::uint32_t>();
    const std::size_t count = reader.get_count(sizeof(std::uint32_t) + 3 * sizeof(double));
    const std::size_t places = impl.places.generation.size();
    reader.require(
        places < triangulation3::kMostVertices && places == impl.places.free.size() + count,
        "has places that are neither free nor a vertex's");
    std::vector<Point3> points(reader.refused() ? 0 : places);
    std::vector<std::uint8_t> taken(points.size());
    std::vector<VertexId> vertices;
    const auto take = [&](std::uint32_t place) {
      const bool fine = place < taken.size() && taken[place] == 0;
      reader.require(fine, "has a place twice, or one that it does not have");
      if (fine) taken[place] = 1;
      return fine;
    };
    for (std::size_t k = 0; k < count && !reader.refused(); ++k) {
      const auto place = reader.get<std::uint32_t>();
      const auto x = reader.get<double>();
      const auto y = reader.get<double>();
      const auto z = reader.get<double>();
      if (!take(place)) break;
      points[place] = {x, y, z};
      reader.require(triangulation3::check_point(points[place]).ok(),
                     "has a coordinate that is not finite");
      vertices.push_back(triangulation3::id_of_place(place));
    }
    for (const std::uint32_t place : impl.places.free) {
      if (reader.refused() || !take(place)) break;
    }
    if (Result<void> fine = reader.end(); !fine) return fine.error();
    if (!impl.take_vertices(points, std::move(vertices))) {
      return Error{ErrorCode::invalid_input, "a triangulation with two vertices at one point", {}};
    }
    return result;
  });
}

}  // namespace tetloft
