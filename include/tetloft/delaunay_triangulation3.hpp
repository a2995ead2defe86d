// A Delaunay triangulation of points in space to work with: insert, remove, move, locate,
// neighbours.
//
// Whatever was done to it, it is the unique triangulation of the symbolically perturbed predicates
// (predicates.hpp) of the points that are in it: that of delaunay3(). Points may be few, in a row,
// in a plane, on a sphere, on a grid, and come twice. Where they do not span space there are no
// tets; edges and, of points in a plane, facets are those of the perturbed triangulation of the
// line or plane, and all questions have answers.
//
// Tets are named by slots, some of which are empty: a TetId below tet_slots(), good until the next
// change. Half-face 4 t + i is that of tet t opposite its vertex i; tets are positive, as in
// TetMesh. Vertices are named by handles (delaunay_vertex.hpp), good until the vertex is removed.
//
// Functions that return a Result refuse (invalid_input) points that are not finite, vertices that
// are gone and ids of no tet, and leave everything as it was; others throw std::out_of_range there
// (result.hpp). `near` is a vertex to start a search at; without one, or if it is gone, the search
// finds a start of its own. Const functions may be called from several threads at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/live_range.hpp>
#include <tetloft/location_kind.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft {

struct Location3 {
  LocationKind kind = LocationKind::outside;
  /// The vertices of that simplex by increasing index, then none: one of a vertex, two of an edge …
  std::array<DelaunayVertex, 4> vertices{};
  /// A tet that has it; invalid outside, and where there are no tets.
  TetId tet{};
};

/// What the insertion of a point would change; empty where it is a vertex already, or there are no
/// tets.
struct ConflictZone3 {
  /// The tets that would go, whose perturbed spheres hold the point, by id.
  std::vector<TetId> tets;
  /// The faces that the point would be joined to, as half-faces of tets, by id: of one of `tets` on
  /// the inside; of another one on the outside, which is a facet of the hull that the point sees.
  std::vector<HalfFaceId> horizon;
  /// The vertices that would be its neighbours, by index.
  std::vector<DelaunayVertex> neighbours;
};

/// The tets around an edge in order, each a neighbour of the next; `closed` where the last is a
/// neighbour of the first, which it is not on the hull.
struct EdgeRing {
  std::vector<TetId> tets;
  bool closed = false;
};

/// A triangulation as values, numbered canonically.
struct DelaunaySnapshot3 {
  IdVector<VertexId, Point3> points;          ///< of the live vertices, by increasing index
  IdVector<VertexId, DelaunayVertex> vertex;  ///< whose they are
  TetMesh mesh;                               ///< as delaunay3() of `points` has it
  int dimension = -1;
};

class TETLOFT_API DelaunayTriangulation3 {
 public:
  /// Without points.
  DelaunayTriangulation3();
  DelaunayTriangulation3(const DelaunayTriangulation3& other);
  /// Leaves the other one without points.
  DelaunayTriangulation3(DelaunayTriangulation3&& other) noexcept;
  DelaunayTriangulation3& operator=(const DelaunayTriangulation3& other);
  DelaunayTriangulation3& operator=(DelaunayTriangulation3&& other) noexcept;
  ~DelaunayTriangulation3();
  friend TETLOFT_API void swap(DelaunayTriangulation3& a, DelaunayTriangulation3& b) noexcept;

  /// Of many points at once, by the engine of delaunay3() on several threads. The vertex of
  /// points[i] has index i and generation 0; of equal points the first has the vertex, and the
  /// places of the others are free.
  [[nodiscard]] static Result<DelaunayTriangulation3> of(std::span<const Point3> points,
                                                         const Execution& execution = {});

  // Changes. They are for one thread, with nobody else looking. A handle stays good, all TetIds
  // end.

  struct Insertion {
    DelaunayVertex vertex;
    bool is_new = true;  ///< false: the point had a vertex
  };
  /// Adds a point.
  [[nodiscard]] Result<Insertion> insert(const Point3& point, DelaunayVertex near = {});
  /// Adds points in an order that is fast; result[i] is the vertex of points[i].
  [[nodiscard]] Result<std::vector<DelaunayVertex>> insert(std::span<const Point3> points,
                                                           const Execution& execution = {});
  [[nodiscard]] Result<void> remove(DelaunayVertex v);
  /// Puts v elsewhere; it keeps its handle. Refused where another vertex is.
  [[nodiscard]] Result<void> move(DelaunayVertex v, const Point3& to);
  void clear();

  // What is there.

  /// As Delaunay3 has it.
  [[nodiscard]] int dimension() const;
  [[nodiscard]] std::size_t vertex_count() const;
  /// All indices are below.
  [[nodiscard]] std::size_t vertex_slots() const;
  [[nodiscard]] std::size_t tet_count() const;
  [[nodiscard]] std::size_t tet_slots() const;
  [[nodiscard]] bool is_live(DelaunayVertex v) const;
  [[nodiscard]] bool is_live(TetId t) const;
  /// The vertex in a place below vertex_slots(), the tet in one below tet_slots(); or none.
  [[nodiscard]] DelaunayVertex vertex_at(std::size_t index) const;
  [[nodiscard]] TetId tet_at(std::size_t slot) const;
  [[nodiscard]] const Point3& point(DelaunayVertex v) const;
  [[nodiscard]] std::array<DelaunayVertex, 4> vertices(TetId t) const;
  /// The three vertices of a half-face, counter-clockwise as seen from outside its tet.
  [[nodiscard]] std::array<DelaunayVertex, 3> vertices(HalfFaceId h) const;
  /// The same face as seen from the tet across, or invalid on the hull.
  [[nodiscard]] HalfFaceId opposite(HalfFaceId h) const;

  /// The live vertices by increasing index, and the tets by id: forward ranges, as algorithms of
  /// C++20 take them, good until the next change.
  [[nodiscard]] LiveRange<DelaunayTriangulation3, DelaunayVertex> vertices() const;
  [[nodiscard]] LiveRange<DelaunayTriangulation3, TetId> tets() const;
  /// All edges, each by increasing index, sorted; facets likewise.
  [[nodiscard]] std::vector<std::array<DelaunayVertex, 2>> edges() const;
  [[nodiscard]] std::vector<std::array<DelaunayVertex, 3>> facets() const;
  /// The half-faces on the hull, by id.
  [[nodiscard]] std::vector<HalfFaceId> hull() const;

  [[nodiscard]] std::vector<TetId> star(DelaunayVertex v) const;                 ///< by id
  [[nodiscard]] std::vector<DelaunayVertex> neighbours(DelaunayVertex v) const;  ///< by index
  [[nodiscard]] bool is_on_hull(DelaunayVertex v) const;
  /// Empty where u and v are not joined.
  [[nodiscard]] EdgeRing ring(DelaunayVertex u, DelaunayVertex v) const;

  // Questions.

  [[nodiscard]] Result<Location3> locate(const Point3& point, DelaunayVertex near = {}) const;
  /// Of many points, on several threads and in an order that is fast: result[i] is of points[i].
  [[nodiscard]] Result<std::vector<Location3>> locate(std::span<const Point3> points,
                                                      const Execution& execution = {}) const;
  /// The nearest vertex, by exact comparison, of equally near ones that of lowest index; none of no
  /// points.
  [[nodiscard]] Result<DelaunayVertex> nearest_vertex(const Point3& point,
                                                      DelaunayVertex near = {}) const;
  /// Of many points, as locate() is.
  [[nodiscard]] Result<std::vector<DelaunayVertex>> nearest_vertex(
      std::span<const Point3> points, const Execution& execution = {}) const;
  /// The k nearest, or all there are, by distance, then by index.
  [[nodiscard]] Result<std::vector<DelaunayVertex>> nearest_vertices(
      const Point3& point, std::size_t k, DelaunayVertex near = {}) const;
  /// All at most so far away, exactly, by distance, then by index. Refused where the radius is
  /// negative or not a number.
  [[nodiscard]] Result<std::vector<DelaunayVertex>> vertices_within(const Point3& centre,
                                                                    double radius,
                                                                    DelaunayVertex near = {}) const;
  [[nodiscard]] Result<ConflictZone3> conflict_zone(const Point3& point,
                                                    DelaunayVertex near = {}) const;

  // As values.

  [[nodiscard]] Result<DelaunaySnapshot3> snapshot(const Execution& execution = {}) const;
  /// As bytes, the same on every machine. What is made of them has the same handles.
  [[nodiscard]] Result<std::vector<std::byte>> serialise() const;
  /// Refused (invalid_input) where the bytes are none of serialise(), or damaged.
  [[nodiscard]] static Result<DelaunayTriangulation3> deserialise(std::span<const std::byte> bytes);

 private:
  class Impl;
  friend class LiveRange<DelaunayTriangulation3, DelaunayVertex>;
  friend class LiveRange<DelaunayTriangulation3, TetId>;
  [[nodiscard]] DelaunayVertex item_at(std::size_t at, DelaunayVertex) const {
    return vertex_at(at);
  }
  [[nodiscard]] TetId item_at(std::size_t at, TetId) const { return tet_at(at); }
  [[nodiscard]] std::size_t places(DelaunayVertex) const { return vertex_slots(); }
  [[nodiscard]] std::size_t places(TetId) const { return tet_slots(); }
  [[nodiscard]] const Impl& get() const;
  [[nodiscard]] Impl& own();

  std::unique_ptr<Impl> impl_;  // none: without points
};

}  // namespace tetloft
