// Triangulations of space that change: after every operation the tets are those that delaunay3()
// makes of the live points; old handles are refused; answers are those of testing all points or
// tets. Distances are compared by the library's predicate, which has tests of its own.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <tetloft/delaunay3.hpp>
#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/predicates.hpp>

#include "fuzz/target.hpp"
#include "predicates/distances.hpp"

namespace tetloft::fuzz {
namespace {

using internal::predicates::compare_distance;
using internal::predicates::compare_distances;

constexpr std::size_t kMostOperations = 48;

template <class Value>
Value fine_value(Result<Value> result) {
  if (!result) {
    require_clean(result.error());
    require(false, "finite points are refused: " + to_string(result.error()));
  }
  return *std::move(result);
}

// A lattice or doubles of any size, in space or in a plane, times a power of two.
class PointsOf {
 public:
  explicit PointsOf(Bytes& bytes)
      : flat_(bytes.below(4) == 0), exponent_(kExponents[bytes.below(4)]), coordinates_(bytes) {}
  Point3 next() {
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, flat_ ? x : coordinate()};
  }

 private:
  static constexpr std::array<int, 4> kExponents{0, 0, -400, 300};
  double coordinate() {
    const double x = std::ldexp(coordinates_.next(), exponent_);
    return x - x == 0 ? x : 1;
  }
  bool flat_;
  int exponent_;
  Coordinates coordinates_;
};

// A triangulation and what is known of it: who lives where, and who is gone.
class Known {
 public:
  struct Vertex {
    DelaunayVertex handle;
    Point3 point;
  };

  explicit Known(Bytes& bytes) : bytes_(bytes), points_(bytes) {}

  void operate() {
    switch (bytes_.below(16)) {
      case 0:
      case 1:
      case 2:
      case 3:
      case 4:
      case 5: return insert();
      case 6: return insert_many();
      case 7:
      case 8:
      case 9: return remove();
      case 10: return move();
      case 11: return locate();
      case 12: return ask_nearest();
      case 13: return ask_conflict_zone();
      case 14: return pass_through_bytes();
      default: return ask_within();
    }
  }

 private:
  const Vertex* at(const Point3& p) const {
    for (const Vertex& v : live_) {
      if (v.point == p) return &v;
    }
    return nullptr;
  }
  /// Of a live vertex, of one that is gone, or of none.
  DelaunayVertex any_handle() {
    const std::size_t k = bytes_.byte();
    if (k < 32 || (live_.empty() && gone_.empty())) return {};
    if (!gone_.empty() && (k < 64 || live_.empty())) return gone_[k % gone_.size()];
    return live_[k % live_.size()].handle;
  }
  std::vector<Vertex>::iterator find(DelaunayVertex v) {
    return std::find_if(live_.begin(), live_.end(),
                        [&](const Vertex& known) { return known.handle == v; });
  }

  void insert() {
    const Point3 p = points_.next();
    const bool is_new = at(p) == nullptr;
    const auto made = fine_value(made_.insert(p, any_handle()));
    require(made.is_new == is_new, "a point is new, or is not");
    learn(made.vertex, p);
    compare(made_);
  }
  void insert_many() {
    std::vector<Point3> points(bytes_.below(8));
    for (Point3& p : points) p = points_.next();
    const auto made = fine_value(made_.insert(points, {.threads = 1}));
    for (std::size_t i = 0; i < points.size(); ++i) learn(made[i], points[i]);
    compare(made_);
  }
  void learn(DelaunayVertex v, const Point3& p) {
    if (const Vertex* known = at(p)) {
      require(v == known->handle, "a point has another vertex");
    } else {
      require(find(v) == live_.end(), "a handle twice");
      live_.push_back({v, p});
    }
  }
  void remove() {
    const DelaunayVertex v = any_handle();
    const auto known = find(v);
    const Result<void> removed = made_.remove(v);
    require(removed.ok() == (known != live_.end()), "a vertex is removed, or is not");
    if (!removed) {
      require_clean(removed.error());
    } else {
      gone_.push_back(v);
      live_.erase(known);
    }
    compare(made_);
  }
  void move() {
    const DelaunayVertex v = any_handle();
    const Point3 to = points_.next();
    const auto known = find(v);
    const Vertex* there = at(to);
    const bool can = known != live_.end() && (there == nullptr || there->handle == v);
    const Result<void> moved = made_.move(v, to);
    require(moved.ok() == can, "a vertex moves, or does not");
    if (can) known->point = to;
    if (!moved) require_clean(moved.error());
    compare(made_);
  }

  // The tets are those of the batch, and they know their neighbours.
  void compare(const DelaunayTriangulation3& t) const {
    require(t.vertex_count() == live_.size(), "count of vertices");
    std::vector<Point3> points;
    for (const Vertex& v : live_) {
      require(t.is_live(v.handle) && t.point(v.handle) == v.point, "a vertex is elsewhere");
      points.push_back(v.point);
    }
    for (const DelaunayVertex v : gone_) require(!t.is_live(v), "a vertex that is gone lives");
    const Delaunay3 batch = fine_value(delaunay3(points));
    require(batch.dimension == t.dimension(), "another dimension");
    using Quad = std::array<DelaunayVertex, 4>;
    const auto sorted = [](auto v) {
      std::sort(v.begin(), v.end());
      return v;
    };
    std::set<Quad> expected;
    for (std::size_t k = 0; k < batch.mesh.tet_slots(); ++k) {
      Quad quad;
      for (std::size_t i = 0; i < 4; ++i) {
        quad[i] = live_[batch.mesh.vertices(TetId(k))[i].index()].handle;
      }
      expected.insert(sorted(quad));
    }
    std::set<Quad> found;
    for (const TetId tet : t.tets()) {
      found.insert(sorted(t.vertices(tet)));
      for (std::uint32_t i = 0; i < 4; ++i) {
        const HalfFaceId h(4 * tet.value() + i);
        const HalfFaceId across = t.opposite(h);
        if (!across.valid()) continue;
        require(t.opposite(across) == h && sorted(t.vertices(h)) == sorted(t.vertices(across)),
                "faces do not fit");
      }
    }
    require(found == expected && found.size() == t.tet_count(), "other tets than the batch");
  }

  std::array<Point3, 4> corners(TetId t) const {
    const auto v = made_.vertices(t);
    return {made_.point(v[0]), made_.point(v[1]), made_.point(v[2]), made_.point(v[3])};
  }
  Sign side(HalfFaceId h, const Point3& p) const {
    const auto v = made_.vertices(h);
    return orient3d(made_.point(v[0]), made_.point(v[1]), made_.point(v[2]), p);
  }
  void locate() {
    const Point3 p = points_.next();
    const Location3 found = fine_value(made_.locate(p, any_handle()));
    const Vertex* known = at(p);
    require((found.kind == LocationKind::vertex) == (known != nullptr), "a vertex is not found");
    if (known != nullptr) require(found.vertices[0] == known->handle, "another vertex is found");
    if (made_.dimension() < 3) return;
    const std::vector<HalfFaceId> hull = made_.hull();
    const bool outside = std::any_of(hull.begin(), hull.end(),
                                     [&](HalfFaceId h) { return side(h, p) == Sign::positive; });
    require((found.kind == LocationKind::outside) == outside, "a point is in the hull, or is not");
    if (outside) return;
    const auto vertices = made_.vertices(found.tet);
    std::vector<DelaunayVertex> simplex;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Sign s = side(HalfFaceId(4 * found.tet.value() + i), p);
      require(s != Sign::positive, "a point is beyond a face of its tet");
      if (s != Sign::zero) simplex.push_back(vertices[i]);
    }
    std::sort(simplex.begin(), simplex.end());
    simplex.resize(4);
    require(std::equal(simplex.begin(), simplex.end(), found.vertices.begin()), "another simplex");
  }

  std::vector<DelaunayVertex> by_distance(const Point3& p) const {
    std::vector<Vertex> all = live_;
    std::sort(all.begin(), all.end(), [&](const Vertex& a, const Vertex& b) {
      const Sign s = compare_distances(p, a.point, b.point);
      return s == Sign::negative || (s == Sign::zero && a.handle.index < b.handle.index);
    });
    std::vector<DelaunayVertex> result;
    for (const Vertex& v : all) result.push_back(v.handle);
    return result;
  }
  void ask_nearest() {
    const Point3 p = points_.next();
    std::vector<DelaunayVertex> expected = by_distance(p);
    const DelaunayVertex nearest = fine_value(made_.nearest_vertex(p, any_handle()));
    require(nearest == (expected.empty() ? DelaunayVertex() : expected.front()),
            "another vertex is nearest");
    const std::size_t k = bytes_.below(8);
    expected.resize(std::min(k, expected.size()));
    require(fine_value(made_.nearest_vertices(p, k, any_handle())) == expected,
            "other vertices are nearest");
  }
  void ask_within() {
    const Point3 p = points_.next();
    const double radius = std::abs(points_.next().x);
    std::vector<DelaunayVertex> expected = by_distance(p);
    std::erase_if(expected, [&](DelaunayVertex v) {
      return compare_distance(p, made_.point(v), radius) == Sign::positive;
    });
    require(fine_value(made_.vertices_within(p, radius, any_handle())) == expected,
            "other vertices are within");
  }

  // Its tets by their spheres, the rest by an insertion into a copy.
  void ask_conflict_zone() {
    const Point3 p = points_.next();
    const ConflictZone3 zone = fine_value(made_.conflict_zone(p, any_handle()));
    if (made_.dimension() < 3 || at(p) != nullptr) {
      require(zone.tets.empty() && zone.horizon.empty() && zone.neighbours.empty(),
              "a zone where nothing changes");
      return;
    }
    std::vector<TetId> tets;
    for (const TetId t : made_.tets()) {
      const auto c = corners(t);
      if (insphere_perturbed(c[0], c[1], c[2], c[3], p) == Sign::positive) tets.push_back(t);
    }
    require(zone.tets == tets, "another zone");
    DelaunayTriangulation3 changed = made_;
    const DelaunayVertex v = fine_value(changed.insert(p)).vertex;
    require(changed.neighbours(v) == zone.neighbours, "other neighbours");
    // Where p sees a facet of the hull, it becomes a tet's.
    require(changed.star(v).size() == zone.horizon.size(), "another horizon");
    compare(made_);
  }

  void pass_through_bytes() {
    const std::vector<std::byte> bytes = fine_value(made_.serialise());
    DelaunayTriangulation3 read = fine_value(DelaunayTriangulation3::deserialise(bytes));
    require(fine_value(read.serialise()) == bytes, "bytes change on their way");
    compare(read);
    swap(made_, read);
  }

  Bytes& bytes_;
  PointsOf points_;
  DelaunayTriangulation3 made_;
  std::vector<Vertex> live_;
  std::vector<DelaunayVertex> gone_;
};

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft::fuzz;
  Bytes bytes(data, size);
  Known known(bytes);
  for (std::size_t k = 0; k < kMostOperations && !bytes.empty(); ++k) known.operate();
  return 0;
}
