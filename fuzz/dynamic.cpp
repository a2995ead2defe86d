// Triangulations of space that change: after every operation the tets are those that delaunay3()
// makes of the live points; old handles are refused; answers are those of testing all points or
// tets.
#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include <tetloft/delaunay3.hpp>
#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/predicates.hpp>

#include "fuzz/history.hpp"
#include "fuzz/target.hpp"

namespace tetloft::fuzz {
namespace {

// In space or in a plane.
class PointsOf {
 public:
  explicit PointsOf(Bytes& bytes) : flat_(bytes.below(4) == 0), coordinates_(bytes) {}
  Point3 next() {
    const double x = coordinates_.next();
    const double y = coordinates_.next();
    return {x, y, flat_ ? x : coordinates_.next()};
  }

 private:
  bool flat_;
  ScaledCoordinates coordinates_;
};

class HistoryOfSpace : History<DelaunayTriangulation3, PointsOf> {
 public:
  explicit HistoryOfSpace(Bytes& bytes) : History(bytes) {}

  void operate() {
    change_or_ask();
    compare(made_);
  }

 private:
  void change_or_ask() {
    const auto nothing_is_held = [](DelaunayVertex) { return false; };
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
      case 9: return remove(nothing_is_held);
      case 10: return move(nothing_is_held);
      case 11: return locate();
      case 12: return ask_nearest();
      case 13: return ask_conflict_zone();
      case 14: return pass_through_bytes();
      default: return ask_within();
    }
  }

  // The tets are those of the batch, and they know their neighbours.
  void compare(const DelaunayTriangulation3& t) const {
    compare_vertices(t);
    std::vector<Point3> points;
    for (const Vertex& v : live_) points.push_back(v.point);
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
  }

  void pass_through_bytes() {
    const std::vector<std::byte> bytes = fine_value(made_.serialise());
    DelaunayTriangulation3 read = fine_value(DelaunayTriangulation3::deserialise(bytes));
    require(fine_value(read.serialise()) == bytes, "bytes change on their way");
    swap(made_, read);
  }
};

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft::fuzz;
  Bytes bytes(data, size);
  HistoryOfSpace history(bytes);
  for (std::size_t k = 0; k < kMostOperations && !bytes.empty(); ++k) history.operate();
  return 0;
}
