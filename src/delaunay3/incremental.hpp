// Incremental 3D Delaunay triangulation, on one thread or several.
//
// Invariant between insertions: the live tets are the Delaunay triangulation, under the
// symbolic perturbation of insphere_perturbed, of the vertices inserted so far, closed by
// ghost tets: each facet of the convex hull is joined to the ghost vertex, a point at
// infinity. Combinatorially the tets form a 3-sphere, so every face has two tets and no
// traversal has a boundary branch.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "core/watched_work.hpp"
#include "delaunay3/growing_tets.hpp"
#include "delaunay3/insertion.hpp"
#include "delaunay3/partition.hpp"
#include "delaunay3/shares.hpp"

namespace tetloft::internal::delaunay3_detail {

/// When points are shared out to threads.
struct Sharing {
  unsigned threads = 1;
  /// So many points to each thread at least. With fewer the parts are all border: a cavity is some
  /// 3 tets wide, a part of 1,000 points 10.
  std::size_t least_points = 1000;
  /// Slots that there is room for with every point that threads are to insert. Where they need
  /// more, they come back for it.
  std::size_t room_of_point = 6;
};

class Delaunay3Builder {
 public:
  static constexpr std::size_t kPointsOfStep = 1024;

  /// Vertex i is points[order[i]]. Requires: distinct finite points in canonical order, each once
  /// in `order`, of which the first four are affinely independent; fewer than 2^30 points. There is
  /// room for `tets_of_point` of each at first.
  Delaunay3Builder(std::span<const Point3> points, std::span<const std::uint32_t> order,
                   const Sharing& sharing = {},
                   std::size_t tets_of_point = GrowingTets::kExpectedTetsOfPoint);

  /// Inserts all vertices, once: in order, or, where they are shared out, roughly. The tets are the
  /// same. Returns false, leaving the triangulation without some vertices, where it would take more
  /// than `most_tets` slots, ghost tets included; these are fewer than 2^30, since half-faces are
  /// 4 t + i in 32 bits. Tells a step for every kPointsOfStep vertices.
  [[nodiscard]] bool insert_all(WatchedWork& work, std::size_t most_tets = kMostTetSlots);

  /// How many vertices threads inserted side by side.
  [[nodiscard]] std::size_t inserted_within_parts() const { return inserted_within_parts_; }

  /// All slots: of ghost tets vertex 0 is kGhost, of dead ones it is invalid. Valid after
  /// insert_all().
  [[nodiscard]] std::span<TetSlot> slots() { return tets_.slots(); }
  [[nodiscard]] OwnedSlots release_slots() { return tets_.release_slots(); }

 private:
  // Inserts vertices one by one. False where out of slots.
  bool insert_alone(std::span<const VertexId> vertices);
  // Inserts the vertices from `first` to `end`, on all threads as long as that pays.
  bool insert_round(std::size_t first, std::size_t end);
  // How many parts are worth making, of all vertices up to `end`, where `left` are to be inserted.
  [[nodiscard]] std::size_t worthwhile_parts(std::size_t end, std::size_t left) const;
  [[nodiscard]] Partition cut(std::span<const VertexId> vertices, std::size_t parts,
                              Cuts cuts) const;
  // Inserts those of the vertices that lie well within the parts, a thread to each; returns the
  // others, in order.
  std::vector<VertexId> insert_within_parts(std::span<const VertexId> vertices,
                                            const Shares& shares);
  // Lets the thread of a part start in it, if a tet of it is found among the first few tries.
  void find_start(std::span<const VertexId> share, Part part);
  // One thread's. What it does not insert goes to `left`. Returns how many it inserted since it
  // told the last step.
  std::size_t insert_share(std::span<const VertexId> share, Part part, std::vector<VertexId>& left);
  void count_steps(std::size_t inserted);

  GrowingTets tets_;
  Inserter alone_;
  std::vector<Inserter> within_;  // by part
  WatchedWork* work_ = nullptr;
  std::size_t most_tets_ = 0;
  Sharing sharing_;
  // Vertices inserted since the last step was told.
  std::size_t untold_ = 0;
  std::size_t inserted_within_parts_ = 0;
  // A thread threw: the others need not go on.
  std::atomic<bool> failed_ = false;
};

}  // namespace tetloft::internal::delaunay3_detail
