// A Delaunay triangulation of points in the plane to work with: insert, remove, move, locate,
// neighbours.
//
// Whatever was done to it, it is the unique triangulation of the symbolically perturbed predicates
// (predicates.hpp) of the points that are in it: that of delaunay2(). Points may be few, in a row,
// on a circle, on a grid, and come twice. Where they are in a row there are no triangles; edges
// join each point to the next, and all questions have answers.
//
// Constraints are segments between vertices that are to be unions of edges. With them it is the
// constrained Delaunay triangulation, unique too: no vertex that can be seen from inside a
// triangle, past no constraint, is in the triangle's perturbed circle. No vertex is put on a
// constraint but where two cross and Crossing::split is asked for.
//
// Triangles are named by slots, some of which are empty: a TriangleId below triangle_slots(), good
// until the next change; they are counter-clockwise. Vertices are named by handles
// (delaunay_vertex.hpp), good until the vertex is removed.
//
// Functions that return a Result refuse (invalid_input) points that are not finite, vertices that
// are gone, and leave everything as it was; others throw std::out_of_range for what is not there
// (result.hpp). `near` is a vertex to start a search at; without one, or if it is gone, the search
// finds a start of its own. Const functions may be called from several threads at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/live_range.hpp>
#include <tetloft/location_kind.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

struct Location2 {
  LocationKind kind = LocationKind::outside;
  /// The vertices of that simplex by increasing index, then none: one of a vertex, two of an edge …
  std::array<DelaunayVertex, 3> vertices{};
  /// A triangle that has it; invalid outside, and where there are no triangles.
  TriangleId triangle{};
};

/// What the insertion of a point would change; empty where it is a vertex already, or there are no
/// triangles.
struct ConflictZone2 {
  /// The triangles that would go, by id: those whose perturbed circles hold the point, as far as it
  /// can be seen from them, past no constraint but one that it lies on.
  std::vector<TriangleId> triangles;
  /// The edges that the point would be joined to, each to become a triangle with it: one behind the
  /// other, counter-clockwise around the point, from the vertex of lowest index; where the point
  /// lies outside or on the hull, from one end to the other.
  std::vector<std::array<DelaunayVertex, 2>> horizon;
  /// The vertices that would be its neighbours, by index.
  std::vector<DelaunayVertex> neighbours;
};

/// A constraint; not given again when it is removed.
using ConstraintId = Id<struct ConstraintTag>;

/// What becomes of a constraint that crosses others.
enum class Crossing : std::uint8_t {
  refuse,  ///< it is refused
  split,   ///< a vertex is put where they cross, and all of them go over it
};

/// A triangulation as values, numbered canonically.
struct DelaunaySnapshot2 {
  IdVector<PlaneVertexId, DelaunayVertex> vertex;  ///< by increasing index: whose the points are
  Triangulation2 triangulation;                    ///< as delaunay2() of the points has it
  int dimension = -1;
};

class TETLOFT_API DelaunayTriangulation2 {
 public:
  /// Without points.
  DelaunayTriangulation2();
  DelaunayTriangulation2(const DelaunayTriangulation2& other);
  /// Leaves the other one without points.
  DelaunayTriangulation2(DelaunayTriangulation2&& other) noexcept;
  DelaunayTriangulation2& operator=(const DelaunayTriangulation2& other);
  DelaunayTriangulation2& operator=(DelaunayTriangulation2&& other) noexcept;
  ~DelaunayTriangulation2();
  friend TETLOFT_API void swap(DelaunayTriangulation2& a, DelaunayTriangulation2& b) noexcept;

  /// Of many points at once, as delaunay2() makes it. The vertex of points[i] has index i and
  /// generation 0; of equal points the first has the vertex, and the places of the others are free.
  [[nodiscard]] static Result<DelaunayTriangulation2> of(std::span<const Point2> points,
                                                         const Execution& execution = {});

  // Changes. They are for one thread, with nobody else looking. A handle stays good, all
  // TriangleIds end.

  struct Insertion {
    DelaunayVertex vertex;
    bool is_new = true;  ///< false: the point had a vertex
  };
  /// Adds a point.
  [[nodiscard]] Result<Insertion> insert(const Point2& point, DelaunayVertex near = {});
  /// Adds points in an order that is fast; result[i] is the vertex of points[i].
  [[nodiscard]] Result<std::vector<DelaunayVertex>> insert(std::span<const Point2> points,
                                                           const Execution& execution = {});
  /// Refused, naming the constraint, for a vertex that one goes over.
  [[nodiscard]] Result<void> remove(DelaunayVertex v);
  /// Puts v elsewhere; it keeps its handle. Refused where another vertex is, and for a vertex that
  /// a constraint goes over.
  [[nodiscard]] Result<void> move(DelaunayVertex v, const Point2& to);
  void clear();

  // Constraints. They go over all vertices on them, those that come later too; where they overlap
  // they share edges.

  /// Makes the segment u v a union of edges. Where it crosses a constraint it is refused
  /// (invalid_input, naming the other one, where.point about where), or the crossing point,
  /// rounded, is inserted, if it is no vertex yet, and both go over it: that bends them by ulps. An
  /// end that the other one passes within rounding is taken for it. Bent pieces that cross others
  /// are divided in turn, at most 2^16 times (work_limit; nothing has happened then). Splitting
  /// takes a copy of everything, once for each constraint that crosses: for many there is
  /// insert_constraints().
  [[nodiscard]] Result<ConstraintId> insert_constraint(DelaunayVertex u, DelaunayVertex v,
                                                       Crossing crossing = Crossing::refuse);
  /// Many, one after the other, on one copy of everything; result[i] is that of segments[i]. If one
  /// is refused none is inserted; the message names it by its index.
  [[nodiscard]] Result<std::vector<ConstraintId>> insert_constraints(
      std::span<const std::array<DelaunayVertex, 2>> segments,
      Crossing crossing = Crossing::refuse);
  /// Its vertices stay.
  [[nodiscard]] Result<void> remove_constraint(ConstraintId c);
  [[nodiscard]] bool is_live(ConstraintId c) const;
  [[nodiscard]] std::size_t constraint_count() const;
  /// By increasing id.
  [[nodiscard]] std::vector<ConstraintId> constraints() const;
  /// The constraints over the edge u v, by id; none where there is no such edge.
  [[nodiscard]] std::vector<ConstraintId> constraints(DelaunayVertex u, DelaunayVertex v) const;
  /// The vertices it was given.
  [[nodiscard]] std::array<DelaunayVertex, 2> ends(ConstraintId c) const;
  /// The edges it goes over, each by increasing index, sorted.
  [[nodiscard]] std::vector<std::array<DelaunayVertex, 2>> edges(ConstraintId c) const;
  /// The triangles that one comes to from outside across an odd number of constraints, by id: of
  /// an outline and those of its holes what is between. Refused (invalid_input, naming a vertex)
  /// where constraints end: an odd number of them leaves a vertex.
  [[nodiscard]] Result<std::vector<TriangleId>> inside() const;

  // What is there.

  /// −1 without points, 0 of one, 1 of points in a row, 2.
  [[nodiscard]] int dimension() const;
  [[nodiscard]] std::size_t vertex_count() const;
  /// All indices are below.
  [[nodiscard]] std::size_t vertex_slots() const;
  [[nodiscard]] std::size_t triangle_count() const;
  [[nodiscard]] std::size_t triangle_slots() const;
  [[nodiscard]] bool is_live(DelaunayVertex v) const;
  [[nodiscard]] bool is_live(TriangleId t) const;
  /// The vertex in a place below vertex_slots(), the triangle in one below triangle_slots(); or
  /// none.
  [[nodiscard]] DelaunayVertex vertex_at(std::size_t index) const;
  [[nodiscard]] TriangleId triangle_at(std::size_t slot) const;
  [[nodiscard]] const Point2& point(DelaunayVertex v) const;
  /// Counter-clockwise.
  [[nodiscard]] std::array<DelaunayVertex, 3> vertices(TriangleId t) const;
  /// [i]: the triangle across the edge opposite vertex i, or invalid on the hull.
  [[nodiscard]] std::array<TriangleId, 3> neighbours(TriangleId t) const;

  /// The live vertices by increasing index, and the triangles by id: forward ranges, as algorithms
  /// of C++20 take them, good until the next change.
  [[nodiscard]] LiveRange<DelaunayTriangulation2, DelaunayVertex> vertices() const;
  [[nodiscard]] LiveRange<DelaunayTriangulation2, TriangleId> triangles() const;
  /// All edges, each by increasing index, sorted.
  [[nodiscard]] std::vector<std::array<DelaunayVertex, 2>> edges() const;
  /// The vertices on the hull, counter-clockwise from that of lowest index; of points in a row all
  /// of them, from one end to the other.
  [[nodiscard]] std::vector<DelaunayVertex> hull() const;

  [[nodiscard]] std::vector<TriangleId> star(DelaunayVertex v) const;            ///< by id
  [[nodiscard]] std::vector<DelaunayVertex> neighbours(DelaunayVertex v) const;  ///< by index
  /// The triangles on the left and on the right of the edge from u to v: invalid on the hull, and
  /// both of them where u and v are not joined.
  [[nodiscard]] std::array<TriangleId, 2> triangles(DelaunayVertex u, DelaunayVertex v) const;
  /// Always where there are no triangles.
  [[nodiscard]] bool is_on_hull(DelaunayVertex v) const;

  // Questions.

  [[nodiscard]] Result<Location2> locate(const Point2& point, DelaunayVertex near = {}) const;
  /// Of many points, on several threads and in an order that is fast: result[i] is of points[i].
  [[nodiscard]] Result<std::vector<Location2>> locate(std::span<const Point2> points,
                                                      const Execution& execution = {}) const;
  /// The nearest vertex, by exact comparison, of equally near ones that of lowest index; none of no
  /// points.
  [[nodiscard]] Result<DelaunayVertex> nearest_vertex(const Point2& point,
                                                      DelaunayVertex near = {}) const;
  /// Of many points, as locate() is.
  [[nodiscard]] Result<std::vector<DelaunayVertex>> nearest_vertex(
      std::span<const Point2> points, const Execution& execution = {}) const;
  /// The k nearest, or all there are, by distance, then by index.
  [[nodiscard]] Result<std::vector<DelaunayVertex>> nearest_vertices(
      const Point2& point, std::size_t k, DelaunayVertex near = {}) const;
  /// All at most so far away, exactly, by distance, then by index. Refused where the radius is
  /// negative or not a number.
  [[nodiscard]] Result<std::vector<DelaunayVertex>> vertices_within(const Point2& centre,
                                                                    double radius,
                                                                    DelaunayVertex near = {}) const;
  [[nodiscard]] Result<ConflictZone2> conflict_zone(const Point2& point,
                                                    DelaunayVertex near = {}) const;

  // As values.

  /// Without constraints.
  [[nodiscard]] Result<DelaunaySnapshot2> snapshot(const Execution& execution = {}) const;
  /// As bytes, the same on every machine. What is made of them has the same handles and the same
  /// constraints, over the same edges.
  [[nodiscard]] Result<std::vector<std::byte>> serialise() const;
  /// Refused (invalid_input) where the bytes are none of serialise(), or damaged.
  [[nodiscard]] static Result<DelaunayTriangulation2> deserialise(std::span<const std::byte> bytes);

 private:
  class Impl;
  friend class LiveRange<DelaunayTriangulation2, DelaunayVertex>;
  friend class LiveRange<DelaunayTriangulation2, TriangleId>;
  [[nodiscard]] DelaunayVertex item_at(std::size_t at, DelaunayVertex) const {
    return vertex_at(at);
  }
  [[nodiscard]] TriangleId item_at(std::size_t at, TriangleId) const { return triangle_at(at); }
  [[nodiscard]] std::size_t places(DelaunayVertex) const { return vertex_slots(); }
  [[nodiscard]] std::size_t places(TriangleId) const { return triangle_slots(); }
  [[nodiscard]] const Impl& get() const;
  [[nodiscard]] Impl& own();

  std::unique_ptr<Impl> impl_;  // none: without points
};

}  // namespace tetloft
