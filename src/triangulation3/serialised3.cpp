// A triangulation as bytes: places, generations, points and the order in which free places are
// taken. Tets are not among them: they are unique, so whoever reads the bytes makes them anew.
#include <cstdint>
#include <utility>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/vertex_record.hpp"
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
    put_vertices(writer, impl.places, *this);
    return writer.take_bytes();
  });
}

Result<DelaunayTriangulation3> DelaunayTriangulation3::deserialise(
    std::span<const std::byte> bytes) {
  return guard_internal([&]() -> Result<DelaunayTriangulation3> {
    if (Result<void> fit = fp_self_check(); !fit) return fit.error();
    RecordReader reader(bytes, kRecordOfTriangulation3);
    auto read = get_vertices<Point3>(reader, triangulation3::kMostVertices);
    if (Result<void> fine = reader.end(); !fine) return fine.error();
    DelaunayTriangulation3 result;
    Impl& impl = result.own();
    impl.places = std::move(read.places);
    std::vector<VertexId> vertices;
    for (const std::uint32_t place : read.live) {
      vertices.push_back(triangulation3::id_of_place(place));
    }
    reader.require(impl.take_vertices(read.points, std::move(vertices)),
                   "has two vertices at one point");
    if (Result<void> fine = reader.end(); !fine) return fine.error();
    return result;
  });
}

}  // namespace tetloft
