// A triangulation as bytes: its vertices (core/vertex_record.hpp), the ends of its constraints and
// the edges that these go over. Triangles are not among them: they are unique, so whoever reads the
// bytes makes them anew. Edges are: where constraints were divided they are bent.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"
#include "core/vertex_record.hpp"
#include "triangulation2/handles2.hpp"

namespace tetloft {

using namespace internal;
using triangulation2::LivePlane;

namespace {

constexpr RecordKind kRecordOfTriangulation2{"tri2", 1, "a triangulation of the plane"};

using EndsOfConstraints = IdVector<ConstraintId, std::array<VertexId, 2>>;

// A constraint over an edge.
struct Piece2 {
  std::array<VertexId, 2> edge;  // by increasing id
  ConstraintId of;
};

bool is_before(const Piece2& a, const Piece2& b) {
  return std::tie(a.edge, a.of) < std::tie(b.edge, b.of);
}

std::vector<Piece2> pieces_of(const LivePlane& plane) {
  std::vector<Piece2> pieces;
  for (const triangulation2::PlaneWall& wall : plane.walls().all()) {
    for (const ConstraintId c : wall.constraints()) pieces.push_back({wall.edge(), c});
  }
  std::sort(pieces.begin(), pieces.end(), is_before);
  return pieces;
}

EndsOfConstraints read_ends(RecordReader& reader, const LivePlane& plane) {
  EndsOfConstraints ends(reader.get_count(2 * sizeof(std::uint32_t)));
  for (std::array<VertexId, 2>& e : ends) {
    for (VertexId& v : e) v = reader.get<VertexId>();
    const bool gone = !e[0].valid() && !e[1].valid();
    reader.require(gone || (plane.is_live(e[0]) && plane.is_live(e[1]) && e[0] != e[1]),
                   "has a constraint whose ends are no two vertices");
  }
  return ends;
}

std::vector<Piece2> read_pieces(RecordReader& reader, const LivePlane& plane,
                                const EndsOfConstraints& ends) {
  std::vector<Piece2> pieces(reader.get_count(3 * sizeof(std::uint32_t)));
  for (Piece2& piece : pieces) {
    for (VertexId& v : piece.edge) v = reader.get<VertexId>();
    piece.of = reader.get<ConstraintId>();
    reader.require(plane.is_live(piece.edge[0]) && plane.is_live(piece.edge[1]) &&
                       piece.edge[0] < piece.edge[1],
                   "has a constraint over what is no edge");
    reader.require(piece.of.index() < ends.size() && ends[piece.of][0].valid(),
                   "has an edge of a constraint that there is none of");
  }
  reader.require(std::is_sorted(pieces.begin(), pieces.end(), is_before),
                 "has edges of constraints that are not in order");
  return pieces;
}

// Can one go over the edges, each once, from one of the ends to the other? They are connected then,
// and an odd number of them is at the ends, and at no other vertex (Euler).
bool is_way(std::span<const Piece2> pieces, const std::array<VertexId, 2>& ends) {
  std::vector<VertexId> vertices(ends.begin(), ends.end());
  for (const Piece2& piece : pieces) {
    vertices.insert(vertices.end(), piece.edge.begin(), piece.edge.end());
  }
  sort_distinct(vertices);
  const auto place = [&](VertexId v) {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
    return static_cast<std::uint32_t>(at - vertices.begin());
  };
  std::vector<bool> is_odd(vertices.size());
  UnionFind parts(vertices.size());
  for (const Piece2& piece : pieces) {
    for (const VertexId v : piece.edge) is_odd[place(v)] = !is_odd[place(v)];
    parts.unite(place(piece.edge[0]), place(piece.edge[1]));
  }
  for (const VertexId v : ends) is_odd[place(v)] = !is_odd[place(v)];
  if (std::find(is_odd.begin(), is_odd.end(), true) != is_odd.end()) return false;
  for (const VertexId v : vertices) {
    if (parts.find(place(v)) != parts.find(0)) return false;
  }
  return true;
}

bool are_ways(std::vector<Piece2> pieces, const EndsOfConstraints& ends) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece2& a, const Piece2& b) { return a.of < b.of; });
  auto first = pieces.begin();
  for (const ConstraintId c : ends.ids()) {
    const auto last =
        std::find_if(first, pieces.end(), [&](const Piece2& piece) { return piece.of != c; });
    if (ends[c][0].valid() && !is_way({first, last}, ends[c])) return false;
    first = last;
  }
  return true;
}

// Requires pieces in order. False where something is in the way.
bool add_walls(LivePlane& plane, std::span<const Piece2> pieces) {
  for (std::size_t first = 0; first < pieces.size();) {
    const std::array<VertexId, 2>& edge = pieces[first].edge;
    std::vector<ConstraintId> over;
    for (; first < pieces.size() && pieces[first].edge == edge; ++first) {
      over.push_back(pieces[first].of);
    }
    const LivePlane::Step step = plane.step(edge[0], edge[1]);
    if (step.crossed[0].valid() || step.reached != edge[1]) return false;
    plane.add_to_edge(edge[0], edge[1], over);
  }
  return true;
}

}  // namespace

Result<std::vector<std::byte>> DelaunayTriangulation2::serialise() const {
  return guard_internal([&]() -> Result<std::vector<std::byte>> {
    const Impl& impl = get();
    RecordWriter writer(kRecordOfTriangulation2);
    put_vertices(writer, impl.places, *this);
    writer.put_count(impl.ends.size());
    for (const std::array<VertexId, 2>& ends : impl.ends) {
      for (const VertexId v : ends) writer.put(v);
    }
    const std::vector<Piece2> pieces = pieces_of(impl.plane);
    writer.put_count(pieces.size());
    for (const Piece2& piece : pieces) {
      for (const VertexId v : piece.edge) writer.put(v);
      writer.put(piece.of);
    }
    return writer.take_bytes();
  });
}

Result<DelaunayTriangulation2> DelaunayTriangulation2::deserialise(
    std::span<const std::byte> bytes) {
  return guard_internal([&]() -> Result<DelaunayTriangulation2> {
    if (Result<void> fit = fp_self_check(); !fit) return fit.error();
    RecordReader reader(bytes, kRecordOfTriangulation2);
    auto read = get_vertices<Point2>(reader, triangulation2::Incremental2::kMostVertices);
    DelaunayTriangulation2 result;
    Impl& impl = result.own();
    reader.require(reader.refused() || impl.take_vertices(read.points, read.live),
                   "has two vertices at one point");
    impl.places = std::move(read.places);
    impl.ends = read_ends(reader, impl.plane);
    const std::vector<Piece2> pieces = read_pieces(reader, impl.plane, impl.ends);
    if (Result<void> fine = reader.end(); !fine) return fine.error();
    reader.require(are_ways(pieces, impl.ends), "has a constraint that is no way between its ends");
    reader.require(add_walls(impl.plane, pieces), "has constraints that cross, or pass vertices");
    if (Result<void> fine = reader.end(); !fine) return fine.error();
    impl.constraint_count = static_cast<std::size_t>(std::count_if(
        impl.ends.begin(), impl.ends.end(), [](const auto& ends) { return ends[0].valid(); }));
    return result;
  });
}

}  // namespace tetloft
