// A 3D Delaunay triangulation while points are inserted: its memory, shared by all who insert.
//
// Laid out for the search of the conflict zone, which is most of the work: a tet's vertices and
// neighbours lie side by side, as many bytes as half a cache line, so do a point, its number on the
// horizon and its part.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

#include "delaunay3/tet_slot.hpp"
#include "predicates/set_filter.hpp"

namespace tetloft::internal::delaunay3_detail {

/// The vertex at infinity. In a ghost tet it is vertex 0, always.
inline constexpr VertexId kGhost{0xFFFFFFFEU};

/// One of the parts that the vertices are shared out to while several threads insert.
using Part = std::uint16_t;
static_assert(kMostThreads <= std::numeric_limits<Part>::max());

/// Gives back memory for slots as std::allocator hands it out: not initialised.
struct FreeSlots {
  std::size_t capacity = 0;
  void operator()(TetSlot* slots) const { std::allocator<TetSlot>().deallocate(slots, capacity); }
};

/// Slots that go from one owner to another.
struct OwnedSlots {
  std::unique_ptr<TetSlot[], FreeSlots> slots;
  std::size_t taken = 0;
  [[nodiscard]] std::span<TetSlot> all() { return {slots.get(), taken}; }
};

class GrowingTets {
 public:
  /// What an insertion knows of a tet. Between insertions all are unvisited. A visited one has
  /// 2 − (whether it is in conflict).
  enum class Mark : std::uint8_t { unvisited = 0, in_conflict = 1, outside = 2 };

  struct Vertex {
    Point3 point;
    /// Its place in canonical order, where vertices are ranked.
    std::uint32_t rank = 0;
    Part part = 0;
    /// The number among the vertices of the current horizon: a guess left by some earlier insertion
    /// wherever that horizon does not confirm it, so that nothing needs to be cleared.
    std::uint8_t on_horizon = 0;
  };

  /// Points of uniform distribution have 6.77 tets each (Dwyer, DCG 6, 1991); hull and recycled
  /// slots come on top.
  static constexpr std::size_t kExpectedTetsOfPoint = 7;

  /// Vertex i is points[order[i]]; points are in canonical order. With room for so many tets of
  /// each.
  GrowingTets(std::span<const Point3> points, std::span<const std::uint32_t> order,
              std::size_t tets_of_point, unsigned threads);
  /// Without vertices, which come one by one then and have no ranks.
  GrowingTets() = default;
  GrowingTets(const GrowingTets& other);
  GrowingTets& operator=(const GrowingTets&) = delete;

  /// Lets go of the slots: there are no tets then.
  [[nodiscard]] OwnedSlots release_slots();
  /// Takes slots as another one has filled them, in place of its own. `filter` is that of a set
  /// that has all vertices. Where it throws everything is as it was.
  void take_over(OwnedSlots slots, const predicates::SetFilter& filter);
  /// Takes a vertex without a rank. It is in no tet.
  VertexId add_vertex(const Point3& point);
  /// Gives the place of a vertex that is in no tet to another one.
  void replace_vertex(VertexId v, const Point3& point);
  /// Drops all vertices and tets, and keeps the memory. `filter` is that of a set that has all
  /// vertices to come.
  void start_again(const predicates::SetFilter& filter);
  /// After an insertion that failed halfway, with no slot written yet.
  void unmark_all();
  /// Whether vertices have ranks.
  [[nodiscard]] bool is_ranked() const { return is_ranked_; }

  void reserve_vertices(std::size_t count) { vertices_.reserve(count); }
  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }
  [[nodiscard]] Vertex& vertex(VertexId v) { return vertices_[v.index()]; }
  [[nodiscard]] const Vertex& vertex(VertexId v) const { return vertices_[v.index()]; }
  [[nodiscard]] const Point3& point(VertexId v) const { return vertex(v).point; }
  [[nodiscard]] const predicates::SetFilter& filter() const { return filter_; }

  /// Of the slots taken, what is in them: positive tets; ghost tets would be with the ghost far
  /// beyond their hull facet. Vertex 3 is the latest. A slot just taken holds anything.
  [[nodiscard]] TetSlot& slot(TetId t) { return slots_[t.index()]; }
  [[nodiscard]] const TetSlot& slot(TetId t) const { return slots_[t.index()]; }
  [[nodiscard]] const TetVertices& tet(TetId t) const { return slot(t).vertices; }
  [[nodiscard]] bool is_ghost(TetId t) const { return tet(t)[0] == kGhost; }
  [[nodiscard]] HalfFaceId& opposite(HalfFaceId h) {
    return slots_[h.index() >> 2].opposite[h.index() & 3];
  }
  [[nodiscard]] HalfFaceId opposite(HalfFaceId h) const {
    return slots_[h.index() >> 2].opposite[h.index() & 3];
  }
  void glue(HalfFaceId a, HalfFaceId b) {
    opposite(a) = b;
    opposite(b) = a;
  }
  /// Apart from the slots: one cache line of marks answers for many tets that were made together,
  /// most of them visited before.
  [[nodiscard]] Mark& mark(TetId t) { return marks_[t.index()]; }
  [[nodiscard]] const Mark& mark(TetId t) const { return marks_[t.index()]; }

  /// Slots taken so far.
  [[nodiscard]] std::size_t taken() const { return taken_.load(std::memory_order_relaxed); }
  /// Takes `count` slots in a row, and returns the first; more room is made where there is not
  /// enough, which moves all slots: for one thread alone.
  std::size_t take(std::size_t count);
  /// The same for several threads at once, each for itself. False where there is not enough room.
  bool take_of_room(std::size_t count, std::size_t& first);
  /// Makes room for so many slots more.
  void reserve(std::size_t more);

  /// All slots taken.
  [[nodiscard]] std::span<TetSlot> slots() { return {slots_.get(), taken()}; }
  /// Frees all but the slots.
  void keep_slots_only();

 private:
  std::vector<Vertex> vertices_;
  predicates::SetFilter filter_;
  bool is_ranked_ = false;
  // Not initialised beyond what was taken: pages that are never used take no memory, and the
  // others come where the thread is that writes them first.
  std::unique_ptr<TetSlot[], FreeSlots> slots_;
  std::vector<Mark> marks_;  // as many as there is room for slots
  std::atomic<std::size_t> taken_ = 0;
};

}  // namespace tetloft::internal::delaunay3_detail
