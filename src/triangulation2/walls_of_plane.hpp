// Which constraints go over which edges.
//
// An edge that a constraint goes over twice, as pieces that were rounded may, has it twice. Walls
// stand in an array, in no order that means anything, and are found by their edges in a table of
// open addressing: where a wall hashes to, or in the first places behind, as far as these are
// taken.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/ids.hpp>

namespace tetloft::internal::triangulation2 {

/// An edge, by increasing id, and the constraints over it: at least one.
class PlaneWall {
 public:
  using Edge = std::array<VertexId, 2>;
  [[nodiscard]] static Edge edge_of(VertexId a, VertexId b) {
    return a < b ? Edge{a, b} : Edge{b, a};
  }

  /// `constraints` is not empty.
  PlaneWall(const Edge& edge, std::vector<ConstraintId> constraints);
  /// No memory is needed.
  PlaneWall(const Edge& edge, ConstraintId constraint) : edge_(edge), lowest_(constraint) {}

  [[nodiscard]] const Edge& edge() const { return edge_; }
  [[nodiscard]] std::size_t count() const { return 1 + others_.size(); }
  [[nodiscard]] ConstraintId lowest() const { return lowest_; }
  [[nodiscard]] bool has(ConstraintId c) const {
    return c == lowest_ || std::binary_search(others_.begin(), others_.end(), c);
  }
  /// By id.
  [[nodiscard]] std::vector<ConstraintId> constraints() const;

 private:
  friend class Walls;
  Edge edge_;
  ConstraintId lowest_;
  std::vector<ConstraintId> others_;  // by id; of most edges there are none
};

class Walls {
 public:
  /// The halves of a wall that a vertex is about to divide; none where there is no such wall.
  struct Division {
    PlaneWall::Edge whole;
    std::vector<PlaneWall> halves;
  };

  [[nodiscard]] bool empty() const { return walls_.empty(); }
  /// Each once.
  [[nodiscard]] std::span<const PlaneWall> all() const { return walls_; }
  /// Null where a b is no wall.
  [[nodiscard]] const PlaneWall* find(VertexId a, VertexId b) const {
    return walls_.empty() ? nullptr : found(slot_of(PlaneWall::edge_of(a, b)));
  }

  /// If memory ends, nothing has happened.
  void add(VertexId a, VertexId b, std::span<const ConstraintId> constraints);
  /// Requires that the constraint goes over a b, maybe several times. True where none is left.
  bool take(VertexId a, VertexId b, ConstraintId c) noexcept;
  /// Requires that a b is a wall.
  void remove(VertexId a, VertexId b) noexcept;

  /// Requires that a b is a wall; divide() follows before anything else comes.
  [[nodiscard]] Division prepare(VertexId a, VertexId b, VertexId middle);
  /// Does nothing where nothing was prepared.
  void divide(Division& division) noexcept;
  /// The edge to a vertex w is one to v from now on.
  void rename(VertexId w, VertexId v, VertexId other) noexcept;

 private:
  static constexpr std::uint32_t kFree = 0xFFFFFFFFU;
  [[nodiscard]] std::size_t home_of(const PlaneWall::Edge& edge) const;
  /// The slot that has the wall, or the free one where it would be.
  [[nodiscard]] std::size_t slot_of(const PlaneWall::Edge& edge) const;
  [[nodiscard]] const PlaneWall* found(std::size_t slot) const {
    return table_[slot] == kFree ? nullptr : &walls_[table_[slot]];
  }
  void provide_room_for_one();
  void append(PlaneWall wall) noexcept;
  void free_slot(std::size_t slot) noexcept;

  std::vector<PlaneWall> walls_;
  std::vector<std::uint32_t> table_;  // places in walls_, or kFree; of 2^k at most half are taken
};

}  // namespace tetloft::internal::triangulation2
