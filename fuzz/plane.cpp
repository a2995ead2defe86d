// Triangulations of the plane that change, with constraints: after every operation they are those
// of delaunay2(), or constrained ones by an oracle of public predicates; old handles are refused;
// answers are those of asking all.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/predicates.hpp>

#include "fuzz/history.hpp"
#include "fuzz/plane_oracle.hpp"
#include "fuzz/target.hpp"

namespace tetloft::fuzz {
namespace {

// What is compared by pairs.
constexpr std::size_t kMostVertices = 300;

// Of the plane, in a row, beside a row or all a few ulps apart.
class PointsOfPlane {
 public:
  explicit PointsOfPlane(Bytes& bytes) : bytes_(bytes), form_(bytes.below(8)), scaled_(bytes) {}
  Point2 next() {
    if (form_ == 0) return {ulps_from_one(), ulps_from_one()};
    const double x = scaled_.next();
    if (form_ == 1) return {x, x};
    if (form_ == 2) {
      const double y = x / 3;
      const std::size_t side = bytes_.below(4);
      return {x, side == 0 ? std::nextafter(y, -9.0) : side == 1 ? std::nextafter(y, 9.0) : y};
    }
    return {x, scaled_.next()};
  }

 private:
  double ulps_from_one() { return 1 + static_cast<double>(bytes_.below(16)) * 0x1p-52; }

  Bytes& bytes_;
  std::size_t form_;
  ScaledCoordinates scaled_;
};

class HistoryOfPlane : History<DelaunayTriangulation2, PointsOfPlane> {
 public:
  explicit HistoryOfPlane(Bytes& bytes) : History(bytes) {}

  [[nodiscard]] bool is_large() const { return live_.size() > kMostVertices; }

  void operate() {
    switch (bytes_.below(24)) {
      case 0: return locate();
      case 1: return ask_nearest();
      case 2: return ask_within();
      case 3: return ask_inside();
      default: change();
    }
    compare(made_);
  }

 private:
  struct Constraint {
    ConstraintId id;
    Edge ends;
    bool straight = true;  // not divided where it crosses another one
  };

  void change() {
    const auto is_held = [&](DelaunayVertex v) { return PlaneOracle(made_).is_held(v); };
    switch (bytes_.below(16)) {
      case 0: return insert_many();
      case 1:
      case 2: return remove(is_held);
      case 3: return move(is_held);
      case 4:
      case 5:
      case 6: return insert_constraint(Crossing::refuse);
      case 7:
      case 8: return insert_constraint(Crossing::split);
      case 9: return insert_constraints();
      case 10:
      case 11: return remove_constraint();
      case 12: return copy();
      default: return insert();
    }
  }

  void insert_constraint(Crossing crossing) {
    const DelaunayVertex u = any_handle();
    const DelaunayVertex v = any_handle();
    const bool is_segment = u != v && find(u) != live_.end() && find(v) != live_.end();
    const bool crosses =
        is_segment && PlaneOracle(made_).crosses_a_wall(made_.point(u), made_.point(v));
    const Result<ConstraintId> made = made_.insert_constraint(u, v, crossing);
    if (crossing == Crossing::refuse || !crosses) {
      require(made.ok() == (is_segment && !crosses), "a constraint is inserted, or is not");
    }
    if (!made) return require_division_failed(made.error(), is_segment && crosses);
    learn_constraint(*made, {u, v});
    if (crosses) learn_divided();
  }
  // As one by one.
  void insert_constraints() {
    std::vector<Edge> segments(bytes_.below(5));
    for (Edge& e : segments) e = {any_handle(), any_handle()};
    const Crossing crossing = bytes_.below(2) == 0 ? Crossing::refuse : Crossing::split;
    DelaunayTriangulation2 one_by_one = made_;
    std::vector<ConstraintId> expected;
    for (const Edge& e : segments) {
      const Result<ConstraintId> made = one_by_one.insert_constraint(e[0], e[1], crossing);
      if (!made) break;
      expected.push_back(*made);
    }
    const auto made = made_.insert_constraints(segments, crossing);
    require(made.ok() == (expected.size() == segments.size()),
            "constraints are inserted, or are not");
    if (!made) return require_clean(made.error());
    require(*made == expected, "other constraints than one by one");
    require(made_.edges() == one_by_one.edges(), "other edges than one by one");
    for (std::size_t i = 0; i < segments.size(); ++i) learn_constraint((*made)[i], segments[i]);
    if (crossing == Crossing::split) learn_divided();
  }
  // Where there was no room for it, and not because pieces led to pieces.
  static void require_division_failed(const Error& error, bool crosses) {
    require_clean(error);
    require(error.code != ErrorCode::work_limit, "pieces without end");
    require(error.code == ErrorCode::invalid_input || crosses, "an error of no crossing");
  }
  void learn_constraint(ConstraintId c, const Edge& ends) {
    for (const Constraint& known : constraints_) require(known.id < c, "an id twice");
    constraints_.push_back({c, ends});
  }
  // Vertices where constraints cross, and which of those are no segments any more.
  void learn_divided() {
    for (const DelaunayVertex v : made_.vertices()) {
      if (find(v) != live_.end()) continue;
      require(at(made_.point(v)) == nullptr, "a crossing is put on a vertex");
      live_.push_back({v, made_.point(v)});
    }
    const PlaneOracle oracle(made_);
    for (Constraint& c : constraints_) {
      c.straight = c.straight && made_.edges(c.id) == oracle.edges_on(c.ends[0], c.ends[1]);
    }
  }
  void remove_constraint() {
    const std::size_t k = bytes_.byte();
    if (constraints_.empty()) {
      const Result<void> removed = made_.remove_constraint(ConstraintId(k));
      require(!removed, "a constraint is removed that never was");
      return require_clean(removed.error());
    }
    const auto known = constraints_.begin() + static_cast<std::ptrdiff_t>(k % constraints_.size());
    const ConstraintId c = known->id;
    require(made_.remove_constraint(c).ok(), "a constraint is not removed");
    constraints_.erase(known);
    require(!made_.is_live(c) && !made_.remove_constraint(c), "a constraint is removed twice");
  }

  void compare(const DelaunayTriangulation2& t) const {
    compare_vertices(t);
    require(t.constraint_count() == constraints_.size(), "count of constraints");
    const PlaneOracle oracle(t);
    for (const Constraint& c : constraints_) {
      require(t.is_live(c.id) && t.ends(c.id) == c.ends, "a constraint has other ends");
      if (c.straight) {
        require(t.edges(c.id) == oracle.edges_on(c.ends[0], c.ends[1]), "edges of a constraint");
      } else {
        require_connected(t, c);
      }
    }
    oracle.require_all();
  }
  // From one end to all of its edges and to the other one, and not out of the segment's box.
  static void require_connected(const DelaunayTriangulation2& t, const Constraint& c) {
    std::vector<Edge> open = t.edges(c.id);
    std::vector<DelaunayVertex> reached{c.ends[0]};
    for (std::size_t k = 0; k < reached.size(); ++k) {
      std::erase_if(open, [&](const Edge& e) {
        if (e[0] != reached[k] && e[1] != reached[k]) return false;
        reached.push_back(e[0] == reached[k] ? e[1] : e[0]);
        return true;
      });
    }
    require(open.empty() && std::find(reached.begin(), reached.end(), c.ends[1]) != reached.end(),
            "a constraint in pieces");
    const Point2 a = t.point(c.ends[0]), b = t.point(c.ends[1]);
    for (const DelaunayVertex v : reached) {
      const Point2 p = t.point(v);
      require(std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
                  p.y <= std::max(a.y, b.y),
              "a constraint leaves its box");
    }
  }

  void locate() {
    const Point2 p = points_.next();
    const Location2 found = fine_value(made_.locate(p, any_handle()));
    std::vector<DelaunayVertex> simplex;
    if (const Vertex* known = at(p)) {
      simplex = {known->handle};
    } else if (made_.dimension() < 2) {
      for (const Edge& e : made_.edges()) {
        if (is_between(p, made_.point(e[0]), made_.point(e[1]))) simplex = {e[0], e[1]};
      }
    } else {
      simplex = simplex_of_plane(p);
    }
    constexpr std::array kinds{LocationKind::outside, LocationKind::vertex, LocationKind::edge,
                               LocationKind::facet};
    require(found.kind == kinds[simplex.size()], "a simplex of another kind is found");
    const bool in_triangle = made_.dimension() == 2 && !simplex.empty();
    require(found.triangle.valid() == in_triangle, "a triangle is found, or is not");
    if (in_triangle) {
      const auto v = made_.vertices(found.triangle);
      for (const DelaunayVertex s : simplex) {
        require(std::find(v.begin(), v.end(), s) != v.end(), "a triangle without the simplex");
      }
    }
    simplex.resize(3);
    require(std::equal(simplex.begin(), simplex.end(), found.vertices.begin()), "another simplex");
  }
  // The corners that have a part in p, of any triangle that holds it.
  [[nodiscard]] std::vector<DelaunayVertex> simplex_of_plane(const Point2& p) const {
    for (const TriangleId t : made_.triangles()) {
      const auto v = made_.vertices(t);
      std::vector<DelaunayVertex> simplex;
      bool holds = true;
      for (std::size_t i = 0; i < 3 && holds; ++i) {
        const Sign s = orient2d(made_.point(v[(i + 1) % 3]), made_.point(v[(i + 2) % 3]), p);
        holds = s != Sign::negative;
        if (s != Sign::zero) simplex.push_back(v[i]);
      }
      if (!holds) continue;
      std::sort(simplex.begin(), simplex.end());
      return simplex;
    }
    return {};
  }

  void ask_inside() const {
    const Result<std::vector<TriangleId>> inside = made_.inside();
    if (!inside) {
      require_clean(inside.error());
    } else {
      require(std::is_sorted(inside->begin(), inside->end()), "triangles in no order");
    }
    // How often one that was divided goes over an edge is not told.
    if (!std::all_of(constraints_.begin(), constraints_.end(),
                     [](const Constraint& c) { return c.straight; })) {
      return;
    }
    const PlaneOracle oracle(made_);
    require(inside.ok() == !oracle.has_loose_end(), "insides are told, or are not");
    if (inside) oracle.require_inside(*inside);
  }

  // What is done to a copy is not done to the other one; bytes become the same again.
  void copy() {
    DelaunayTriangulation2 other = made_;
    (void)fine_value(other.insert(points_.next(), any_handle()));
    for (const Constraint& c : constraints_) require(other.remove_constraint(c.id).ok(), "a copy");
    PlaneOracle(other).require_all();
    compare(made_);
    other = made_;
    swap(made_, other);
    made_ = std::move(other);
    const std::vector<std::byte> bytes = fine_value(made_.serialise());
    made_ = fine_value(DelaunayTriangulation2::deserialise(bytes));
    require(fine_value(made_.serialise()) == bytes, "bytes change on their way");
    require(fine_value(made_.snapshot()).vertex.size() == live_.size(), "a snapshot");
  }

  std::vector<Constraint> constraints_;
};

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft::fuzz;
  Bytes bytes(data, size);
  HistoryOfPlane history(bytes);
  for (std::size_t k = 0; k < kMostOperations && !bytes.empty() && !history.is_large(); ++k) {
    history.operate();
  }
  return 0;
}
